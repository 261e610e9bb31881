#pragma once

#include <imgui.h>

#include "ui/state/action_table.h"

namespace kerf::ui {

/// Draws the icon of an action, if it has one, into a square from `low` on [px].
void drawIcon(ActionId id, const ImVec2& low, float side, ImU32 color);

}  // namespace kerf::ui
