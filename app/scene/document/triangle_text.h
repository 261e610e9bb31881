#pragma once

#include "sim/mesh/triangle_quality.h"

namespace kerf::app {

/// "768 triangles, 12 slivers; edge length 3.5 mm to 7.8 cm, mean 5.1 cm"
std::string trianglesText(const TriangleFigures& figures);

/// The problem of a coarse skin: "The mesh is coarse: 12 triangles, edges up to 1.41 m".
std::string coarseText(const TriangleFigures& figures, const std::string& longestEdge);

}  // namespace kerf::app
