#pragma once

#include <span>

#include "render/scene/image.h"
#include "ui/picture_painter.h"
#include "ui/plot.h"

namespace kerf::ui {

/// Draws plots into pictures, for reports and exports: the same plots as in the editor.
class PlotPainter {
  public:
    /// Needs a current OpenGL 4.5 context; text is 15 px high times `scale`.
    explicit PlotPainter(Theme theme = Theme::dark, float scale = 1);

    /// The plots one below the other, of equal heights. `width`, `height` of the picture [pixels].
    render::Image draw(std::span<const PlotSpec> plots, const PlotView& view, int width,
                       int height);

  private:
    PicturePainter painter_;
};

}  // namespace kerf::ui
