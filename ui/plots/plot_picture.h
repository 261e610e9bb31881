#pragma once

#include "render/scene/image.h"
#include "ui/base/panel_context.h"
#include "ui/plots/plot.h"

namespace kerf::ui {

/// Small multiples: a plot per panel, in rows.
struct PlotSheet {
    std::string title;  ///< above all of them
    std::span<const PlotSpec> panels;
    int columns = 1;
    int panelWidth = 320;   ///< [pixels]
    int panelHeight = 180;  ///< [pixels]
};

/// Draws plots into pictures, for reports and exports: the same plots as in the editor.
class PlotPainter {
  public:
    /// Needs a current OpenGL 4.5 context; text is 15 px high times `scale`.
    explicit PlotPainter(Theme theme = Theme::dark, float scale = 1);

    /// The plots one below the other, of equal heights. `width`, `height` of the picture [pixels].
    render::Image draw(std::span<const PlotSpec> plots, const PlotView& view, int width,
                       int height);
    /// The panels of a sheet, with one time axis for all; the picture is as large as they need.
    render::Image draw(const PlotSheet& sheet);

  private:
    PicturePainter painter_;
};

}  // namespace kerf::ui
