#pragma once

#include "sim/cut/cut_types.h"

namespace kerf {

/// A result that holds nothing else.
CutResult outcome(CutOutcome what);

/// One outcome for several pieces: the later one in the list of CutOutcome, but a cut before a
/// refusal, since it changed the mesh.
void addTo(CutResult& sum, const CutResult& part);

}  // namespace kerf
