#include <spdlog/fmt/fmt.h>

#include "bench/lab/experiment/report_figures.h"
#include "bench/lab/experiment/report_markdown.h"
#include "bench/lab/experiment/report_sections.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

std::string rate(double fps) {
    return fmt::format("{:.1f}", fps);
}

std::string runsSentence(const ReportData& data) {
    const std::size_t runs = data.results.front().strokes.size();
    return fmt::format(
        "\"While the blade cuts\" is the mean of {}, one after the other, from the first pose of "
        "the blade to the end of the stroke: the complete run and repetitions of its stroke alone. "
        "Error bars are the smallest and the largest mean of one run.",
        counted(runs, "run", "runs"));
}

std::string figureNine(const ReportData& data) {
    return markdownPicture("Average frames per second of all models", kFigure9File) +
           markdownCaption("Figure 9", "Average frames per second. " + runsSentence(data) +
                                           " A frame is a step without a window and without "
                                           "pictures: solving, contact and cutting.");
}

std::string ratesTable(const ReportData& data) {
    return experimentTable({"model", "while the blade cuts: mean", "smallest", "largest",
                            "whole run", "slowest frame, ms", "paper"},
                           data.results, [](const ExperimentResult& r) -> Cells {
                               const StrokeRates rates = strokeRates(r);
                               const RunStatistics& run = r.summary.statistics;
                               return {
                                   r.paper->label,        rate(rates.mean),
                                   rate(rates.least),     rate(rates.most),
                                   rate(run.meanFps()),   fmt::format("{:.1f}", run.frameMs.max()),
                                   rate(r.paper->meanFps)};
                           });
}

std::string tableThree(const ReportData& data) {
    return experimentTable(
               {"model", "paper: previous method, frames/s", "paper: ISPC method, frames/s",
                "paper: gain, %", "Kerf, frames/s", "deform, ms", "collide, ms", "cut, ms",
                "cut, of a stroke's steps, ms"},
               data.results,
               [](const ExperimentResult& r) -> Cells {
                   const RunStatistics& run = r.summary.statistics;
                   const auto previous = r.paper->previousFps();
                   return {r.paper->label,
                           previous ? rate(*previous) : "above " + rate(r.paper->meanFps),
                           rate(r.paper->meanFps),
                           r.paper->gain > 0 ? fmt::format("{:.2f}", r.paper->gain) : kNotGiven,
                           rate(run.meanFps()),
                           spread(run.deformMs),
                           spread(run.collideMs),
                           spread(run.cutMs),
                           r.strokes.empty() ? kNotGiven : spread(r.strokes.front().cutMs)};
               }) +
           markdownCaption(
               "Table 3",
               "Frame rates of the paper's previous and its ISPC method beside ours, and our stage "
               "times as mean (smallest to largest) of the steps of the whole run. Those of the "
               "previous method follow from the gains that the text gives; of Sphere 20 and 80 it "
               "says that the previous method was faster. The text has no stage times: deforming "
               "and colliding take very little for all models; cutting takes little on average, "
               "growing with the model, and far more than both at most, the banana above all.");
}

}  // namespace

std::string performanceSection(const ReportData& data) {
    return "## Performance (the paper's sections 3.2 and 3.3)\n\n" + figureNine(data) +
           ratesTable(data) + tableThree(data);
}

}  // namespace kerf::app
