#pragma once

#include <vector>

#include "ui/state/action.h"

namespace kerf::ui {

/// Draws the heading of a collapsible section. `id` is its name in Settings::folded. Returns false
/// if collapsed: then draw nothing of it.
bool beginSection(const char* id, const char* title, const Settings& settings,
                  std::vector<Action>& actions);

}  // namespace kerf::ui
