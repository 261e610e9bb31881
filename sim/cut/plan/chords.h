#pragma once

#include "sim/cut/plan/places_in_strip.h"
#include "sim/cut/plan/sheet_border.h"

namespace kerf::cut {

/// Turns edges of a sheet that join two border nodes of one face of the mesh: they would lie in the
/// surface and close a chip of no thickness. Where no turn helps, an inner node leads the sheet
/// away from the face; so it does from two faces side by side in one plane.
void clearChords(const StepInput& in, const PlacesInStrip& places, BorderedSheet& sheet);

}  // namespace kerf::cut
