#pragma once

#include <atomic>
#include <mutex>
#include <string>

namespace kerf::app {

/// Ends a piece of work that the person has cancelled. No error, so not a std::exception.
struct WorkCancelled {};

/// The progress of a long piece of work, which can also be asked to stop. For two threads: the one
/// that works, and the one that waits.
class WorkProgress {
  public:
    /// Names what comes next ("Reading the file"). Throws WorkCancelled once cancel() was called.
    void enter(std::string stage);
    bool cancelled() const { return cancelled_; }

    std::string stage() const;
    void cancel() { cancelled_ = true; }

  private:
    std::atomic<bool> cancelled_ = false;
    mutable std::mutex mutex_;
    std::string stage_;
};

/// Enters a stage of the work, unless nobody watches: `progress` is null then.
inline void enter(WorkProgress* progress, std::string stage) {
    if (progress != nullptr) {
        progress->enter(std::move(stage));
    }
}

}  // namespace kerf::app
