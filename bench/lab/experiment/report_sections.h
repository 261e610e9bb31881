#pragma once

#include <string>

#include "bench/lab/experiment/experiment_result.h"
#include "bench/lab/experiment/shader_inventory.h"

namespace kerf::app {

// The sections of report.md, in the order of the paper. Each returns Markdown that ends with an
// empty line, and nothing where the runs give it nothing to tell.

/// What differs from the paper and why, then each figure that is far from the paper's.
std::string differencesSection(const ReportData& data);
/// Table 1 and figure 2 (the paper's section 2).
std::string methodSection(const ReportData& data, const ShaderInventory& shaders);
/// Table 2, figures 5 and 6, and how triangles were divided (3.1).
std::string cuttingSection(const ReportData& data);
/// Figures 7 and 8, figure 10 with its volumes (3.2).
std::string deformationSection(const ReportData& data);
/// Figure 9 and table 3 (3.2 and 3.3).
std::string performanceSection(const ReportData& data);
/// The ways to find the triangles near the blade, compared: the paper's main claim (3.3).
std::string searchSection(const ReportData& data);
/// All settings of each run.
std::string settingsSection(const ReportData& data);

}  // namespace kerf::app
