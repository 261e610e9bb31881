#pragma once

namespace kerf::app {

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
