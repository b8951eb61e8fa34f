#include "apps/scanlight/progress.h"

#include <unistd.h>

#include <cstdio>

namespace scanlight::apps {

Progress::Progress(std::string what, std::size_t steps)
    : what_(std::move(what)), steps_(steps), is_terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::step(const std::string& name) {
    constexpr double patience_seconds = 1.0;
    ++done_;
    seconds_ += stopwatch_.lap();
    if (!is_terminal_ || seconds_ < patience_seconds) return;
    std::fprintf(stderr, "\r\033[K%s %zu/%zu %s", what_.c_str(), done_, steps_, name.c_str());
    shown_ = true;
}

void Progress::finish() {
    if (shown_) std::fputs("\r\033[K", stderr);
}

}  // namespace scanlight::apps
