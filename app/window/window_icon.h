#pragma once

#include "render/scene/image.h"

namespace kerf::app {

/// The icon of the window, 64 x 64 pixels: a fruit with a bright blade through it, on nothing.
render::Image windowIcon();

}  // namespace kerf::app
