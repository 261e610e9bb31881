#pragma once

#include "sim/cut/cleanup/one_ring.h"
#include "sim/cut/cleanup/workspace.h"

namespace kerf::cut {

/// The collapse of a shared edge, all copies together, ready to be carried out.
struct CollapsePlan {
    int from = -1;  ///< a copy of the point that goes
    int to = -1;    ///< a copy of the point that stays
    /// Copies of the point that goes and copies of the one that stays into which they merge, along
    /// an edge each.
    std::vector<std::pair<int, int>> merges;
    std::vector<OneRing> rings;  ///< changes around each copy that stays
    double score = 0;            ///< score of the worst triangle after the collapse
    double deviation = 0;        ///< summed up with that of earlier operations [m]
    VolumeDefect defect;         ///< the volume that changes
};

/// The place to which the remaining point goes: the end that stays, or the edge's middle.
enum class CollapseTarget { end, middle };

/// Plans how `from` collapses into `to`; nothing if it may not (each test says why in the source).
/// Does not check for self-intersections, which takes longer: ask addsPiercings() of the chosen
/// plan.
std::optional<CollapsePlan> planCollapse(const Workspace& workspace, const SharedStar& from,
                                         const SharedStar& to, CollapseTarget target);

/// Carries out a plan: merges the vertices, joins and moves the copies.
void carryOut(const CollapsePlan& plan, Workspace& workspace);

}  // namespace kerf::cut
