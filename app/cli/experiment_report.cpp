#include "app/cli/experiment_report.h"

#include <spdlog/fmt/fmt.h>

#include "sim/base/text.h"

namespace kerf::app {

namespace {

using Results = std::vector<ExperimentResult>;

constexpr const char* kNotGiven = "-";

std::string percent(double ratio) {
    return fmt::format("{:.2f}", 100 * ratio);
}

/// "mean (min to max)".
std::string spread(double mean, double min, double max) {
    return fmt::format("{:.3f} ({:.3f} to {:.3f})", mean, min, max);
}

std::string spread(const Range& range) {
    return spread(range.mean(), range.min(), range.max());
}

std::string row(const std::vector<std::string>& cells) {
    return "| " + joined(cells, " | ") + " |\n";
}

std::string table(const std::vector<std::string>& head, const Results& results,
                  std::vector<std::string> (*cells)(const ExperimentResult&)) {
    std::string text = row(head) + row(std::vector<std::string>(head.size(), "---"));
    for (const ExperimentResult& result : results) {
        text += row(cells(result));
    }
    return text + "\n";
}

std::string methodSentence(bool published) {
    return published
               ? "Solver, contact between pieces and course of the cut are the paper's as well "
                 "(`solver` pbd, `paper_contact`, `open_cut`): the body is open while the blade is "
                 "in it, as hollow.png shows: there two hands draw the lips apart, for the picture "
                 "alone. Stiffness factors, which the paper does not give, are our sessions'."
               : "Solver, contact and cut are Kerf's own; with `--published` they are the paper's.";
}

std::string headSection(const Results& results, bool published) {
    return "# The paper's experiments, remade\n\n"
           "The blade comes down through each body at rest, then gravity acts and the pieces fall "
           "on "
           "the floor (the paper's sections 3.1 and 3.2). Time steps and iterations are the "
           "paper's, the models are our own of the same kinds and names. " +
           methodSentence(published) +
           "\n\n"
           "Renderer: " +
           results.front().summary.renderer +
           ". The paper's computer had an NVIDIA GeForce RTX 3060 Ti and an Intel Core i7-7700, so "
           "times and frame rates do not compare from one machine to the other.\n\n"
           "A dash stands where the paper's text gives no figure: of its tables 2 (counts) and 3 "
           "(stage times) the text repeats the frame rates alone, and by how much they are above "
           "those of the authors' previous method.\n\n";
}

std::string settingsSection(const Results& results) {
    return "## Settings\n\n" +
           table({"model", "time step, s", "iterations", "steps", "pieces", "closed every step"},
                 results, [](const ExperimentResult& r) -> std::vector<std::string> {
                     return {r.paper->label,
                             fmt::format("{}", r.paper->timeStep),
                             fmt::format("{}", r.paper->iterations),
                             fmt::format("{}", r.summary.statistics.steps),
                             fmt::format("{}", r.summary.pieces.size()),
                             r.summary.statistics.closedEveryStep ? "yes" : "no"};
                 });
}

std::string countsSection(const Results& results) {
    return "## Counts before and after the cut (the paper's table 2)\n\n" +
           table({"model", "vertices", "triangles", "ISPCs", "paper: triangles before"}, results,
                 [](const ExperimentResult& r) -> std::vector<std::string> {
                     const auto pair = [](int before, int after) {
                         return fmt::format("{} to {}", before, after);
                     };
                     const Counts& before = r.summary.before;
                     const Counts& after = r.summary.after;
                     return {r.paper->label, pair(before.vertices, after.vertices),
                             pair(before.triangles, after.triangles),
                             pair(before.ispcs, after.ispcs),
                             r.paper->triangles > 0 ? fmt::format("{}", r.paper->triangles)
                                                    : kNotGiven};
                 });
}

std::string volumeSection(const Results& results) {
    return "## Volume, % of rest (the paper's figure 10)\n\n" +
           table({"model", "mean", "min", "final", "paper: mean", "paper: course"}, results,
                 [](const ExperimentResult& r) -> std::vector<std::string> {
                     const RunStatistics& run = r.summary.statistics;
                     return {r.paper->label,
                             percent(run.volumeRatio.mean()),
                             percent(run.volumeRatio.min()),
                             percent(run.finalVolumeRatio),
                             fmt::format("{:.1f}", r.paper->meanVolume),
                             r.paper->volumeAfter};
                 });
}

std::string previousFps(const PaperExperiment& paper) {
    return paper.gainOverPrevious > 0
               ? fmt::format("{:.1f}", paper.meanFps / (1 + paper.gainOverPrevious / 100))
               : fmt::format("above {:.1f}", paper.meanFps);
}

std::string framesSection(const Results& results) {
    return "## Frames per second (the paper's figure 9 and table 3)\n\n"
           "A frame is a step without a window: solving, cutting and what the session asks for, "
           "pictures included.\n\n" +
           table(
               {"model", "mean", "slowest", "fastest", "paper: mean", "paper: its previous method"},
               results, [](const ExperimentResult& r) -> std::vector<std::string> {
                   const RunStatistics& run = r.summary.statistics;
                   return {r.paper->label,
                           fmt::format("{:.1f}", run.meanFps()),
                           fmt::format("{:.1f}", run.fps.min()),
                           fmt::format("{:.1f}", run.fps.max()),
                           fmt::format("{:.1f}", r.paper->meanFps),
                           previousFps(*r.paper)};
               });
}

std::string stagesSection(const Results& results) {
    return "## Stage times, ms (the paper's table 3)\n\n"
           "Mean (smallest to largest) of a step. The paper's text gives no figures: deforming and "
           "colliding take very little for all models, on average and at most; cutting takes "
           "little "
           "on average, growing from the smallest to the largest model, and far more than both at "
           "most, the banana above all. Search: finding the triangles near the blade, by "
           "`cut_search`.\n\n" +
           table({"model", "deform", "collide", "cut", "of it, search"}, results,
                 [](const ExperimentResult& r) -> std::vector<std::string> {
                     const RunStatistics& run = r.summary.statistics;
                     return {r.paper->label, spread(run.deformMs), spread(run.collideMs),
                             spread(run.cutMs), spread(run.searchMs)};
                 });
}

std::string subdivisionSection(const Results& results) {
    return "## Triangles of the surface by how they were divided (the paper's figure 4)\n\n" +
           table({"model", "1-to-4", "1-to-3a", "1-to-2", "1-to-3b", "other"}, results,
                 [](const ExperimentResult& r) {
                     const SubdivisionCounts& counts = r.summary.statistics.subdivisions;
                     std::vector<std::string> cells{r.paper->label};
                     for (int i = 0; i < kPaperPatterns; ++i) {
                         cells.push_back(fmt::format("{}", counts[i]));
                     }
                     cells.push_back(fmt::format("{}", otherPatterns(counts)));
                     return cells;
                 });
}

std::string picturesSection(const Results& results) {
    std::string text = "## Pictures and plots (the paper's figures 5 to 10)\n\n";
    for (const ExperimentResult& result : results) {
        text += std::string("### ") + result.paper->label + "\n\n";
        for (const std::string& picture : result.pictures) {
            text.append("![").append(picture).append("](").append(picture).append(")\n");
        }
        text += "\n";
    }
    return text;
}

/// One list of sentences for all experiments; nothing where no experiment has any.
std::string sentencesSection(const char* title, const Results& results,
                             std::vector<std::string> RunSummary::*sentences) {
    std::string text;
    for (const ExperimentResult& result : results) {
        for (const std::string& sentence : result.summary.*sentences) {
            text += std::string("- ") + result.paper->label + ": " + sentence + "\n";
        }
    }
    return text.empty() ? "" : std::string("## ") + title + "\n\n" + text + "\n";
}

}  // namespace

std::string formatExperimentReport(const Results& results, bool published) {
    return headSection(results, published) +
           sentencesSection("What did not hold", results, &RunSummary::failures) +
           sentencesSection("Remarks", results, &RunSummary::remarks) + settingsSection(results) +
           countsSection(results) + volumeSection(results) + framesSection(results) +
           stagesSection(results) + subdivisionSection(results) + picturesSection(results);
}

}  // namespace kerf::app
