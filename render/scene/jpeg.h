#pragma once

#include <string_view>

#include "render/scene/image.h"

namespace kerf::render {

/// How large a JPEG picture is by its head. Throws std::runtime_error with a clause where that is
/// damaged.
PixelRect sizeOfJpeg(std::string_view bytes);
/// Decodes a JPEG picture of sizeOfJpeg(). Throws std::runtime_error with a clause where anything
/// in it is damaged or missing, or it has so many scans (500) that it was made to take long.
Image decodeJpeg(std::string_view bytes);

}  // namespace kerf::render
