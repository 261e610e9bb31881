#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace kerf::app {

/// The job that is under way, if any, and those that were given up: they are kept until their
/// threads end, so that nobody waits for them. A `Job` has cancel() and done().
template <class Job>
class CurrentJob {
  public:
    /// Makes `job` the current one and gives up the one before.
    void start(std::unique_ptr<Job> job) {
        cancel();
        now_ = std::move(job);
    }
    /// The current job; null for none.
    Job* now() const { return now_.get(); }
    /// Hands the current job over: there is none then.
    std::unique_ptr<Job> take() { return std::move(now_); }
    /// Gives up the current job. Returns false where there is none.
    bool cancel() {
        if (now_ == nullptr) {
            return false;
        }
        now_->cancel();
        cancelled_.push_back(std::move(now_));
        return true;
    }
    /// Forgets the given-up jobs whose threads have ended.
    void forgetEnded() {
        std::erase_if(cancelled_, [](const auto& job) { return job->done(); });
    }

  private:
    std::unique_ptr<Job> now_;
    std::vector<std::unique_ptr<Job>> cancelled_;
};

}  // namespace kerf::app
