#pragma once

#include <string_view>

#include "render/scene/image.h"

namespace kerf::render {

/// The size of a JPEG image from its header. Throws std::runtime_error with a clause if that is
/// damaged.
PixelRect sizeOfJpeg(std::string_view bytes);
/// Decodes a JPEG image of sizeOfJpeg(). Throws std::runtime_error with a clause if anything in it
/// is damaged or missing, or if it has too many scans (500), which would take long.
Image decodeJpeg(std::string_view bytes);

}  // namespace kerf::render
