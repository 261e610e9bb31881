#pragma once

#include "sim/cut/cut_types.h"

namespace kerf {

/// The result of a step that changed nothing and has this outcome.
CutResult outcome(CutOutcome what);

/// Adds the result for one piece to the sum over several. The outcome becomes the later one in the
/// list of CutOutcome, but a cut precedes a refusal, since it changed the mesh.
void addTo(CutResult& sum, const CutResult& part);

/// Adds a later clean-up of a stroke to an earlier one.
void addTo(CleanupStatistics& sum, const CleanupStatistics& later);

}  // namespace kerf
