#pragma once

#include "sim/base/math.h"
#include "sim/mesh/cavities.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The present measurements of one piece.
struct PieceFigures {
    int triangles = 0;
    double skinArea = 0;           ///< [m^2]
    double cutArea = 0;            ///< of the faces of cuts [m^2]
    double volume = 0;             ///< [m^3]
    Vec3 centroid = Vec3::Zero();  ///< of its volume; without volume, of its box [m]
    Bounds bounds;                 ///< [m]
    double area() const { return skinArea + cutArea; }
};

/// Sums the piece that a living triangle belongs to. Reads back what is stale. `shells`: of the
/// present mesh.
PieceFigures figuresOfPiece(const SurfaceMesh& mesh, const PieceShells& shells, int triangle);

}  // namespace kerf
