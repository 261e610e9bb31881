#pragma once

#include <vector>

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"

namespace kerf::cut {

/// A strip that takes the place of one that was refused: it starts in the material behind the
/// front, on one side of the walls there, and ends on the other, so that the new walls cross the
/// old ones. It has nothing in common with the old front, which stays as the end of a slit.
struct Resumption {
    std::vector<RungNode> rung;  ///< the start, without vertices
    Blade blade;                 ///< the end, moved aside by a share of h
};

/// Ways to start anew behind `rung`, which lead just across the old walls, close beside them, and
/// end a little ahead of it, on the way to `blade`. Where the walls are crumpled they may miss them
/// (leavesBridge). `h`: edge length of walls [m]. Empty where the blade hardly moves.
std::vector<Resumption> resumptions(const std::vector<RungNode>& rung, const Blade& blade,
                                    double h);

}  // namespace kerf::cut
