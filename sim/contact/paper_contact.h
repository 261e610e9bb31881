#pragma once

#include "sim/body/body_model.h"
#include "sim/body/body_state.h"

namespace kerf {

/// The paper's response to contact, for comparison with ContactSolver: once a time step, on the
/// CPU. Broad phase: boxes of the pieces, then an octree over the triangles of each piece. Narrow
/// phase: an edge of one triangle meets the other one (Möller and Trumbore, 1997). Two triangles
/// that meet lose their relative velocity, each by half of it; a vertex takes the mean of what its
/// triangles ask for, in its velocity and as the way of a time step in its position. What overlaps
/// at the same speed is left where it is, and walls of a slit and arms of one piece do not meet.
/// `timeStep` [s]. Returns how many pairs of triangles meet.
int respondAsThePaper(const BodyModel& model, double timeStep, BodyState& state);

}  // namespace kerf
