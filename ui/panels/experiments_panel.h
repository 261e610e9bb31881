#pragma once

#include <vector>

#include "ui/state/action.h"
#include "ui/state/experiment_card.h"

namespace kerf::ui {

/// Draws a card for each of the paper's experiments, its figures beside ours; a click opens it.
void drawExperiments(const std::vector<ExperimentCard>& experiments, std::vector<Action>& actions);

}  // namespace kerf::ui
