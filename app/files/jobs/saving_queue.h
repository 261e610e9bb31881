#pragma once

#include <deque>

#include "app/files/jobs/background_job.h"

namespace kerf::app {

/// A background queue of small files to write (pictures, plots), in order. Nobody waits for them or
/// cancels them.
class SavingQueue {
  public:
    /// Encodes and writes on a separate thread. Returns a message for the user; may throw.
    using Work = std::function<std::string()>;
    /// The end of a save.
    struct Outcome {
        int number = 0;  ///< that add() gave it
        std::string sentence;
        bool failed = false;
    };

    /// The end of a job that is done, under a number.
    static Outcome endOf(BackgroundJob<std::string>& job, int number);

    /// Returns the number of this save, from 1.
    int add(Work work);
    /// The end of the oldest save whose outcome was not taken yet; none before it has ended.
    std::optional<Outcome> takeOutcome();
    /// Whether something is not written yet, or its outcome not taken.
    bool busy() const { return running_ != nullptr; }
    /// Waits until all is written.
    void finish();

  private:
    void startNext();

    std::deque<Work> waiting_;
    std::unique_ptr<BackgroundJob<std::string>> running_;
    int added_ = 0;
    int ended_ = 0;
};

}  // namespace kerf::app
