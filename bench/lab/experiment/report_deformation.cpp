#include <spdlog/fmt/fmt.h>

#include "bench/lab/experiment/report_figures.h"
#include "bench/lab/experiment/report_markdown.h"
#include "bench/lab/experiment/report_sections.h"
#include "bench/lab/experiment/report_strips.h"

namespace kerf::app {

namespace {

std::string volumeTable(const ReportData& data) {
    return experimentTable({"model", "mean", "min", "final", "paper: mean", "paper: course"},
                           data.results, [](const ExperimentResult& r) -> Cells {
                               const RunStatistics& run = r.summary.statistics;
                               return {r.paper->label,
                                       percent(run.volumeRatio.mean()),
                                       percent(run.volumeRatio.min()),
                                       percent(run.finalVolumeRatio),
                                       fmt::format("{:.1f}", r.paper->meanVolume),
                                       r.paper->volumeAfter};
                           });
}

std::string volumeCaption(const ReportData& data) {
    std::string parts;
    for (const ExperimentResult& result : data.results) {
        parts += (parts.empty() ? "" : "; ") + volumeFigure(*result.paper).label() + " " +
                 result.paper->label;
    }
    return "Volume against time, % of rest: " + parts +
           ". Dashed: the paper's mean. It has no error bars: the same session gives the same bits "
           "in each run, so its volume has no spread.";
}

}  // namespace

std::string deformationSection(const ReportData& data) {
    return "## Deformation with ISPCs (the paper's section 3.2)\n\n" +
           stripFigure(data, 7, "Deformation after cutting", fallFigure) +
           stripFigure(data, 8, "Deformation after cutting", fallFigure) + volumeTable(data) +
           markdownPicture("Volume against time", kFigure10File) +
           markdownCaption("Figure 10", volumeCaption(data));
}

}  // namespace kerf::app
