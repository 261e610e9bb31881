#pragma once

#include "ui/panel_model.h"

namespace kerf::ui {

/// What the stages of a step took.
void drawStages(const StageTimes& stages, const SubdivisionCounts& subdivisions);

}  // namespace kerf::ui
