#pragma once

#include "sim/base/math.h"
#include "sim/cut/blade.h"

namespace kerf::app {

/// A pose of the hand. A lift is the last pose of a stroke once more, at its own time.
struct HandPose {
    double time = 0;  ///< of the hand, never less than that of the pose before [s]
    Blade blade;
    bool begins = false;  ///< a stroke
};

/// How the hand moved. A figure is none where there is too little to measure.
struct MotionScore {
    std::optional<double> time;        ///< from the first pose to the last lift [s]
    std::optional<double> path;        ///< of the hand, in the air too [m]
    std::optional<double> economy;     ///< the expert's path over this one, at most 1
    std::optional<double> smoothness;  ///< log dimensionless jerk: larger is smoother
    std::optional<double> tremor;      ///< root mean square about the filtered path [m]
    std::optional<double> idleTime;    ///< at rest within strokes, and between strokes [s]
    std::optional<double> wobble;      ///< root mean square to the sides of a line [m]
};

/// Where on the blade a hand is measured, from 0 at A to 1 at B: as near to `pivot` as the blade
/// comes, on average.
double handShare(std::span<const HandPose> hand, const Vec3& pivot);
inline Vec3 handPoint(const Blade& blade, double share) {
    return blade.a + share * (blade.b - blade.a);
}
/// How far a point is beside a line, positive on one side [m]; none if it is at no line.
using Sideways = std::function<std::optional<double>(const Vec3& point)>;
/// Measures a hand by that point of its blade. `expertPath` [m]: none if unknown.
MotionScore measureMotion(std::span<const HandPose> hand, const Vec3& pivot,
                          std::optional<double> expertPath, const Sideways& sideways = {});

/// Running statistics of a figure; each is none as long as nothing was added.
struct Statistics {
    std::optional<double> mean;
    std::optional<double> least;
    std::optional<double> most;
    double weight = 0;

    void add(double value, double by = 1) {
        weight += by;
        mean = mean.value_or(value) + by / weight * (value - mean.value_or(value));
        least = std::min(least.value_or(value), value);
        most = std::max(most.value_or(value), value);
    }
};

/// Points over time or over length: linear in between, constant before and behind.
struct Curve {
    std::vector<double> at;  ///< ascending
    std::vector<Vec3> points;

    void add(double where, const Vec3& point) {
        at.push_back(where);
        points.push_back(point);
    }
    double span() const { return at.back() - at.front(); }
    /// The curve must have a point.
    Vec3 operator()(double where) const {
        const std::size_t next = std::ranges::upper_bound(at, where) - at.begin();
        if (next == 0 || next == at.size()) {
            return next == 0 ? points.front() : points.back();
        }
        const double share = (where - at[next - 1]) / (at[next] - at[next - 1]);
        return points[next - 1] + share * (points[next] - points[next - 1]);
    }
};

}  // namespace kerf::app
