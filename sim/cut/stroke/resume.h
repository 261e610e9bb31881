#pragma once

#include <vector>

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"

namespace kerf::cut {

/// A strip that replaces a refused one: it starts in the material behind the front, on one side of
/// the walls there, and ends on the other, so that the new walls cross the old ones. It does not
/// share the old front, which stays as the end of a slit.
struct Resumption {
    std::vector<RungNode> rung;  ///< the start, without vertices
    Blade blade;                 ///< the end, offset sideways by a share of h
};

/// Restarts behind `rung`, which cross the old walls close to their end and end a little ahead of
/// it, towards `blade`. Where the walls are crumpled they may miss them (leavesBridge). `h`: edge
/// length of walls [m]. Empty if the blade hardly moves.
std::vector<Resumption> resumptions(const std::vector<RungNode>& rung, const Blade& blade,
                                    double h);

}  // namespace kerf::cut
