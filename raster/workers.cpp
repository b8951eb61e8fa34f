#include "raster/workers.h"

#include <algorithm>
#include <atomic>
#include <exception>

namespace scanlight::raster {

struct Workers::Job {
    const std::function<void(int, std::size_t)>& piece;
    std::size_t pieces;
    std::atomic<std::size_t> next{0};
    int working = 0;           // threads that may still touch the job; under the mutex
    std::exception_ptr error;  // under the mutex

    void work(int worker) {
        for (std::size_t i = next++; i < pieces; i = next++)
            piece(worker, i);
    }
    /// No further piece is begun.
    void abandon() { next = pieces; }
};

namespace {

int thread_count(int wanted) {
    const int processors = static_cast<int>(std::thread::hardware_concurrency());
    return std::clamp(wanted == 0 ? processors : wanted, 1, 256);
}

}  // namespace

Workers::Workers(int count) {
    const int total = thread_count(count);
    for (int worker = 1; worker < total; ++worker)
        threads_.emplace_back([this, worker] { wait_for_jobs(worker); });
}

Workers::~Workers() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    changed_.notify_all();
    for (auto& thread : threads_)
        thread.join();
}

void Workers::for_each(std::size_t pieces, const std::function<void(int, std::size_t)>& piece) {
    Job job{piece, pieces, {}, 0, nullptr};
    const bool shared = pieces > 1 && !threads_.empty();
    if (shared) {
        const std::lock_guard lock(mutex_);
        job_ = &job;
        ++job_number_;
    }
    if (shared) changed_.notify_all();
    try {
        job.work(0);
    } catch (...) {
        job.abandon();
        const std::lock_guard lock(mutex_);
        if (!job.error) job.error = std::current_exception();
    }
    if (shared) {
        std::unique_lock lock(mutex_);
        job_ = nullptr;
        changed_.wait(lock, [&] { return job.working == 0; });
    }
    if (job.error) std::rethrow_exception(job.error);
}

void Workers::wait_for_jobs(int worker) {
    std::size_t seen = 0;
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return stop_ || (job_ != nullptr && job_number_ != seen); });
        if (stop_) return;
        Job& job = *job_;
        seen = job_number_;
        ++job.working;
        lock.unlock();
        std::exception_ptr error;
        try {
            job.work(worker);
        } catch (...) {
            job.abandon();
            error = std::current_exception();
        }
        lock.lock();
        if (error && !job.error) job.error = error;
        if (--job.working == 0) changed_.notify_all();
    }
}

}  // namespace scanlight::raster
