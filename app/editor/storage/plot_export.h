#pragma once

#include <span>
#include <string>

#include "ui/plots/plot.h"

namespace kerf::app {

/// The values of plots as a CSV file, a row per value: `plot,curve,time,mean,min,max,values`. The
/// last three describe values that a long run has merged into one row.
std::string formatPlots(std::span<const ui::PlotSpec> plots);

}  // namespace kerf::app
