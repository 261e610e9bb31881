#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/layout.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// What to do first or next, in the view: at its lower edge, or in its middle while nothing is
/// open. Takes no input but on the buttons of its choices.
void drawHint(const PanelModel& model, const Rect& view, std::vector<Action>& actions);

}  // namespace kerf::ui
