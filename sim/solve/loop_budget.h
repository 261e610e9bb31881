#pragma once

#include <cstdint>

#include "sim/body/body_model.h"

namespace kerf {

/// Mesa's llvmpipe ends all loops of a thread after 65,535 turns together in a dispatch, without a
/// word. Some are spared for what a dispatch does once.
inline constexpr std::size_t kMostTurns = 64000;
inline constexpr std::size_t kSparedTurns = 65535 - kMostTurns;

/// How a group goes through a body: so many of its threads run side by side, and turn as often as
/// the one that needs most. They have a stretch of the vertices each (see small_body_state.glsl).
struct GroupShape {
    std::uint32_t threads;
    std::uint32_t sideBySide;
};

/// Turns of all loops of a thread of small_body.comp, at most, in one sweep of plain PBD: how often
/// their conditions are looked at. SolverLoops.* counts them.
std::size_t turnsOfSweep(const BodyModel& model, const GroupShape& group);

/// The same, in one substep of a body of so many blocks of a page each.
std::size_t turnsOfSubstep(const BodyModel& model, std::size_t blocks, const GroupShape& group);

}  // namespace kerf
