#include "bench/lab/experiment/report_strips.h"

#include <spdlog/fmt/fmt.h>

#include "bench/lab/experiment/report_markdown.h"

namespace kerf::app {

std::string stripFigure(const ReportData& data, int figure, const std::string& title,
                        FigurePart (*partOf)(const PaperExperiment&)) {
    std::string strips;
    std::string parts;
    for (const ExperimentResult& result : data.results) {
        const FigurePart part = partOf(*result.paper);
        if (part.figure == figure) {
            strips += markdownPicture(title + " of " + result.paper->label, part.file());
            parts += fmt::format("{}{} {}: time step {} s, {} iterations",
                                 parts.empty() ? "" : "; ", part.label(), result.paper->label,
                                 result.paper->timeStep, result.paper->iterations);
        }
    }
    return strips.empty() ? ""
                          : strips + markdownCaption(fmt::format("Figure {}", figure),
                                                     title + ": " + parts + ".");
}

}  // namespace kerf::app
