#include "sim/mesh/oriented_box.h"

#include <Eigen/Eigenvalues>

#include "sim/base/math.h"

namespace kerf {

namespace {

// Of the boxes' sizes: what rounding may add to a distance.
constexpr double kRounding = 1e-12;
// The same where boxes that overlap the box around are alone asked for.
constexpr double kRoundingOfMany = 1e-9;

double reachAlong(const OrientedBox& box, const Vec3& axis) {
    return (box.axes.transpose() * axis).cwiseAbs().dot(box.half);
}

// An axis of length zero (parallel edges) separates nothing.
bool separates(const Vec3& axis, const OrientedBox& a, const OrientedBox& b) {
    const Vec3 way = b.center - a.center;
    const double rounding = kRounding * (way.norm() + a.half.norm() + b.half.norm());
    return std::fabs(axis.dot(way)) > reachAlong(a, axis) + reachAlong(b, axis) + rounding;
}

Eigen::Matrix3d principalAxes(std::span<const Vec3> points, const Vec3& mean) {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3& p : points) {
        spread += (p - mean) * (p - mean).transpose();
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
}

}  // namespace

OrientedBox orientedBoxOf(std::span<const Vec3> points) {
    Vec3 mean = Vec3::Zero();
    for (const Vec3& p : points) {
        mean += p / static_cast<double>(points.size());
    }
    return orientedBoxAlong(principalAxes(points, mean), points);
}

OrientedBox orientedBoxAlong(const Eigen::Matrix3d& axes, std::span<const Vec3> points) {
    const Vec3& origin = points.front();
    const auto local =
        boxOf(points, [&](const Vec3& p) -> Vec3 { return axes.transpose() * (p - origin); });
    return {origin + axes * local.center(), axes, 0.5 * (local.high - local.low)};
}

bool contains(const OrientedBox& outer, const OrientedBox& inner) {
    const Vec3 way = outer.axes.transpose() * (inner.center - outer.center);
    const Vec3 reach = (outer.axes.transpose() * inner.axes).cwiseAbs() * inner.half;
    return ((way.cwiseAbs() + reach).array() <= outer.half.array()).all();
}

bool mayMeet(const OrientedBox& a, const Bounds& b) {
    const Vec3 half = 0.5 * (b.high - b.low);
    const Vec3 way = b.center() - a.center;
    const double rounding = kRounding * (way.norm() + half.norm() + a.half.norm());
    const Eigen::Matrix3d along = a.axes.cwiseAbs();
    const Vec3 ofA = a.half + along.transpose() * half;
    const Vec3 ofB = half + along * a.half;
    return ((a.axes.transpose() * way).cwiseAbs().array() <= ofA.array() + rounding).all() &&
           (way.cwiseAbs().array() <= ofB.array() + rounding).all();
}

MeetingBoxes::MeetingBoxes(const OrientedBox& box)
    : axes_(box.axes.transpose()), across_(axes_.cwiseAbs()), middle_(axes_ * box.center) {
    const double reach = box.center.cwiseAbs().sum() + box.half.sum();
    half_ = box.half + Vec3::Constant(kRoundingOfMany * reach);
    const Vec3 halfAround = across_.transpose() * half_;
    around_ = {box.center - halfAround, box.center + halfAround};
}

bool MeetingBoxes::meetsAlongAxes(const Vec3& center, const Vec3& half) const {
    for (int i = 0; i < 3; ++i) {
        const double way = axes_.row(i).dot(center) - middle_[i];
        if (std::fabs(way) > half_[i] + across_.row(i).dot(half) * (1 + kRoundingOfMany)) {
            return false;
        }
    }
    return true;
}

bool overlap(const OrientedBox& a, const OrientedBox& b) {
    for (int i = 0; i < 3; ++i) {
        if (separates(a.axes.col(i), a, b) || separates(b.axes.col(i), a, b)) {
            return false;
        }
    }
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            if (separates(a.axes.col(i).cross(b.axes.col(j)), a, b)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace kerf
