#pragma once

#include <filesystem>
#include <string>

#include "bench/lab/experiment/experiment_result.h"

namespace kerf::app {

/// A part of one of the paper's figures: 5 and 'b'.
struct FigurePart {
    int figure = 0;
    char letter = 'a';

    /// The picture of the part, relative to the report: "figures/figure-5b.png".
    std::string file() const;
    /// "(b)"
    std::string label() const;
};
/// Where the paper shows the cut of an experiment (figures 5 and 6), its fall (7 and 8) and its
/// volume (10).
FigurePart cuttingFigure(const PaperExperiment& experiment);
FigurePart fallFigure(const PaperExperiment& experiment);
FigurePart volumeFigure(const PaperExperiment& experiment);

/// The figures that are one picture each, relative to the report.
inline constexpr const char* kFigure2File = "figures/figure-2.png";
inline constexpr const char* kFigure9File = "figures/figure-9.png";
inline constexpr const char* kFigure10File = "figures/figure-10.png";
/// The times of the ways to find triangles, which the paper has no figure of.
inline constexpr const char* kSearchFile = "figures/search.png";
/// The plot of volume and time of a frame of a run, in the folder of the run.
inline constexpr const char* kPlotFile = "plots.png";

/// Draws all figures of a report into its folder `out`, from the pictures that the runs left there.
/// Needs a current OpenGL context. Throws InputError where such a picture can't be read,
/// OutputError.
void drawFigures(const ReportData& data, const std::filesystem::path& out);

}  // namespace kerf::app
