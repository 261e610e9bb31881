#pragma once

#include <optional>

#include "sim/contact/static_box.h"

namespace kerf::app {

/// A cube of a third of the body's size on its right, on the floor or level with its underside.
/// `body` are its bounds, `floor` is a height [m].
StaticBox boxBeside(const Bounds& body, std::optional<double> floor);

}  // namespace kerf::app
