#pragma once

#include <functional>

namespace kerf {

/// A place in long work where whoever had it begun may do something else on this thread before it
/// goes on: a window draws a picture, say. Results must not depend on it, nothing of OpenGL may be
/// left bound across it, and no exception may be under way. Costs next to nothing where nobody
/// pauses.
void pausePoint();

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

/// Time that work of this thread has spent in pauses so far [s]: measures of how long it took leave
/// that out.
double pausedSeconds();

}  // namespace kerf
