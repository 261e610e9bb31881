#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// Makes a closed, manifold and oriented surface of a welded soup, as far as it can: drops
/// triangles without area and duplicates, joins borders that nearly meet, reorients triangles,
/// separates the surface where more than two triangles share an edge or parts touch in a vertex,
/// drops loose sheets, and fills holes with triangles like those around. Sound parts stay bit for
/// bit. Separated vertices keep their position; see moveApart(). Without `fillsHoles` holes and
/// sheets stay too, to be thickened. Returns what was done, one phrase each; empty for nothing.
std::vector<std::string> repairSoup(TriangleSoup& welded, bool fillsHoles = true);

}  // namespace kerf::app
