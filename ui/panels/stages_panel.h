#pragma once

#include "sim/cut/subdivision_pattern.h"
#include "ui/plots/history.h"

namespace kerf::ui {

/// Draws the time by stage: last, mean, smallest, largest, and the share of all stages, as in the
/// paper's table 3.
void drawStages(const History& history, const SubdivisionCounts& subdivisions);

}  // namespace kerf::ui
