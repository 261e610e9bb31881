#pragma once

#include <string>
#include <vector>

#include "sim/mesh/triangle_soup.h"

namespace kerf::repair {

/// Makes a closed, manifold and oriented surface of a welded soup, as far as it can: drops
/// triangles without area and doubles, joins borders that nearly meet, turns triangles, parts the
/// surface where more than two triangles share an edge or parts touch in a vertex, drops loose
/// sheets, and fills holes with triangles like those around. What is sound stays bit for bit.
/// Vertices that are parted stay at one place; see moveApart(). Without `fillsHoles` holes and
/// sheets stay too, to be thickened. Returns what was done, one phrase each; empty where nothing
/// was.
std::vector<std::string> repairSoup(TriangleSoup& welded, bool fillsHoles = true);

}  // namespace kerf::repair
