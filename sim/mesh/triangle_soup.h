#pragma once

#include <vector>

#include "sim/base/math.h"
#include "sim/mesh/skin_attributes.h"

namespace kerf {

/// Triangles as a file gives them: nothing is guaranteed.
struct TriangleSoup {
    std::vector<Vec3> positions;  ///< [m]
    std::vector<Triangle> triangles;
    SkinAttributes skin{};  ///< by triangle
};

/// Joins vertices with bit-equal coordinates (-0 equals 0) and drops unused ones. The order of
/// first use is kept. Indices must be in range.
TriangleSoup weldExactly(const TriangleSoup& soup);

/// From where floats are counted that are to hold the positions: see originOf().
Vec3 floatOrigin(const TriangleSoup& soup);
/// Rounds all positions to floats, as files hold them, and joins those that are equal then.
void roundToFloats(TriangleSoup& soup);

/// Lets a triangle face the other way, with its attributes.
void turnTriangle(TriangleSoup& soup, int t);

}  // namespace kerf
