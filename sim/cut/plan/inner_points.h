#pragma once

#include <vector>

#include "sim/cut/plan/places_in_strip.h"
#include "sim/cut/plan/rest_guess.h"
#include "sim/cut/plan/sheet_border.h"

namespace kerf::cut {

/// Puts nodes into a sheet that is taller than one edge, as far apart as edges are long there.
/// `nodes`: those of the border.
void addInnerPoints(const StepInput& in, const RestGuess& guess, const PlacesInStrip& places,
                    const std::vector<CutNode>& nodes, BorderedSheet& sheet);

}  // namespace kerf::cut
