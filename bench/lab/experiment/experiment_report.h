#pragma once

#include <string>

#include "bench/lab/experiment/experiment_result.h"
#include "bench/lab/experiment/shader_inventory.h"

namespace kerf::app {

/// The text of report.md: the paper's tables and figures remade, in its order and with its numbers,
/// its figures beside ours. The pictures are those of drawFigures().
std::string formatExperimentReport(const ReportData& data, const ShaderInventory& shaders);

}  // namespace kerf::app
