#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/cut/blade.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/run/tear/slit_ends.h"

namespace kerf {

/// A place of the skin that begins to tear.
struct WeakSpot {
    Vec3 at = Vec3::Zero();      ///< [m]
    Vec3 normal = Vec3::Zero();  ///< outwards, unit
    Vec3 along = Vec3::Zero();   ///< in the skin, across the largest stretch, unit
};

/// What does not count where weak spots are sought.
struct StrongPlaces {
    std::vector<std::uint32_t> held;  ///< vertices that are pinned or pulled, ascending
    std::vector<Vec3> ends;           ///< of slits, at rest [m]
    double nearEnds = 0;              ///< distance at rest within which those count instead [m]
};

/// The triangle of the skin that is stretched most, if by more than `least`, as a share of its
/// length. O(triangles).
std::optional<WeakSpot> findWeakSpot(const SurfaceMesh& mesh, double least,
                                     const StrongPlaces& strong);

/// A short blade above a weak spot, and the same pressed into it, for edges of a length [m].
struct Notch {
    Blade from;
    Blade to;
};
Notch notchAt(const WeakSpot& spot, double edge);

}  // namespace kerf
