#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace scanlight::apps {

/// A line on standard error that says what is being done and for how long, on a terminal and once
/// the work has taken a second; then it is brought up to date by a thread of its own, so that the
/// work need not care. It is cleared at the end.
class Progress {
public:
    enum class When { on_terminal, never };

    explicit Progress(When when);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// What is being done from now on, such as "loading bunny.obj".
    void now(const std::string& what);

private:
    void run(const std::stop_token& stop);

    std::mutex mutex_;
    std::condition_variable_any stopped_;
    std::string what_;
    std::jthread ticker_;  // the last member: it uses the others
};

}  // namespace scanlight::apps
