#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// The outcome of fillHoles().
struct HoleFilling {
    int holes = 0;
    int triangles = 0;  ///< that were added
};

/// Closes each hole of a welded soup, a loop of edges that have one triangle, with triangles of
/// small area that hardly bend, none of them without area; `evenly` makes them as large as those
/// around and smooths them, but where a border passes one place twice, or a hole stays open. What
/// was there stays bit for bit. A soup that is not manifold or not consistently oriented stays
/// open, and so does a hole that cannot be triangulated.
HoleFilling fillHoles(TriangleSoup& welded, bool evenly = false);

/// Remeshes a closed, manifold, oriented soup to edges of about `edge` [m], on its own surface.
/// Preserves lines along which it is bent by more than 40 degrees, and those between materials.
/// `onRound` is called before each round, counted from 0; it may throw to end the work.
void remesh(TriangleSoup& soup, double edge,
            const std::function<void(int round)>& onRound = nullptr);

}  // namespace kerf::app
