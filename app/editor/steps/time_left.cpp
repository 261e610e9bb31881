#include "app/editor/steps/time_left.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf::app {
namespace {

constexpr double kWindow = 10;  // of which the rate is taken [s]
constexpr double kSettles = 4;  // within which the estimate takes up a new rate [s]

}  // namespace

void TimeLeft::follow(ui::WorkState& work) {
    if (std::exchange(title_, work.title) != work.title) {
        *this = {};
        title_ = work.title;
    }
    work.seconds = std::max(work.seconds, watch_.seconds());
    work.left = at(work.seconds, work.done, work.all);
}

std::optional<double> TimeLeft::at(double seconds, double done, double all) {
    note({seconds, done});
    const double parts = samples_.back().done - samples_.front().done;
    if (all <= 0 || parts <= 0) {
        return left_ = std::nullopt;
    }
    const double each = (samples_.back().seconds - samples_.front().seconds) / parts;
    const double byRate = std::max(0.0, each * (all - done) - (seconds - samples_.back().seconds));
    const double passed = seconds - std::exchange(last_, seconds);
    const double runsDown = std::max(0.0, left_.value_or(byRate) - passed);
    return left_ = runsDown + (byRate - runsDown) * (1 - std::exp(-passed / kSettles));
}

/// Keeps two samples at least, however old.
void TimeLeft::note(const Sample& now) {
    if (samples_.empty() || now.done < samples_.back().done) {
        samples_ = {now};
    } else if (now.done > samples_.back().done) {
        samples_.push_back(now);
    }
    while (samples_.size() > 2 && samples_[1].seconds < now.seconds - kWindow) {
        samples_.pop_front();
    }
}

}  // namespace kerf::app
