#pragma once

#include <Eigen/Core>

#include "sim/base/math.h"

namespace kerf {

/// A static box that bodies collide with (the paper's collidable cubes).
struct StaticBox {
    Vec3 center = Vec3::Zero();  ///< [m]
    Vec3 size = Vec3::Ones();    ///< side lengths along its own axes [m]
    Vec3 rotate = Vec3::Zero();  ///< about the world's x, then y, then z axis [degrees]

    /// Columns: its own axes in the world.
    Eigen::Matrix3d axes() const;
    /// Corner 0 to 7: bit k of the index takes the high side along its own axis k [m].
    Vec3 corner(int index) const;
    /// The axis-parallel box around it.
    Bounds bounds() const;

    bool operator==(const StaticBox&) const = default;
};

/// Limits of checkBox().
inline constexpr double kLeastBoxSize = 1e-6;     ///< [m]
inline constexpr double kLargestBoxSize = 1e6;    ///< [m]
inline constexpr double kFarthestBox = 1e8;       ///< of each coordinate [m]
inline constexpr double kLargestBoxTurn = 36000;  ///< of each angle [degrees]
inline constexpr std::size_t kMostBoxes = 10'000;

/// "" or one sentence about what is wrong with it.
std::string checkBox(const StaticBox& box);

}  // namespace kerf
