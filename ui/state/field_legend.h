#pragma once

#include <optional>
#include <string>

#include "render/scene/surface_field.h"

namespace kerf::ui {

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
