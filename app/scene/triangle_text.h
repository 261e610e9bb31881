#pragma once

#include <string>

#include "sim/mesh/triangle_quality.h"

namespace kerf::app {

/// "768 triangles, 12 of them needles; edges of 3.5 mm to 7.8 cm, 5.1 cm in the mean."
std::string trianglesText(const TriangleFigures& figures);

/// What it means to make them even, for people: how many there would be, how long their edges, and
/// what is lost.
std::string eveningText(const TriangleFigures& figures);

}  // namespace kerf::app
