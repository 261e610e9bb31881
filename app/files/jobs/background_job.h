#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <optional>
#include <thread>
#include <utility>

#include "app/files/jobs/work_progress.h"
#include "sim/base/stopwatch.h"

namespace kerf::app {

/// Lowers the priority of the calling thread.
void lowerThreadPriority();

/// Work on a separate thread that returns a Result or throws.
template <class Result>
class BackgroundJob {
  public:
    using Work = std::function<Result(WorkProgress&)>;

    explicit BackgroundJob(Work work) : work_(std::move(work)), thread_([this] { run(); }) {}
    /// Cancels the work and waits for its end.
    ~BackgroundJob() {
        progress_.cancel();
        wait();
    }
    BackgroundJob(const BackgroundJob&) = delete;
    BackgroundJob& operator=(const BackgroundJob&) = delete;

    bool done() const { return done_; }
    /// Takes the result once it is done, only once. Throws what the work threw.
    Result take() {
        if (error_) {
            std::rethrow_exception(error_);
        }
        return std::move(*result_);
    }
    std::string stage() const { return progress_.stage(); }
    const WorkProgress& progress() const { return progress_; }
    double seconds() const { return watch_.seconds(); }
    /// Waits until it is done.
    void wait() {
        if (thread_.joinable()) {
            thread_.join();
        }
    }
    /// Makes the work end soon with WorkCancelled.
    void cancel() { progress_.cancel(); }

  private:
    void run() {
        lowerThreadPriority();
        try {
            result_.emplace(work_(progress_));
        } catch (...) {
            error_ = std::current_exception();
        }
        done_ = true;
    }

    Work work_;
    WorkProgress progress_;
    Stopwatch watch_;
    std::optional<Result> result_;
    std::exception_ptr error_;
    std::atomic<bool> done_ = false;
    std::thread thread_;  ///< last: it uses all the others
};

}  // namespace kerf::app
