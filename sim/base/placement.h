#pragma once

#include <Eigen/Core>

#include "sim/base/math.h"

namespace kerf {

/// A unit that the numbers of a model are in, in the order of kLengthUnitNames.
enum class LengthUnit { metre, centimetre, millimetre, micrometre, kilometre, inch, foot };

inline constexpr std::string_view kLengthUnitNames[] = {"m", "cm", "mm", "um", "km", "in", "ft"};
constexpr std::string_view nameOf(LengthUnit unit) {
    return kLengthUnitNames[static_cast<std::size_t>(unit)];
}

struct LengthUnitInfo {
    std::string_view plural;  ///< "millimetres"
    double metres = 1;        ///< in one of it
};
const LengthUnitInfo& infoOf(LengthUnit unit);

/// The axis of a model that points up, in the order of kUpAxisNames.
enum class UpAxis { y, z, x, minusY, minusZ, minusX };
inline constexpr std::string_view kUpAxisNames[] = {"y", "z", "x", "-y", "-z", "-x"};
constexpr std::string_view nameOf(UpAxis up) {
    return kUpAxisNames[static_cast<std::size_t>(up)];
}

/// How the numbers of a model become metres in the scene, where +y is up: they are taken in their
/// unit, the model's up axis is brought to +y; then scale, then rotate (about the scene's x, then
/// y, then z axis; degrees), then translate [m].
struct Placement {
    std::optional<LengthUnit> unit;  ///< metres if not set
    std::optional<UpAxis> up;        ///< y if not set
    double scale = 1;
    Vec3 rotate = Vec3::Zero();
    Vec3 translate = Vec3::Zero();

    double metresPerUnit() const { return unit ? infoOf(*unit).metres : 1; }
    /// Where a point of the model lies in the scene [m].
    Vec3 apply(const Vec3& own) const;
    bool operator==(const Placement&) const = default;
};

/// A placement, ready for many points.
class PlacementMap {
  public:
    explicit PlacementMap(const Placement& placement);

    /// Maps a point of the model, in the unit of its file, into the scene [m].
    Vec3 toScene(const Vec3& own) const;
    /// Maps a point of the scene [m] to the coordinates of the model's file.
    Vec3 toModel(const Vec3& placed) const;

  private:
    Placement placement_;
    UpAxis up_;
    double metres_;
    Eigen::Matrix3d turn_;
};

/// The origin of the simulation, so that floats suffice for models in `placed` [m]: 0 along each
/// axis where that is near, else a round number in their middle, from which coordinates differ
/// without rounding.
Vec3 originOf(const Bounds& placed);

/// "", or one sentence if a model is too small, or too far from `origin`, for floats, whose spacing
/// grows with that distance.
std::string checkRoom(const Bounds& placed, const Vec3& origin = Vec3::Zero());

/// Turns about the world's x, then y, then z axis [degrees].
Eigen::Matrix3d turnOf(const Vec3& degrees);
/// The angles of such turns that give a rotation, each from -180 to 180 [degrees].
Vec3 turnsOf(const Eigen::Matrix3d& rotation);

/// All points within `radius` of `center` [m].
struct Ball {
    Vec3 center = Vec3::Zero();
    double radius = 0;
};

/// A part of space: that of a brush or a box.
using Region = std::variant<Ball, Bounds>;

inline bool contains(const Region& region, const Vec3& p) {
    if (const auto* ball = std::get_if<Ball>(&region)) {
        return (p - ball->center).squaredNorm() <= ball->radius * ball->radius;
    }
    const Bounds& box = std::get<Bounds>(region);
    return (p.array() >= box.low.array()).all() && (p.array() <= box.high.array()).all();
}

}  // namespace kerf
