#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/lab/fem/fem_run.h"
#include "bench/lab/fem/loaded_surface.h"

namespace kerf::app {

/// The most by which Kerf may differ: sag, opening and volume as a share of those of the finite
/// elements, the shape as a share of the diagonal of the unloaded body.
inline constexpr double kFemBar = 0.15;
inline constexpr double kFemShapeBar = 0.05;

/// What is measured of a body under its load; none of what does not apply to it.
struct FemFigures {
    std::optional<double> sag;      ///< [m]
    std::optional<double> opening;  ///< [m]
    double volumeRatio = 1;
};
FemFigures figuresOf(const FemCase& each, const LoadedSurface& surface);

/// A case that was run.
struct FemResult {
    std::string name;  ///< of the case
    std::string body;
    std::string cut;
    std::string setting;  ///< the label
    FemFigures kerf;
    FemFigures elements;
    FemFigures coarse;  ///< of the larger elements
    ShapeDeviation shape;
    double diagonal = 0;  ///< of the unloaded body [m]
    bool settled = true;
    int steps = 0;
    std::string stateHash;
    std::string tooFew;   ///< see KerfRun
    std::string picture;  ///< file below the report
    std::string session;

    std::optional<double> sagDeviation() const;      ///< as a share of the elements' sag
    std::optional<double> openingDeviation() const;  ///< as a share of the elements' opening
    double volumeDeviation() const;
    double shapeShare() const { return shape.largest / diagonal; }
    /// Whether all of it is within the bars.
    bool holds() const;
};

/// The text of report.md.
std::string formatFemReport(const std::vector<FemResult>& results);
/// The text of summary.json.
std::string formatFemSummary(const std::vector<FemResult>& results);

}  // namespace kerf::app
