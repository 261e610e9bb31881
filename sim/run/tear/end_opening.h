#pragma once

#include <algorithm>

#include "sim/run/parts/cohesive_zone.h"
#include "sim/run/tear/slit_ends.h"

namespace kerf {

/// What the end of a slit is opened by, in the mean over the length of the cohesive zone.
struct EndOpening {
    double atFirst = 0;       ///< at its first vertex, of what makes it advance
    double atLast = 0;        ///< at its last
    Vec3 way = Vec3::Zero();  ///< sum of the ways from W- to W+ [m]
    double most() const { return std::max(atFirst, atLast); }
};

/// Of a mesh with walls of edge length `edge` [m].
EndOpening openingOf(const SurfaceMesh& mesh, const CohesiveZone& cohesion, double edge,
                     const SlitEnd& end);

}  // namespace kerf
