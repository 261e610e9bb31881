#pragma once

#include "sim/base/params.h"

namespace kerf {

/// The longest implicit step that errs by a few hundredths of a motion: less than a wave needs to
/// cross a member of this diagonal [m], Young's modulus [Pa] and density [kg/m^3], between 1/200
/// and 1/60 s; of a smaller iterationError shorter by its root. From swings measured at 1/240 and
/// 1/120 s, see docs/notes/implicit-steps.md. [s]
double longestImplicitStep(double diagonal, double modulus, double density, const Params& params);

/// The parameters with a time step and a depenetration speed for a body of this diagonal [m], the
/// rest unchanged: the longest step that material and size allow. A small body falls its own length
/// in less time, so it needs a shorter one.
Params suitedTo(double diagonal, Params params);
/// Adapts parameters to a body whose size changed from `before` to `after` [m]. A value that
/// differs from that for the old size was set by the user, and stays.
Params followSize(double before, double after, Params params);

}  // namespace kerf
