#pragma once

#include "sim/base/params.h"

namespace kerf {

/// The parameters with a time step and a depenetration speed for a body of this diagonal [m], the
/// rest unchanged. A small body falls its own length in less time, so it needs a shorter step; the
/// defaults suit 0.5 to 10 m.
Params suitedTo(double diagonal, Params params);
/// Adapts parameters to a body whose size changed from `before` to `after` [m]. A value that
/// differs from that for the old size was set by the user, and stays.
Params followSize(double before, double after, Params params);

}  // namespace kerf
