#pragma once

#include <vector>

#include "app/tools/tool.h"

namespace kerf::app {

/// Adds the outline of a blade's way.
void addSwept(ui::Overlay& overlay, const std::vector<Blade>& way, const ViewFrame& view);

/// Adds that of a coming cut, if there is any; between two steps also what it would meet of the
/// body.
void addPreview(ui::Overlay& overlay, const std::vector<Blade>& way, const ToolContext& c);

}  // namespace kerf::app
