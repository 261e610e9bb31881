#include "sim/base/placement.h"

#include <Eigen/Geometry>
#include <sstream>

namespace kerf {

namespace {

// Of a model in the scene.
constexpr double kLeastLength = 1e-6;          // [m]
constexpr double kFarthestReach = 1e7;         // [m]; maps have such numbers
constexpr double kMostReachInLengths = 20000;  // of its longest side
constexpr double kNearInLengths = 8;           // floats are as good there as at the origin

constexpr std::array kUnits{
    LengthUnitInfo{"metres", 1},         LengthUnitInfo{"centimetres", 1e-2},
    LengthUnitInfo{"millimetres", 1e-3}, LengthUnitInfo{"micrometres", 1e-6},
    LengthUnitInfo{"kilometres", 1e3},   LengthUnitInfo{"inches", 0.0254},
    LengthUnitInfo{"feet", 0.3048},
};
static_assert(kUnits.size() == std::size(kLengthUnitNames));

/// Brings the up axis to +y, without any rounding.
Vec3 upright(const Vec3& p, UpAxis up) {
    switch (up) {
        case UpAxis::y:
            return p;
        case UpAxis::z:
            return {p.x(), p.z(), -p.y()};
        case UpAxis::x:
            return {-p.y(), p.x(), p.z()};
        case UpAxis::minusY:
            return {p.x(), -p.y(), -p.z()};
        case UpAxis::minusZ:
            return {p.x(), -p.z(), p.y()};
        case UpAxis::minusX:
            return {p.y(), -p.x(), p.z()};
    }
    return p;
}

/// Each turn that upright() makes is taken back by that of another axis.
UpAxis inverseOf(UpAxis up) {
    switch (up) {
        case UpAxis::z:
            return UpAxis::minusZ;
        case UpAxis::minusZ:
            return UpAxis::z;
        case UpAxis::x:
            return UpAxis::minusX;
        case UpAxis::minusX:
            return UpAxis::x;
        default:
            return up;
    }
}

}  // namespace

const LengthUnitInfo& infoOf(LengthUnit unit) {
    return kUnits[static_cast<std::size_t>(unit)];
}

Vec3 Placement::apply(const Vec3& own) const {
    return PlacementMap(*this).toScene(own);
}

PlacementMap::PlacementMap(const Placement& placement)
    : placement_(placement),
      up_(placement.up.value_or(UpAxis::y)),
      metres_(placement.metresPerUnit()),
      turn_(turnOf(placement.rotate)) {}

Vec3 PlacementMap::toScene(const Vec3& own) const {
    const Vec3 metric = metres_ * upright(own, up_);
    return turn_ * (placement_.scale * metric) + placement_.translate;
}

Vec3 PlacementMap::toModel(const Vec3& placed) const {
    const Vec3 metric = turn_.transpose() * (placed - placement_.translate) / placement_.scale;
    return upright(metric / metres_, inverseOf(up_));
}

Vec3 originOf(const Bounds& placed) {
    const double length = (placed.high - placed.low).maxCoeff();
    if (!(length > 0)) {
        return Vec3::Zero();  // a point, or no numbers: nothing that could be cut
    }
    const double step = std::exp2(std::ceil(std::log2(length)));
    const Vec3 round = (placed.center() / step).array().round() * step;
    const Vec3 reach = placed.high.cwiseAbs().cwiseMax(placed.low.cwiseAbs());
    return (reach.array() > kNearInLengths * length).select(round, Vec3::Zero());
}

std::string checkRoom(const Bounds& placed, const Vec3& origin) {
    const auto reachFrom = [&](const Vec3& zero) {
        return std::max((placed.high - zero).cwiseAbs().maxCoeff(),
                        (placed.low - zero).cwiseAbs().maxCoeff());
    };
    const double length = (placed.high - placed.low).maxCoeff();
    const double reach = reachFrom(Vec3::Zero());
    if (length >= kLeastLength && reach <= kFarthestReach &&
        reachFrom(origin) <= kMostReachInLengths * length) {
        return "";
    }
    std::ostringstream message;
    message << "the model would be " << length << " m long and reach " << reach
            << " m from the origin, but must be at least " << kLeastLength
            << " m long and reach at most " << kFarthestReach << " m, and " << kMostReachInLengths
            << " times its length from the middle of the scene; scale or "
            << "move it.";
    return message.str();
}

Eigen::Matrix3d turnOf(const Vec3& degrees) {
    const Vec3 radians = degrees * (EIGEN_PI / 180);
    return (Eigen::AngleAxisd(radians.z(), Vec3::UnitZ()) *
            Eigen::AngleAxisd(radians.y(), Vec3::UnitY()) *
            Eigen::AngleAxisd(radians.x(), Vec3::UnitX()))
        .toRotationMatrix();
}

Vec3 turnsOf(const Eigen::Matrix3d& r) {
    constexpr double kUpright = 1 - 1e-12;  // x and z turn about the same axis then
    const double y = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
    const bool upright = std::abs(r(2, 0)) > kUpright;
    const double x = upright ? std::atan2(-r(1, 2), r(1, 1)) : std::atan2(r(2, 1), r(2, 2));
    const double z = upright ? 0 : std::atan2(r(1, 0), r(0, 0));
    return Vec3(x, y, z) * (180 / EIGEN_PI);
}

}  // namespace kerf
