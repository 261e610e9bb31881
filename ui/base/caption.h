#pragma once

#include <string>

#include "render/scene/image.h"
#include "ui/base/picture_painter.h"

namespace kerf::ui {

/// A line of text on a panel's ground, as large as it needs, to be pasted onto a picture.
render::Image drawCaption(PicturePainter& painter, const std::string& text);

}  // namespace kerf::ui
