#pragma once

#include <random>

#include "sim/mesh/triangle_soup.h"

namespace kerf::test {

/// Defects that model files have, by their names: each spoils the soup of a ball, or one that is
/// spoilt already.
const std::map<std::string, std::function<void(TriangleSoup&)>>& modelDefects();

/// The ball that they are made for.
TriangleSoup soundBall();

/// Does something to so many triangles that no name is for.
void damage(TriangleSoup& soup, std::mt19937& random, int count);

}  // namespace kerf::test
