#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::test {

/// The height of a sheet above a point of the unit square.
using Height = std::function<double(double x, double z)>;

/// An open surface over the unit square in x and z: n x n quads that face up, bent to a height.
TriangleSoup sheetSoup(
    int n, const Height& height = [](double, double) { return 0.0; });

}  // namespace kerf::test
