#pragma once

#include "sim/base/stopwatch.h"

namespace kerf {

/// A point in long work at which its caller may do something else on this thread, such as draw a
/// frame. Results must not depend on it, nothing of OpenGL may stay bound across it, and no
/// exception may be in flight: see "Steps in portions" in docs/architecture.md. With assertions on,
/// problemOfPause() is asserted to be "". Costs almost nothing without Pauses.
void pausePoint();

/// Why this thread can't pause here: an exception is thrown or handled, or what the check of its
/// Pauses says. "" if it can, or without Pauses.
std::string problemOfPause();

/// A member that pauses the copying of its class before the members behind it.
struct PauseOfCopies {
    PauseOfCopies() = default;
    PauseOfCopies(const PauseOfCopies& /*other*/) { pausePoint(); }
    PauseOfCopies(PauseOfCopies&&) noexcept = default;
    PauseOfCopies& operator=(const PauseOfCopies&) = default;
    PauseOfCopies& operator=(PauseOfCopies&&) noexcept = default;
    ~PauseOfCopies() = default;
};

/// Calls a function at each pausePoint() of this thread during its lifetime. One at a time.
class Pauses {
  public:
    /// `check` says what the work has left bound that others would meet, "" for nothing.
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

/// Wall-clock time of this thread since construction, without its pauses.
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
