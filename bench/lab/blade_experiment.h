#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "sim/base/params.h"

namespace kerf::app {

/// Name of the experiment, and of its folder.
inline constexpr const char* kBladeExperiment = "blade";

/// A moment of a blade on its way down into a block.
struct BladePoint {
    double depth = 0;     ///< of the blade as it is led, from the uncut surface [m]
    double force = 0;     ///< upwards, on the blade [N]
    double work = 0;      ///< of what led the blade, until now [J]
    double gained = 0;    ///< energy of the body and of the edge's spring now [J]
    double fracture = 0;  ///< energy of the new surface until now [J]
    double drag = 0;      ///< energy that air drag has taken until now [J]
};

/// What a blade felt in one material.
struct BladeRun {
    std::string label;
    Params params;
    std::vector<BladePoint> points;

    /// The force that a cut as wide as the block takes by itself [N].
    double expected() const;
    /// The highest force until the blade had broken in, and where.
    const BladePoint& rupture() const;
    /// The mean force from one block width behind that on, where the blade cuts evenly [N].
    double plateau() const;
    /// What of the work is found again as energy gained, new surface and drag at the end.
    double found() const;
};

/// Leads a blade down into a block of 6 cm that stands on its pinned bottom, 2 cm/s, 4 cm deep.
/// Runs on the GL context that is current.
BladeRun measureBlade(std::string label, const Params& params);

/// The text of report.md.
std::string formatBladeReport(const std::vector<BladeRun>& runs);

/// Runs `kerf experiment blade`: measureBlade() in materials and with blades of different
/// bluntness. Writes report.md, summary.json, forces.csv and forces.png into DIR/blade, and prints
/// the report, or with `json` the summary. Returns 0, or 1 where more than 5 % of the work was not
/// found again. Throws OutputError, gpu::ContextError.
int runBladeExperiment(const std::filesystem::path& folder, bool json, std::ostream& out,
                       std::ostream& errors);

}  // namespace kerf::app
