#pragma once

#include "ui/plots/plot_math.h"

namespace kerf::ui {

/// A preview of the tool's work, drawn over the view, in pixels of the picture.
struct Overlay {
    using Line = std::array<PlotPoint, 2>;
    using Face = std::array<PlotPoint, 3>;
    /// A point that can be dragged.
    struct Handle {
        PlotPoint at;
        bool hot = false;  ///< under the pointer, or held
    };

    std::vector<Face> touched;   ///< triangles that will be cut
    std::vector<Line> swept;     ///< outline of the blade's path
    std::vector<Line> wound;     ///< its intersection with the surface
    std::vector<PlotPoint> lag;  ///< way from where the body is cut up to the blade
    std::vector<Line> guides;    ///< reach of the tool
    std::vector<Handle> handles;
    /// A number beside the body.
    struct Label {
        PlotPoint at;
        std::string text;
    };
    /// A part of a gizmo, in the colour of its axis: 0 to 2, -1 for none.
    struct AxisLine {
        Line line;
        int axis = -1;
        bool hot = false;
    };
    struct AxisDot {
        PlotPoint at;
        int axis = -1;
        bool hot = false;
        bool square = false;  ///< it sizes
    };
    std::vector<AxisLine> axisLines;
    std::vector<AxisDot> axisDots;
    /// A line of a task that is practised.
    struct Trace {
        enum class Kind { line, band, spared, last, expert, near, far };

        Kind kind;
        Line line;
    };
    std::vector<Trace> traces;
    bool chooses = false;         ///< a click would select something
    std::vector<PlotPoint> dots;  ///< measured points, or those that a press would hold
    std::vector<Label> labels;
};

/// Draws the overlay behind all panels; it takes no input. `scale` is the display's (1 = 96 dpi).
void drawOverlay(const Overlay& overlay, float scale);

}  // namespace kerf::ui
