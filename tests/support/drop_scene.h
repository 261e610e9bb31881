#pragma once

#include "sim/base/params.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::test {

/// A body, whole or cut in half at rest, falls on the floor.
struct DropScene {
    Params params;        ///< gravity acts from the fall on; the floor is placed below the body
    double height = 0.5;  ///< of the fall [m]
    double seconds = 3;   ///< from the start of the fall
    bool cut = false;     ///< by a blade that comes straight down through the middle
    double azimuth = 0;   ///< of that blade about the vertical, from z towards x [rad]
};

/// What came of it. Volumes in shares of rest, from the start of the fall.
struct DropFigures {
    int pieces = 0;
    int triangles = 0;
    double meanVolume = 0;
    double leastVolume = 1;
    double finalVolume = 0;
    double peakError = 0;   ///< largest RMS shape error of a piece, share of the body's diagonal
    double finalError = 0;  ///< at the end
    /// Both again, as a share of the diagonal of the piece at rest, which is smaller than the body.
    double peakErrorOfPiece = 0;
    double finalErrorOfPiece = 0;
    int folds = 0;          ///< edges bent by more than 90 degrees from rest at the end
    double finalSpeed = 0;  ///< of the fastest vertex [m/s]
    int messages = 0;       ///< refused cuts, pieces that had to be brought back
};

/// Plays a drop with a Simulation on the GL context that is current.
DropFigures playDrop(SurfaceMesh mesh, const DropScene& scene);

/// A table as text.
std::string dropTableHead();
std::string dropTableRow(const std::string& name, const DropFigures& figures);

}  // namespace kerf::test
