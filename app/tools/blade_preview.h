#pragma once

#include <vector>

#include "app/tools/tool.h"

namespace kerf::app {

/// Adds the outline of a blade's path.
void addSwept(ui::Overlay& overlay, const std::vector<Blade>& way, const ViewFrame& view);

/// Adds the way from where the body is cut up to where the blade is led.
void addLag(ui::Overlay& overlay, const std::vector<Blade>& way, const ViewFrame& view);

/// Adds that of a coming cut, if any; between two steps also its intersection with the body.
void addPreview(ui::Overlay& overlay, const std::vector<Blade>& way, const ToolContext& c);

}  // namespace kerf::app
