#pragma once

#include "render/scene/image.h"

namespace kerf::render {

/// Copies a picture into `target`, its upper left corner at a pixel of that; what has no room is
/// left out.
void paste(Image& target, const Image& picture, int left, int top);

}  // namespace kerf::render
