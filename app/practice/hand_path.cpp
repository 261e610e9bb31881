#include "app/practice/hand_path.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/practice/mean.h"

namespace kerf::app {

namespace {

constexpr double kStep = 0.01;          // of resampling [s]
constexpr double kMostSteps = 50'000;   // longer strokes are sampled more coarsely
constexpr double kSigma = 0.06;         // of the filter for all but the jerk [s]
constexpr double kSigmasForJerk = 40;   // of its filter, in the duration of a stroke
constexpr double kShortest = 0.5;       // stroke with a smoothness or a tremor [s]
constexpr double kLeastWay = 5e-3;      // of a stroke with a smoothness [m]
constexpr double kAtRest = 2e-3;        // below this speed [m/s]
constexpr double kIdle = 0.5;           // is a rest from here on [s]
constexpr double kMoving = 5e-3;        // above this speed [m/s]
constexpr double kCoarseForJerk = 0.1;  // between two poses in motion [s]
constexpr double kCoarseForTremor = 0.02;
constexpr double kRounding = 1e-9;  // of times [s]

/// A stroke as it was recorded, and as it is measured.
struct HandStroke {
    std::vector<double> times;  ///< [s]
    std::vector<Vec3> points;   ///< at these [m]
    HandPath even;
    HandPath smooth;  ///< longer at both ends, see filtered()

    double seconds() const { return times.back() - times.front(); }
    bool isLong() const { return seconds() >= kShortest - kRounding; }
};

Vec3 nearestOn(const Blade& blade, const Vec3& pivot) {
    const Vec3 way = blade.b - blade.a;
    const double t = way.isZero(0) ? 0 : (pivot - blade.a).dot(way) / way.squaredNorm();
    return blade.a + std::clamp(t, 0.0, 1.0) * way;
}

/// Steps that a filter of `sigma` [s] looks ahead and back.
int radiusOf(const HandPath& path, double sigma) {
    return static_cast<int>(3 * sigma / path.step);
}

/// Linear between poses.
HandPath resampled(const HandStroke& stroke) {
    const double steps = std::clamp(std::round(stroke.seconds() / kStep), 1.0, kMostSteps);
    HandPath path{std::max(stroke.seconds() / steps, kStep / 2), {stroke.points.front()}};
    std::size_t to = 0;
    for (int i = 1; i <= steps; ++i) {
        const double time = stroke.times.front() + i * path.step;
        while (to + 1 < stroke.times.size() && stroke.times[to] < time) ++to;
        const std::size_t from = to == 0 ? 0 : to - 1;
        const double gap = stroke.times[to] - stroke.times[from];
        const double share = gap > 0 ? std::min((time - stroke.times[from]) / gap, 1.0) : 1;
        path.points.push_back(stroke.points[from] +
                              share * (stroke.points[to] - stroke.points[from]));
    }
    return path;
}

std::vector<HandStroke> strokesOf(std::span<const HandPose> hand, const Vec3& pivot) {
    std::vector<HandStroke> strokes;
    for (const HandPose& pose : hand) {
        if (pose.begins || strokes.empty()) {
            strokes.emplace_back();
        }
        strokes.back().times.push_back(pose.time);
        strokes.back().points.push_back(nearestOn(pose.blade, pivot));
    }
    for (HandStroke& stroke : strokes) {
        stroke.even = resampled(stroke);
        stroke.smooth = filtered(stroke.even, kSigma);
    }
    return strokes;
}

/// Calls f with each point between those beside it, the ends held.
template <class F>
void alongPoints(const std::vector<Vec3>& points, F&& f) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        f(points[i == 0 ? 0 : i - 1], points[i], points[std::min(i + 1, points.size() - 1)]);
    }
}

/// Velocities by central differences.
std::vector<Vec3> velocitiesOf(const HandPath& path) {
    std::vector<Vec3> velocities;
    alongPoints(path.points, [&](const Vec3& before, const Vec3&, const Vec3& after) {
        velocities.emplace_back((after - before) / (2 * path.step));
    });
    return velocities;
}

double lengthOf(const HandPath& path) {
    double sum = 0;
    alongPoints(path.points, [&](const Vec3& before, const Vec3& now, const Vec3&) {
        sum += (now - before).norm();
    });
    return sum;
}

/// The times between poses while the hand moved, and the longest [s].
struct MotionGaps {
    Mean mean;
    std::optional<double> longest;

    void add(const HandStroke& stroke) {
        for (std::size_t i = 1; i < stroke.times.size(); ++i) {
            const double gap = stroke.times[i] - stroke.times[i - 1];
            if ((stroke.points[i] - stroke.points[i - 1]).norm() > kMoving * gap) {
                mean.add(gap, 1);
                raise(longest, gap);
            }
        }
    }
};

std::optional<double> meanSmoothness(const std::vector<HandStroke>& strokes) {
    Mean mean;
    for (const HandStroke& stroke : strokes) {
        if (stroke.isLong() && lengthOf(stroke.smooth) >= kLeastWay) {
            const HandPath path = filtered(stroke.even, stroke.seconds() / kSigmasForJerk);
            const auto smoothness = smoothnessOf(path, stroke.seconds());
            mean.add(smoothness.value_or(0), smoothness ? stroke.seconds() : 0);
        }
    }
    return mean.value();
}

/// Where the filter has all of its window: beside the ends it would take the motion for tremor.
std::optional<double> tremorOf(const std::vector<HandStroke>& strokes) {
    Mean square;
    for (const HandStroke& stroke : strokes) {
        const int border = radiusOf(stroke.even, kSigma);
        const int end = static_cast<int>(stroke.isLong() ? stroke.even.points.size() : 0) - border;
        for (int i = border; i < end; ++i) {
            square.add((stroke.even.points[i] - stroke.smooth.points[i + border]).squaredNorm(), 1);
        }
    }
    return square.weight > 0 ? std::optional(std::sqrt(*square.value())) : std::nullopt;
}

/// Rests between the first and the last motion [s].
double idleWithin(const HandPath& path) {
    double idle = 0;
    double rest = 0;
    bool hasMoved = false;
    for (const Vec3& velocity : velocitiesOf(path)) {
        if (velocity.norm() < kAtRest) {
            rest += path.step;
        } else {
            idle += hasMoved && rest >= kIdle - kRounding ? rest : 0;
            hasMoved = true;
            rest = 0;
        }
    }
    return idle;
}

}  // namespace

HandPath filtered(const HandPath& path, double sigma) {
    const int last = static_cast<int>(path.points.size()) - 1;
    const int radius = radiusOf(path, sigma);
    std::vector<double> weights;
    for (int k = -radius; k <= radius; ++k) {
        const double x = k * path.step / sigma;
        weights.push_back(std::exp(-0.5 * x * x));
    }
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    HandPath smooth{path.step, {}};
    for (int i = -radius; i <= last + radius; ++i) {
        Vec3 sum = Vec3::Zero();
        for (int k = -radius; k <= radius; ++k) {
            sum += weights[k + radius] * path.points[std::clamp(i + k, 0, last)];
        }
        smooth.points.emplace_back(sum / total);
    }
    return smooth;
}

std::optional<double> smoothnessOf(const HandPath& path, double seconds) {
    double peak = 0;
    double jerk = 0;  // squared
    alongPoints(velocitiesOf(path), [&](const Vec3& before, const Vec3& now, const Vec3& after) {
        const Vec3 bend = (before - 2 * now + after) / (path.step * path.step);
        jerk += bend.squaredNorm() * path.step;
        peak = std::max(peak, now.norm());
    });
    const double share = seconds * seconds * seconds / (peak * peak) * jerk;
    return share > 0 ? std::optional(-std::log(share)) : std::nullopt;
}

MotionScore measureMotion(std::span<const HandPose> hand, const Vec3& pivot,
                          std::optional<double> expertPath) {
    const std::vector<HandStroke> strokes = strokesOf(hand, pivot);
    if (strokes.empty()) {
        return {};
    }
    MotionScore score{hand.back().time - hand.front().time, 0.0, {}, {}, {}, 0.0};
    MotionGaps gaps;
    const HandStroke* before = nullptr;
    for (const HandStroke& stroke : strokes) {
        if (before != nullptr) {
            *score.path += (stroke.points.front() - before->points.back()).norm();
            *score.idleTime += stroke.times.front() - before->times.back();
        }
        *score.path += lengthOf(stroke.smooth);
        *score.idleTime += idleWithin(stroke.smooth);
        gaps.add(stroke);
        before = &stroke;
    }
    if (expertPath && *score.path > 0) {
        score.economy = std::min(1.0, *expertPath / *score.path);
    }
    if (gaps.longest.value_or(0) <= kCoarseForJerk + kRounding) {
        score.smoothness = meanSmoothness(strokes);
    }
    if (gaps.mean.value().value_or(0) <= kCoarseForTremor + kRounding) {
        score.tremor = tremorOf(strokes);
    }
    return score;
}

}  // namespace kerf::app
