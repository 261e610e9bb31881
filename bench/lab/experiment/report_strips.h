#pragma once

#include <string>

#include "bench/lab/experiment/experiment_result.h"
#include "bench/lab/experiment/report_figures.h"

namespace kerf::app {

/// A figure of strips, one below the other, with its caption: "**Figure 5.** Cutting simulation:
/// (a) Sphere 20: time step 0.005 s, 30 iterations; (b) ...". `partOf` says which strip an
/// experiment has. Nothing where no experiment has one in this figure.
std::string stripFigure(const ReportData& data, int figure, const std::string& title,
                        FigurePart (*partOf)(const PaperExperiment&));

}  // namespace kerf::app
