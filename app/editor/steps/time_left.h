#pragma once

#include <deque>
#include <string>

#include "sim/base/stopwatch.h"
#include "ui/state/work_state.h"

namespace kerf::app {

/// Estimates how long work still takes, from its rate over the last seconds. The estimate runs down
/// with the clock and approaches a new rate slowly, so that it does not jump.
class TimeLeft {
  public:
    /// Sets the times of `work`, which begins anew where its title changes.
    void follow(ui::WorkState& work);
    /// The estimate once `done` of `all` parts are done, `seconds` after the start [s]; none
    /// without a rate.
    std::optional<double> at(double seconds, double done, double all);

  private:
    struct Sample {
        double seconds = 0;
        double done = 0;
    };
    void note(const Sample& now);

    std::string title_;
    Stopwatch watch_;
    std::deque<Sample> samples_;  ///< where more was done, oldest first
    std::optional<double> left_;  ///< [s]
    double last_ = 0;             ///< when it was estimated [s]
};

}  // namespace kerf::app
