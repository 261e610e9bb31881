#pragma once

#include "render/scene/image.h"
#include "render/scene/overlays.h"
#include "render/scene/surface_field.h"

namespace kerf::ui {

/// One kind of fault that is marked on a model.
struct FaultRow {
    std::string label;  ///< "12 open edges"
    render::DisplayColor color{};
};
/// A row for each of the marks.
std::vector<FaultRow> faultRows(const std::vector<render::Marks>& marks);

/// Draws the rows into the current window: a line of the colour, and what it means.
void drawFaultRows(const std::vector<FaultRow>& rows);

/// A picture of the rows below a title, as large as they need. Needs a current OpenGL 4.5 context.
render::Image drawFaultLegend(const std::string& title, const std::vector<FaultRow>& rows);

/// The legend of the body's colours, if they show a quantity.
struct FieldLegend {
    render::SurfaceField field = render::SurfaceField::look;
    render::FieldRange range;
    std::optional<double> underPointer;  ///< in the quantity's own unit (share or m)
    const render::ColorMapRow* colors = &render::kColorMaps[0];
    std::string note;  ///< about outdated values; may be empty
};

/// "12.3 %" of a share, "3.5 mm" of a length [m].
std::string fieldText(render::SurfaceField field, double value);

/// Draws the colours from left to right.
void drawColors(const render::ColorMap& map, float left, float top, float width, float height);

/// Draws name, colours and numbers of a quantity into the current window. `scale` is the display's.
void drawFieldScale(const FieldLegend& legend, float scale);

}  // namespace kerf::ui
