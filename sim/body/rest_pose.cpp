#include "sim/body/rest_pose.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace kerf {

namespace {

using Matrix = Eigen::Matrix3d;
using Vertices = std::span<const FittedVertex>;

/// The weighted mean of what f(vertex) gives.
template <class Value, class F>
Value meanOf(Vertices vertices, Value sum, F&& f) {
    double weight = 0;
    for (const FittedVertex& v : vertices) {
        sum += v.weight * f(v);
        weight += v.weight;
    }
    return sum / weight;
}

}  // namespace

Eigen::Matrix3d bestRotation(const Eigen::Matrix3d& covariance) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d product = svd.matrixU() * svd.matrixV().transpose();
    const Vec3 signs(1, 1, product.determinant() < 0 ? -1 : 1);
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

RestPose fitRestPose(Vertices vertices) {
    RestPose pose;
    pose.middle = meanOf(vertices, pose.middle, [](const auto& v) { return v.at; });
    pose.restMiddle = meanOf(vertices, pose.restMiddle, [](const auto& v) { return v.rest; });
    pose.rotation = bestRotation(meanOf(vertices, Matrix(Matrix::Zero()), [&](const auto& v) {
        return Matrix((v.at - pose.middle) * (v.rest - pose.restMiddle).transpose());
    }));
    pose.radius = std::sqrt(meanOf(
        vertices, 0.0, [&](const auto& v) { return (v.rest - pose.restMiddle).squaredNorm(); }));
    return pose;
}

RigidMotion rigidMotionOf(Vertices vertices, const Vec3& middle) {
    RigidMotion motion;
    motion.velocity = meanOf(vertices, motion.velocity, [](const auto& v) { return v.velocity; });
    const Vec3 angularMomentum = meanOf(vertices, motion.spin, [&](const auto& v) {
        return Vec3((v.at - middle).cross(v.velocity - motion.velocity));
    });
    Matrix inertia = meanOf(vertices, Matrix(Matrix::Zero()), [&](const auto& v) {
        const Vec3 arm = v.at - middle;
        return Matrix(arm.squaredNorm() * Matrix::Identity() - arm * arm.transpose());
    });
    const double size = inertia.trace();
    inertia += 1e-6 * size * Matrix::Identity();  // for what lies on a line
    motion.spin = size > 0 ? Vec3(inertia.inverse() * angularMomentum) : Vec3(Vec3::Zero());
    return motion;
}

double rmsWay(const RestPose& pose, Vertices vertices) {
    return std::sqrt(meanOf(
        vertices, 0.0, [&](const auto& v) { return (pose.placeOf(v.rest) - v.at).squaredNorm(); }));
}

}  // namespace kerf
