#pragma once

#include <vector>

#include "sim/base/math.h"
#include "sim/mesh/skin_attributes.h"

namespace kerf {

/// Triangles as a file gives them: nothing is guaranteed.
struct TriangleSoup {
    std::vector<Vec3> positions;  ///< [m]
    std::vector<Triangle> triangles;
    SkinAttributes skin{};       ///< by triangle
    std::vector<int> objects{};  ///< by triangle: which of the file's objects; empty: there is one
};

/// Joins vertices with bit-equal coordinates (-0 equals 0) and drops unused ones. The order of
/// first use is kept. Indices must be in range.
TriangleSoup weldExactly(const TriangleSoup& soup);

/// Joins vertices with bit-equal coordinates as weldExactly(), but not those of solids that touch:
/// what is closed by its own vertices, or once its object is welded by itself, stays apart from the
/// rest, unless it has a triangle in common with another solid and both face the same way. Then
/// `objects` numbers what has no vertex in common; it stays empty where nothing told of objects.
TriangleSoup weldObjects(const TriangleSoup& soup);

/// From where floats are counted that are to hold the positions: see originOf().
Vec3 floatOrigin(const TriangleSoup& soup);
/// Rounds all positions to floats, as files hold them, and joins those that are equal then.
void roundToFloats(TriangleSoup& soup);

/// Lets a triangle face the other way, with its attributes.
void turnTriangle(TriangleSoup& soup, int t);

}  // namespace kerf
