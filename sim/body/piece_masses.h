#pragma once

#include <vector>

#include "sim/body/body_model.h"

namespace kerf {

/// BodyModel::unitMass from the pieces and the rest areas of the vertices [m^2]. The sum over a
/// piece is its rest volume: cutting neither makes nor loses mass. A vertex weighs at least about
/// 5 % of the mean of its piece: lighter ones are thrown about by slivers.
std::vector<float> buildUnitMasses(const std::vector<PieceModel>& pieces,
                                   const std::vector<int>& pieceOfVertex,
                                   const std::vector<double>& vertexAreas, double uncutRestVolume);

}  // namespace kerf
