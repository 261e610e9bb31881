#pragma once

#include <atomic>
#include <mutex>
#include <string>

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

}  // namespace kerf::app
