#pragma once

#include <functional>

#include "render/scene/image.h"
#include "ui/base/panel_context.h"

namespace kerf::ui {

/// Draws the content of a panel into pictures without a window, for reports and exports.
class PicturePainter {
  public:
    /// Needs a current OpenGL 4.5 context; text is 15 px high times `scale`.
    explicit PicturePainter(Theme theme = Theme::dark, float scale = 1);

    /// A picture of `width` x `height` pixels. `content` adds items to a panel that fills it; it is
    /// called twice.
    render::Image draw(int width, int height, const std::function<void()>& content);
    /// Makes the fonts and colours of this painter current, to measure text before drawing.
    void makeCurrent() const { context_.makeCurrent(); }

  private:
    PanelContext context_;
};

}  // namespace kerf::ui
