#pragma once

#include "sim/cut/cut_types.h"
#include "sim/run/running_body.h"
#include "sim/run/simulation_parts.h"
#include "sim/run/undo_history.h"

namespace kerf {

/// Lets all that remembers something of the mesh follow a step of the cutter.
void followCut(const CutDelta& delta, RunningBody& body, UndoHistory& history,
               SimulationOutput& output);

}  // namespace kerf
