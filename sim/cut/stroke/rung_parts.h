#pragma once

#include "sim/cut/plan/input/step.h"

namespace kerf::cut {

/// The part of a rung that advances in one step.
struct RungPart {
    std::vector<RungNode> rung;  ///< its nodes, with those added where it ends in the air
    BladeSpan span;              ///< the part of the blade ahead of it
    int first = 0;               ///< the first node of the whole rung that belongs to it
    int count = 0;               ///< how many nodes of the whole rung belong to it
    int beforeFirst = 0;  ///< nodes of `rung` before these: 1 where the part begins in the air
};

/// Whether the blade is behind the rung somewhere, in the direction `heading` of the cut. `h`: edge
/// length about the rung [m].
bool isPartlyBehind(const Blade& blade, double h, const Vec3& heading,
                    const std::vector<RungNode>& rung);

/// The parts of `rung` (positions up to date, s along the blade) that the blade is ahead of, by
/// `least` [m] somewhere; from A to B. Each ends at the blade's end, in the air where the blade
/// crosses the rung, or at an inner node of the front, which stays.
std::vector<RungPart> partsAhead(const Blade& blade, double h, double least, const Vec3& heading,
                                 const std::vector<RungNode>& rung);

/// The parts of a rung in the air, which has no heading, on both sides of its crossing with the
/// blade. None if they don't cross.
std::vector<RungPart> partsInAir(const Blade& blade, double h, const std::vector<RungNode>& rung);

/// The rung with the part replaced by `next`.
std::vector<RungNode> replaced(const std::vector<RungNode>& rung, const RungPart& part,
                               const std::vector<RungNode>& next);

/// The rung without the front edges of the part.
std::vector<RungNode> stayingFront(const std::vector<RungNode>& rung, const RungPart& part);

/// The sum of the blade's motions from the old rung to the mesh vertices of the new one [m]. Zero
/// for none, or if too short to have a direction.
Vec3 advanceOf(const Blade& blade, double h, const std::vector<RungNode>& from,
               const std::vector<RungNode>& next);

}  // namespace kerf::cut
