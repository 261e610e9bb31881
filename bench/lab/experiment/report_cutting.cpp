#include <spdlog/fmt/fmt.h>

#include "bench/lab/experiment/report_figures.h"
#include "bench/lab/experiment/report_markdown.h"
#include "bench/lab/experiment/report_sections.h"
#include "bench/lab/experiment/report_strips.h"

namespace kerf::app {

namespace {

std::string chain(const ExperimentResult& r, int Counts::*count) {
    return fmt::format("{} / {} / {}", r.summary.before.*count, r.afterStroke.*count,
                       r.summary.after.*count);
}

std::string tableTwo(const ReportData& data) {
    return experimentTable(
               {"model", "vertices", "triangles", "ISPCs", "paper: triangles before"}, data.results,
               [](const ExperimentResult& r) -> Cells {
                   return {
                       r.paper->label, chain(r, &Counts::vertices), chain(r, &Counts::triangles),
                       chain(r, &Counts::ispcs),
                       r.paper->triangles > 0 ? fmt::format("{}", r.paper->triangles) : kNotGiven};
               }) +
           markdownCaption("Table 2",
                           "Counts before the cut / right after it / at the end of the run. "
                           "Between the last two, slivers and folded edges of the cut faces are "
                           "collapsed. The paper's text gives none of its counts; those of the "
                           "spheres are in their names.");
}

std::string patternsTable(const ReportData& data) {
    return experimentTable({"model", "1-to-4", "1-to-3a", "1-to-2", "1-to-3b", "other"},
                           data.results,
                           [](const ExperimentResult& r) {
                               const SubdivisionCounts& counts = r.summary.statistics.subdivisions;
                               Cells cells{r.paper->label};
                               for (int i = 0; i < kPaperPatterns; ++i) {
                                   cells.push_back(fmt::format("{}", counts[i]));
                               }
                               cells.push_back(fmt::format("{}", otherPatterns(counts)));
                               return cells;
                           }) +
           "Triangles of the surface by how they were divided, with the names of the paper's "
           "figure 4. \"Other\" are triangles in which the blade's way bends or that it meets "
           "twice.\n\n";
}

}  // namespace

std::string cuttingSection(const ReportData& data) {
    return "## Progressive cutting (the paper's section 3.1)\n\n" + tableTwo(data) +
           stripFigure(data, 5, "Cutting simulation", cuttingFigure) +
           stripFigure(data, 6, "Cutting simulation", cuttingFigure) + patternsTable(data);
}

}  // namespace kerf::app
