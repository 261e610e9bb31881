#pragma once

#include <string>
#include <vector>

#include "app/session/metrics.h"
#include "app/session/paper_experiments.h"
#include "render/scene/image.h"

namespace kerf::app {

/// One of the paper's experiments, run.
struct ExperimentResult {
    const PaperExperiment* paper = nullptr;
    RunSummary summary;
    std::vector<std::string> pictures;  ///< PNG files relative to the report, in order
};

/// The text of report.md: the paper's tables and figures remade, its figures beside ours.
/// `published`: solver, contact and course of the cut were the paper's too.
std::string formatExperimentReport(const std::vector<ExperimentResult>& results,
                                   bool published = false);

}  // namespace kerf::app
