#pragma once

#include "sim/base/math.h"
#include "sim/mesh/cavities.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// What one piece measures as it is now.
struct PieceFigures {
    int triangles = 0;
    double skinArea = 0;           ///< [m^2]
    double cutArea = 0;            ///< of the faces of cuts [m^2]
    double volume = 0;             ///< [m^3]
    Vec3 centroid = Vec3::Zero();  ///< of its volume; of its box where it has none [m]
    Bounds bounds;                 ///< [m]
    double area() const { return skinArea + cutArea; }
};

/// Adds up the piece that a living triangle belongs to. Reads back what is old of it. `shells`: of
/// the mesh as it is.
PieceFigures figuresOfPiece(const SurfaceMesh& mesh, const PieceShells& shells, int triangle);

}  // namespace kerf
