#pragma once

#include <chrono>

namespace kerf {

/// Wall-clock time since it was made or restarted.
class Stopwatch {
  public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    double milliseconds() const { return 1000 * seconds(); }
    /// The seconds so far; restarts it.
    double restart() {
        const Clock::time_point before = std::exchange(start_, Clock::now());
        return std::chrono::duration<double>(start_ - before).count();
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace kerf
