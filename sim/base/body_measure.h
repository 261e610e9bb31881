#pragma once

#include <vector>

#include "sim/base/math.h"

namespace kerf {

/// The numbers that the CPU learns from the GPU after a step, without reading the body back.
struct BodyMeasure {
    std::vector<double> pieceVolumes;  ///< [m^3]
    std::vector<Bounds> pieceBounds;   ///< [m]
    Bounds bounds;                     ///< of the living triangles [m]
    double fastest = 0;                ///< no vertex is faster [m/s]
    /// Pieces with a vertex that is not finite or faster than runawaySpeed(), or that have grown
    /// beyond kLargestPiece; ascending.
    std::vector<int> lostPieces;
    int contacts = 0;          ///< of the body with itself in the last substep
    double kineticEnergy = 0;  ///< of the vertices that are free to move [J]
    /// The energy of free vertices in the field of gravity above the floor, or above 0 [J].
    double potentialEnergy = 0;
    /// The energy of the strained material: the sum of C^2 / (2 alpha) over edges, bends and ISPCs
    /// that are on and not rigid; means nothing with plain PBD [J].
    double strainEnergy = 0;
};

}  // namespace kerf
