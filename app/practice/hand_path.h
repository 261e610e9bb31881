#pragma once

#include <optional>
#include <span>
#include <vector>

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
};

/// Measures a hand by the point of its blade nearest to `pivot`. `expertPath` [m]: none if unknown.
MotionScore measureMotion(std::span<const HandPose> hand, const Vec3& pivot,
                          std::optional<double> expertPath);

/// Points of a hand at equal steps of time.
struct HandPath {
    double step = 0;  ///< above 0 [s]
    std::vector<Vec3> points;
};
/// The path after a Gaussian of `sigma` [s], cut off at three. Before and after it the hand rests
/// at its ends, and comes in sight for these three.
HandPath filtered(const HandPath& path, double sigma);
/// The negative logarithm of the dimensionless jerk of a motion that takes so long [s] (Hogan and
/// Sternad 2009); none without motion.
std::optional<double> smoothnessOf(const HandPath& path, double seconds);

}  // namespace kerf::app
