#pragma once

#include "sim/base/params.h"

namespace kerf::app {

/// The physics of a body of this height [m] and volume [m^3]: its weight, and whether the material
/// carries it. Some sentences for people.
std::string sizeEffect(double height, double volume, const Params& params);

}  // namespace kerf::app
