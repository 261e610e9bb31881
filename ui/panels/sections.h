#pragma once

#include <vector>

#include "ui/state/action.h"

namespace kerf::ui {

/// Draws the heading of a part of a panel that a click folds away. `id` is its name in
/// Settings::folded. False where it is folded: then nothing of it is drawn.
bool beginSection(const char* id, const char* title, const Settings& settings,
                  std::vector<Action>& actions);

}  // namespace kerf::ui
