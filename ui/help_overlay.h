#pragma once

#include <vector>

#include "ui/state/action.h"

namespace kerf::ui {

struct PanelModel;

/// Draws all keys and gestures, made from the table of actions, over everything while the help is
/// open.
void drawHelp(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui
