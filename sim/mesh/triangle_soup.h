#pragma once

#include "sim/base/math.h"
#include "sim/mesh/skin_attributes.h"

namespace kerf {

/// Triangles as read from a file: nothing is guaranteed.
struct TriangleSoup {
    std::vector<Vec3> positions;  ///< [m]
    std::vector<Triangle> triangles;
    SkinAttributes skin{};       ///< by triangle
    std::vector<int> objects{};  ///< by triangle: number of the file's object; empty for one

    template <class Io>
    void archive(Io& io) {
        io(positions, triangles, skin, objects);
    }
};

/// Joins vertices with bit-equal coordinates (-0 equals 0) and drops unused ones. The order of
/// first use is kept. Indices must be in range.
TriangleSoup weldExactly(const TriangleSoup& soup);

/// Joins vertices with bit-equal coordinates like weldExactly(), but not those of touching solids:
/// what is closed by its own vertices, or once its object is welded alone, stays separate, unless
/// it shares a triangle of the same orientation with another solid. Then `objects` numbers what
/// shares no vertex; it stays empty if the file has no objects.
TriangleSoup weldObjects(const TriangleSoup& soup);

/// The origin of floats for the positions: see originOf().
Vec3 floatOrigin(const TriangleSoup& soup);
/// Rounds all positions to floats, as in files, and joins equal ones.
void roundToFloats(TriangleSoup& soup);

/// Reverses a triangle, with its attributes.
void turnTriangle(TriangleSoup& soup, int t);

/// The surface of an axis-parallel box around the origin, two triangles for each square of a grid
/// of `cells` (at least 1 along each axis). Diagonals alternate (Union Jack pattern), so that faces
/// resist shear equally in both directions. Closed, outward-oriented.
TriangleSoup boxSurface(const Vec3& size, const std::array<int, 3>& cells);

}  // namespace kerf
