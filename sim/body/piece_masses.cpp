#include "sim/body/piece_masses.h"

#include <algorithm>

namespace kerf {

namespace {

constexpr double kMassFloor = 0.05;    // of the mean vertex mass of the piece
constexpr double kLeastVolume = 1e-9;  // of the uncut body: chips may have none

double massShare(const PieceModel& piece, double area) {
    const double even = kMassFloor / piece.vertexCount;
    return piece.restArea > 0 ? std::max(area / piece.restArea, even) : even;
}

}  // namespace

std::vector<float> buildUnitMasses(const std::vector<PieceModel>& pieces,
                                   const std::vector<int>& pieceOfVertex,
                                   const std::vector<double>& vertexAreas, double uncutRestVolume) {
    std::vector<double> shares(pieceOfVertex.size(), 0.0);
    std::vector<double> sums(pieces.size(), 0.0);
    for (std::size_t v = 0; v < pieceOfVertex.size(); ++v) {
        if (const int piece = pieceOfVertex[v]; piece >= 0) {
            shares[v] = massShare(pieces[piece], vertexAreas[v]);
            sums[piece] += shares[v];
        }
    }
    std::vector<float> masses(pieceOfVertex.size(), 0.0f);
    for (std::size_t v = 0; v < pieceOfVertex.size(); ++v) {
        if (const int piece = pieceOfVertex[v]; piece >= 0) {
            const double volume =
                std::max(pieces[piece].restVolume, kLeastVolume * uncutRestVolume);
            masses[v] = static_cast<float>(volume * shares[v] / sums[piece]);
        }
    }
    return masses;
}

}  // namespace kerf
