#pragma once

#include <functional>

#include "sim/base/stopwatch.h"

namespace kerf {

/// A place in long work where whoever had it begun may do something else on this thread before it
/// goes on: a window draws a picture, say. Results must not depend on it, nothing of OpenGL may be
/// left bound across it, and no exception may be under way. Costs next to nothing where nobody
/// pauses.
void pausePoint();

/// A member that lets the copy of what it belongs to rest before the members behind it.
struct PauseOfCopies {
    PauseOfCopies() = default;
    PauseOfCopies(const PauseOfCopies& /*other*/) { pausePoint(); }
    PauseOfCopies(PauseOfCopies&&) noexcept = default;
    PauseOfCopies& operator=(const PauseOfCopies&) = default;
    PauseOfCopies& operator=(PauseOfCopies&&) noexcept = default;
    ~PauseOfCopies() = default;
};

/// Calls a function at each pausePoint() of this thread, while it lives. There is one at a time.
class Pauses {
  public:
    explicit Pauses(std::function<void()> pause);
    ~Pauses();
    Pauses(const Pauses&) = delete;
    Pauses& operator=(const Pauses&) = delete;

  private:
    std::function<void()> pause_;
};

/// Wall-clock time that this thread has worked since it was made: without its pauses.
class WorkWatch {
  public:
    WorkWatch();
    double seconds() const;
    double milliseconds() const { return 1000 * seconds(); }

  private:
    Stopwatch watch_;
    double pausedBefore_;  ///< [s]
};

}  // namespace kerf
