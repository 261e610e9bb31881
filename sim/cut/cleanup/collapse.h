#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "sim/cut/cleanup/local_patch.h"
#include "sim/cut/cleanup/workspace.h"

namespace kerf::cut {

/// The collapse of a material edge, all copies together, ready to be carried out.
struct CollapsePlan {
    int from = -1;  ///< a copy of the point that goes
    int to = -1;    ///< a copy of the point that stays
    /// Vertices of the one that merge into vertices of the other, along an edge each.
    std::vector<std::pair<int, int>> merges;
    std::vector<Patch> patches;
    double score = 0;      ///< of the worst triangle after it
    double deviation = 0;  ///< summed up with that of earlier operations [m]
    VolumeDefect defect;
};

/// Where the remaining point goes.
enum class CollapseTarget { end, middle };

/// Whether and how `from` may collapse into `to`: see the design of each test in the source.
/// Whether the surface would pass through itself, which takes longer, is left to ask of the plan
/// that is chosen.
std::optional<CollapsePlan> planCollapse(const Workspace& workspace, const MaterialStar& from,
                                         const MaterialStar& to, CollapseTarget target);

/// Merges the vertices, moves the copies, updates mates.
void carryOut(const CollapsePlan& plan, Workspace& workspace);

}  // namespace kerf::cut
