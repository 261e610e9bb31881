#pragma once

#include "render/scene/image.h"
#include "ui/base/panel_context.h"

namespace kerf::ui {

/// A picture of a strip.
struct StripPicture {
    render::Image image;
    std::string caption;  ///< below it, wrapped at its width; a first line ends with '\n'
};

/// A row of pictures with a title above and a caption below each of them. All pictures have the
/// size of the first one, else std::invalid_argument.
render::Image drawStrip(PicturePainter& painter, const std::string& title,
                        std::span<const StripPicture> pictures);

}  // namespace kerf::ui
