#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// A place of the skin that begins to tear.
struct WeakSpot {
    Vec3 at = Vec3::Zero();      ///< [m]
    Vec3 normal = Vec3::Zero();  ///< outwards, unit
    Vec3 along = Vec3::Zero();   ///< in the skin, across the largest stretch, unit
};

/// What does not count where weak spots are sought.
struct StrongPlaces {
    std::vector<Vec3> places;  ///< what is held, and ends of slits, at rest [m]
    double reach = 0;          ///< around each [m]
};

/// The place of the skin that is stretched most, in the mean over three edges around a triangle, if
/// by more than `least`, as a share of its length. O(triangles).
std::optional<WeakSpot> findWeakSpot(const SurfaceMesh& mesh, double least,
                                     const StrongPlaces& strong);

}  // namespace kerf
