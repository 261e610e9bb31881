#pragma once

#include <string>
#include <vector>

#include "render/scene/image.h"
#include "render/scene/marks.h"

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

}  // namespace kerf::ui
