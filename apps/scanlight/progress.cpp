#include "apps/scanlight/progress.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace scanlight::apps {

Progress::Progress(When when) {
    if (when == When::never || isatty(STDERR_FILENO) != 1) return;
    ticker_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

Progress::~Progress() {
    if (!ticker_.joinable()) return;
    ticker_.request_stop();
    ticker_.join();
}

void Progress::now(const std::string& what) {
    const std::scoped_lock lock(mutex_);
    what_ = what;
}

void Progress::run(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    bool shown = false;
    for (int second = 1; !stop.stop_requested(); ++second) {
        stopped_.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; });
        if (stop.stop_requested()) break;
        std::fprintf(stderr, "\r\033[K%s, %d s", what_.c_str(), second);
        shown = true;
    }
    if (shown) std::fputs("\r\033[K", stderr);
}

}  // namespace scanlight::apps
