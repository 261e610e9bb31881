#include "app/practice/hand_path.h"

namespace kerf::app {

namespace {

constexpr double kStep = 0.01;         // of sampling [s]
constexpr double kMostSteps = 50'000;  // longer strokes are sampled more coarsely
constexpr double kSigma = 0.06;        // of the filter for all but the jerk [s]
constexpr double kSteering = 0.25;  // of that for the wobble: slower is the course of the hand [s]
constexpr double kJerkSigma = 0.025;  // of the duration of a stroke
constexpr int kTaps = 25;             // of filters for each sigma, and samples of the jerk
constexpr double kShort = 0.5;        // no stroke with a smoothness or a tremor, and no rest [s]
constexpr double kLeastWay = 5e-3;    // of a stroke with a smoothness [m]
constexpr double kAtRest = 2e-3;      // below this speed [m/s]
constexpr double kMoving = 5e-3;      // above this one poses may not lie so far apart,
constexpr double kFarApart = 5e-4;    // nor if they are farther from each other than this [m]:
constexpr double kCoarseForJerk = 0.1 + 1e-9;     // two of them [s]
constexpr double kCoarseForTremor = 0.02 + 1e-9;  // on average

/// The mean about a moment, by a Gaussian of `sigma` [s] that is cut off at three.
Vec3 smoothAt(const Curve& stroke, double time, double sigma) {
    Vec3 sum = Vec3::Zero();
    double weight = 0;
    for (int k = -3 * kTaps; k <= 3 * kTaps; ++k) {
        const double x = static_cast<double>(k) / kTaps;
        sum += std::exp(-0.5 * x * x) * stroke(time + x * sigma);
        weight += std::exp(-0.5 * x * x);
    }
    return sum / weight;
}

/// The negative logarithm of the dimensionless jerk (Hogan and Sternad 2009).
double smoothnessOf(const Curve& stroke) {
    const double step = kJerkSigma / kTaps;  // as that of the filter, or it would let corners pass
    std::vector<Vec3> x;
    for (double t = -3 * kJerkSigma; t < 1 + 3 * kJerkSigma; t += step) {
        const double time = stroke.at.front() + t * stroke.span();
        x.push_back(smoothAt(stroke, time, kJerkSigma * stroke.span()));
    }
    double peak = 0;
    double jerk = 0;                                  // squared
    for (std::size_t i = 2; i + 2 < x.size(); ++i) {  // central differences
        peak = std::max(peak, (x[i + 1] - x[i - 1]).norm() / (2 * step));
        jerk += (x[i + 2] - 2 * x[i + 1] + 2 * x[i - 1] - x[i - 2]).squaredNorm();
    }
    return -std::log(jerk / (4 * std::pow(step, 5) * peak * peak));
}

/// Sums over all strokes.
struct Motion {
    double path = 0;    ///< [m]
    double idle = 0;    ///< [s]
    Statistics gaps;    ///< between poses on the move [s]
    Statistics tremor;  ///< squared [m^2]
    Statistics smoothness;
    Statistics wobble;  ///< squared [m^2]
};

/// From a sample of a stroke to the next [s].
double stepOf(const Curve& stroke) {
    return std::max(kStep, stroke.span() / kMostSteps);
}

/// Follows the filtered path for as long as the filter sees the stroke.
void addStroke(const Curve& stroke, Motion& motion) {
    const double step = stepOf(stroke);
    const bool isLong = stroke.span() >= kShort;
    double length = 0;
    double rest = 0;
    Vec3 last = stroke.points.front();
    for (double t = -3 * kSigma; t < stroke.span() + 3 * kSigma + step; t += step) {
        const Vec3 now = smoothAt(stroke, stroke.at.front() + t, kSigma);
        const double way = (now - last).norm();
        const bool isAtRest = t > 0 && t <= stroke.span() && way < kAtRest * step;
        motion.idle += !isAtRest && rest >= kShort ? rest : 0;
        rest = isAtRest ? rest + step : 0;
        length += way;
        last = now;
        // Nearer to the ends the filter would take motion for tremor.
        if (isLong && t >= 3 * kSigma && t <= stroke.span() - 3 * kSigma) {
            motion.tremor.add((stroke(stroke.at.front() + t) - now).squaredNorm());
        }
    }
    motion.path += length;
    if (isLong && length >= kLeastWay) {
        motion.smoothness.add(smoothnessOf(stroke), stroke.span());
    }
}

/// `aside`: how far the hand is beside a line, as x.
void addWobble(const Curve& aside, Statistics& wobble) {
    for (double t = 0; !aside.at.empty() && t <= aside.span(); t += stepOf(aside)) {
        const double time = aside.at.front() + t;
        wobble.add((aside(time) - smoothAt(aside, time, kSteering)).squaredNorm());
    }
}

}  // namespace

double handShare(std::span<const HandPose> hand, const Vec3& pivot) {
    double sum = 0;
    for (const auto& [time, blade, begins] : hand) {
        const Vec3 way = blade.b - blade.a;
        const double share = way.isZero(0) ? 0 : (pivot - blade.a).dot(way) / way.squaredNorm();
        sum += std::clamp(share, 0.0, 1.0);
    }
    return hand.empty() ? 0 : sum / static_cast<double>(hand.size());
}

MotionScore measureMotion(std::span<const HandPose> hand, const Vec3& pivot,
                          std::optional<double> expertPath, const Sideways& sideways) {
    if (hand.empty()) {
        return {};
    }
    const double share = handShare(hand, pivot);
    Motion motion;
    Curve stroke;
    Curve aside;
    for (const HandPose& pose : hand) {
        const Vec3 point = handPoint(pose.blade, share);
        const double gap = stroke.at.empty() ? 0 : pose.time - stroke.at.back();
        const double way = stroke.at.empty() ? 0 : (point - stroke.points.back()).norm();
        if (pose.begins && !stroke.at.empty()) {
            addStroke(stroke, motion);
            addWobble(aside, motion.wobble);
            motion.idle += gap;
            motion.path += way;
            stroke = {};
            aside = {};
        } else if (way > std::min(kMoving * gap, kFarApart)) {
            motion.gaps.add(gap);
        }
        stroke.add(pose.time, point);
        if (const auto side = sideways ? sideways(point) : std::nullopt) {
            aside.add(pose.time, {*side, 0, 0});
        }
    }
    addStroke(stroke, motion);
    addWobble(aside, motion.wobble);
    MotionScore score{
        hand.back().time - hand.front().time, motion.path, {}, {}, {}, motion.idle, {}};
    if (expertPath && motion.path > 0) {
        score.economy = std::min(1.0, *expertPath / motion.path);
    }
    if (motion.gaps.most.value_or(0) <= kCoarseForJerk) {
        score.smoothness = motion.smoothness.mean;
        if (motion.wobble.mean) {
            score.wobble = std::sqrt(*motion.wobble.mean);
        }
    }
    if (motion.tremor.mean && motion.gaps.mean.value_or(0) <= kCoarseForTremor) {
        score.tremor = std::sqrt(*motion.tremor.mean);
    }
    return score;
}

}  // namespace kerf::app
