#pragma once

#include "sim/base/params.h"

namespace kerf {

/// The parameters with a time step and a depenetration speed that suit a body of this diagonal [m],
/// rest as it is. What is small falls its own length in less time, so it needs a shorter step; the
/// defaults suit what is from 0.5 to 10 m.
Params suitedTo(double diagonal, Params params);
/// Adapts parameters to a body whose size changed from `before` to `after` [m]. A value that did
/// not suit the old size was somebody's choice, and stays.
Params followSize(double before, double after, Params params);

}  // namespace kerf
