#pragma once

#include "sim/base/math.h"

namespace kerf {

/// The rotation that brings points with this covariance (sum of current rest^T) closest together
/// (Kabsch 1976).
Eigen::Matrix3d bestRotation(const Eigen::Matrix3d& covariance);

/// A vertex of a piece, as its rest shape is fitted to it.
struct FittedVertex {
    int vertex = -1;
    double weight = 0;
    Vec3 at = Vec3::Zero();        ///< [m]
    Vec3 rest = Vec3::Zero();      ///< [m]
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
};

/// How a piece moves as a whole.
struct RigidMotion {
    Vec3 velocity = Vec3::Zero();  ///< of its middle [m/s]
    Vec3 spin = Vec3::Zero();      ///< [rad/s]
};

/// The best fit of the rest shape of a piece to its present positions.
struct RestPose {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< never mirrors
    Vec3 middle = Vec3::Zero();                              ///< [m]
    Vec3 restMiddle = Vec3::Zero();                          ///< [m]
    double radius = 0;                                       ///< RMS distance from it at rest [m]

    /// The goal of a vertex with this rest position [m].
    Vec3 placeOf(const Vec3& rest) const { return middle + rotation * (rest - restMiddle); }
};

/// The pose with the least weighted squares of distances (shape matching, Mueller et al. 2005).
/// Some weight must be above 0.
RestPose fitRestPose(std::span<const FittedVertex> vertices);
/// The rigid motion with the weighted momenta of the vertices about `middle`, their mean.
RigidMotion rigidMotionOf(std::span<const FittedVertex> vertices, const Vec3& middle);
/// Root mean square of the distances from the vertices to their goals [m].
double rmsWay(const RestPose& pose, std::span<const FittedVertex> vertices);

}  // namespace kerf
