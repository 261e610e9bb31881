#pragma once

#include "sim/run/parts/running_body.h"
#include "sim/run/tear/end_opening.h"

namespace kerf {

/// The blade that advances the end of a slit.
struct TearBlade {
    Vec3 heading = Vec3::Zero();  ///< of the slit now, unit
    Blade from;                   ///< along the end
    Blade to;
};

/// None for an end without a direction.
std::optional<TearBlade> bladeOf(RunningBody& body, const SlitEnd& end, const EndOpening& opening);

/// The blade along a line in the body, out of its skin on both sides.
Blade bladeThrough(RunningBody& body, const Vec3& a, const Vec3& b);

}  // namespace kerf
