#pragma once

#include <vector>

#include "sim/cut/plan/step.h"

namespace kerf::cut {

/// What of a rung goes on in one step.
struct RungPart {
    std::vector<RungNode> rung;
    BladeSpan span;
    /// Which nodes of the whole rung it takes the place of.
    int first = 0;
    int count = 0;
    int beforeFirst = 0;  ///< nodes of `rung` before these: 1 where the part begins in the air
};

/// Where the blade is behind the rung, seen in the direction `heading` in which the cut goes on.
bool isPartlyBehind(const Blade& blade, double h, const Vec3& heading,
                    const std::vector<RungNode>& rung);

/// The parts of `rung` (positions up to date, s along the blade) that the blade is ahead of, by
/// `least` [m] somewhere; from A to B. Each ends where the blade does, in the air where the blade
/// crosses the rung, or at an inner node of the front, which stays.
std::vector<RungPart> partsAhead(const Blade& blade, double h, double least, const Vec3& heading,
                                 const std::vector<RungNode>& rung);

/// The same of a rung in the air, which has no heading: on both sides of where the blade crosses
/// it. None where it does not.
std::vector<RungPart> partsInAir(const Blade& blade, double h, const std::vector<RungNode>& rung);

/// The rung with `next` in the place of the part.
std::vector<RungNode> replaced(const std::vector<RungNode>& rung, const RungPart& part,
                               const std::vector<RungNode>& next);

/// The rung without the front edges of the part.
std::vector<RungNode> stayingFront(const std::vector<RungNode>& rung, const RungPart& part);

/// How the blade went on from the old rung where the new one has mesh vertices. Zero where there
/// are none, or where the way is too short to tell its direction.
Vec3 advanceOf(const Blade& blade, double h, const std::vector<RungNode>& from,
               const std::vector<RungNode>& next);

}  // namespace kerf::cut
