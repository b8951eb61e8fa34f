#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace scanlight::raster {

/// Threads that do pieces of one job at a time and wait in between. The caller is one of them.
/// Invariant: while no job runs, `job_` is empty and all threads but the caller wait.
class Workers {
public:
    /// `count` from 1; 0 is one for each processor.
    explicit Workers(int count = 0);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    int count() const { return static_cast<int>(threads_.size()) + 1; }

    /// Calls `piece(worker, i)` once for each i from 0 to before `pieces`, each on any thread, and
    /// returns when all are done. `worker` is from 0 to before count(), and at no time the same for
    /// two calls. The first exception that a piece throws is thrown again here, when all threads
    /// have come to rest.
    void for_each(std::size_t pieces, const std::function<void(int worker, std::size_t i)>& piece);

private:
    struct Job;
    void wait_for_jobs(int worker);

    std::mutex mutex_;
    std::condition_variable changed_;
    Job* job_ = nullptr;
    std::size_t job_number_ = 0;
    bool stop_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace scanlight::raster
