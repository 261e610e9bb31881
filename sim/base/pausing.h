#pragma once

#include <functional>
#include <string>

#include "sim/base/stopwatch.h"

namespace kerf {

/// A place in long work where whoever had it begun may do something else on this thread before it
/// goes on: a window draws a picture, say. Results must not depend on it, nothing of OpenGL may be
/// left bound across it, and no exception may be under way: see "A step may rest" in
/// docs/architecture.md. Where assertions are on, problemOfPause() is asserted to be "". Costs next
/// to nothing where nobody pauses.
void pausePoint();

/// What keeps this thread from pausing here: an exception that is thrown or handled, or what the
/// check of its Pauses says. "" where nothing does, or where nobody pauses.
std::string problemOfPause();

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
    /// `check` tells of what the work has left behind that others would meet, "" for nothing.
    explicit Pauses(std::function<void()> pause, std::function<std::string()> check = {});
    ~Pauses();
    Pauses(const Pauses&) = delete;
    Pauses& operator=(const Pauses&) = delete;

  private:
    friend void pausePoint();
    friend std::string problemOfPause();

    std::function<void()> pause_;
    std::function<std::string()> check_;
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
