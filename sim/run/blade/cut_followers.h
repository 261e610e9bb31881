#pragma once

#include "sim/cut/cut_types.h"
#include "sim/run/parts/running_body.h"
#include "sim/run/parts/simulation_parts.h"
#include "sim/run/undo/undo_history.h"

namespace kerf {

/// Updates all state about the mesh after a step of the cutter.
void followCut(const CutDelta& delta, RunningBody& body, UndoHistory& history,
               SimulationOutput& output);

/// Ends the tear in progress, if there is one, so that another stroke may begin.
void endTear(RunningBody& body, UndoHistory& history, SimulationOutput& output);

/// Updates all state after a step of the cutter, of a blade's stroke or a tear, or after its end.
void followStep(const CutResult& result, RunningBody& body, UndoHistory& history,
                SimulationOutput& output);

}  // namespace kerf
