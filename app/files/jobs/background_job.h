#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "sim/base/stopwatch.h"

namespace kerf::app {

/// Ends work that the user has cancelled. Not an error, so not a std::exception.
struct WorkCancelled {};

/// The progress of long work, which can be cancelled. For two threads: the one that works, and the
/// one that waits.
class WorkProgress {
  public:
    /// Enters a stage ("Reading the file"), with `done` of `all` parts done where that is known.
    /// Throws WorkCancelled once cancel() was called.
    void enter(std::string stage, int done = 0, int all = 0);
    bool cancelled() const { return cancelled_; }

    std::string stage() const;
    int done() const { return done_; }
    int all() const { return all_; }
    void cancel() { cancelled_ = true; }

  private:
    std::atomic<bool> cancelled_ = false;
    std::atomic<int> done_ = 0;
    std::atomic<int> all_ = 0;
    mutable std::mutex mutex_;
    std::string stage_;
};

/// Enters a stage of the work, if `progress` is not null.
inline void enter(WorkProgress* progress, std::string stage) {
    if (progress != nullptr) {
        progress->enter(std::move(stage));
    }
}

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

/// The current job, if any, and cancelled ones, which are kept until their threads end, so that
/// nobody waits for them. A `Job` has cancel() and done().
template <class Job>
class CurrentJob {
  public:
    /// Makes `job` the current one and cancels the previous one.
    void start(std::unique_ptr<Job> job) {
        cancel();
        now_ = std::move(job);
    }
    /// The current job; null for none.
    Job* now() const { return now_.get(); }
    /// Releases the current job.
    std::unique_ptr<Job> take() { return std::move(now_); }
    /// Cancels the current job. Returns false if there is none.
    bool cancel() {
        if (now_ == nullptr) {
            return false;
        }
        now_->cancel();
        cancelled_.push_back(std::move(now_));
        return true;
    }
    /// Drops cancelled jobs whose threads have ended.
    void forgetEnded() {
        std::erase_if(cancelled_, [](const auto& job) { return job->done(); });
    }

  private:
    std::unique_ptr<Job> now_;
    std::vector<std::unique_ptr<Job>> cancelled_;
};

}  // namespace kerf::app
