#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "bench/lab/experiment/report_markdown.h"
#include "bench/lab/experiment/report_sections.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

// What counts as far from the paper's figure.
constexpr double kFarRate = 2;     ///< ratio of frame rates, either way
constexpr double kFarVolume = 1;   ///< difference of mean volumes [%]
constexpr double kDeepVolume = 5;  ///< loss where the paper says "negligible" [%]

std::string volumeParagraph(bool published) {
    return published
               ? "**Volume.** Edges, bends and ISPCs alone hold it, as in the paper. How much is "
                 "lost at the impact depends on their stiffness factors, which the paper does not "
                 "give."
               : "**Volume.** Kerf's own solver holds the volume of each piece by a constraint of "
                 "its own, whenever `ispc_stiffness` is above 0. So 100 % is not the work of the "
                 "ISPCs, and no loss at the impact can be seen. With `--published` ISPCs alone "
                 "hold it.";
}

/// Sums of the means of all models [ms].
struct StageSums {
    double deform = 0;
    double collide = 0;
    double cut = 0;
};

StageSums sumStages(const ReportData& data) {
    StageSums sums;
    for (const ExperimentResult& result : data.results) {
        const RunStatistics& run = result.summary.statistics;
        sums.deform += run.deformMs.mean();
        sums.collide += run.collideMs.mean();
        sums.cut += run.cutMs.mean();
    }
    return sums;
}

std::string timesParagraph(const ReportData& data) {
    const StageSums sums = sumStages(data);
    const bool cutLeads = sums.cut > sums.deform + sums.collide;
    return "**What takes the time.** In the paper deforming and contact run on a GPU and take next "
           "to nothing, so the cut decides the frame rate. " +
           std::string(cutLeads
                           ? "So it is here."
                           : "Here it is the other way round: solving and contact take most of a "
                             "step, and the cut, which touches only what lies near the blade, "
                             "little.") +
           fmt::format(
               " For all models together, the means of a step are {:.1f} ms for deforming, "
               "{:.1f} ms for contact and {:.2f} ms for cutting (renderer: {}).",
               sums.deform, sums.collide, sums.cut, data.results.front().summary.renderer);
}

std::string courseParagraph(bool published) {
    return published
               ? "**Course of the cut.** As in the paper, the body is hollow while the blade is in "
                 "it, and its wounds are patched when the stroke ends. So that step is the longest "
                 "one of the cut."
               : "**Course of the cut.** The paper leaves a hole that is patched when the cut is "
                 "complete. Kerf closes each step by walls, so the body is closed all the time and "
                 "no step stands out.";
}

std::vector<std::string> paragraphs(const ReportData& data) {
    return {
        volumeParagraph(data.published),
        timesParagraph(data),
        ("**No drawing.** A frame here is a step without a picture. The paper's frames are drawn "
         "by Unity."),
        ("**Machine.** The paper's computer had an NVIDIA GeForce RTX 3060 Ti and an Intel Core "
         "i7-7700, so times and frame rates do not compare from one machine to the other."),
        courseParagraph(data.published),
        ("**Search.** The paper walks over adjacent triangles from one that is hit, and owes its "
         "gain to that. Kerf finds all triangles in a tree."),
        "**Solver.** The paper's is \"Gauss-Seidel-like\". Kerf solves constraints of one kind at "
        "once (Jacobi), which is softer at equal iterations but gives the same bits for any "
        "number of threads." +
            std::string(data.published ? ""
                                       : " Its iterations are substeps of one sweep each, not "
                                         "sweeps of one step."),
        ("**Models.** They are our own, of the same kinds and names: the paper's octopus and "
         "banana are not published, nor are their counts.")};
}

/// "Octopus: 5.3 frames a second, 0.07 of the paper's 81.1: ..."
std::string farRate(const ExperimentResult& r) {
    const RunStatistics& run = r.summary.statistics;
    const double ratio = run.meanFps() / r.paper->meanFps;
    if (run.steps == 0 || (ratio > 1 / kFarRate && ratio < kFarRate)) {
        return "";
    }
    return fmt::format(
        "{}: {:.1f} frames a second are {:.2f} of the paper's {:.1f}. Of {:.1f} ms "
        "of a step, deforming takes {:.1f}, contact {:.1f} and cutting {:.2f}.",
        r.paper->label, run.meanFps(), ratio, r.paper->meanFps, run.frameMs.mean(),
        run.deformMs.mean(), run.collideMs.mean(), run.cutMs.mean());
}

std::string farVolume(const ExperimentResult& r, bool published) {
    const RunStatistics& run = r.summary.statistics;
    const double mean = 100 * run.volumeRatio.mean();
    if (run.steps == 0 || std::abs(mean - r.paper->meanVolume) <= kFarVolume) {
        return "";
    }
    return fmt::format(
        "{}: a mean volume of {:.2f} % where the paper has {:.1f} %: {}.", r.paper->label, mean,
        r.paper->meanVolume,
        published ? "stiffness factors and model are other ones" : "a constraint holds it");
}

std::string deepVolume(const ExperimentResult& r) {
    const RunStatistics& run = r.summary.statistics;
    const double least = 100 * run.volumeRatio.min();
    if (run.steps == 0 || least > 100 - kDeepVolume ||
        std::string_view(r.paper->volumeAfter) != kNegligibleChange) {
        return "";
    }
    return fmt::format(
        "{}: the volume falls to {:.1f} % where the paper speaks of negligible "
        "change. Thin parts fold at the impact; the paper's bending stiffness is "
        "not known.",
        r.paper->label, least);
}

std::vector<std::string> farFigures(const ReportData& data) {
    std::vector<std::string> sentences;
    for (const ExperimentResult& result : data.results) {
        for (std::string& sentence :
             std::array{farRate(result), farVolume(result, data.published), deepVolume(result)}) {
            if (!sentence.empty()) {
                sentences.push_back(std::move(sentence));
            }
        }
    }
    return sentences;
}

}  // namespace

std::string differencesSection(const ReportData& data) {
    const std::vector<std::string> far = farFigures(data);
    return "## What differs from the paper, and why\n\n" + markdownList(paragraphs(data)) +
           (far.empty() ? "" : "Figures that are far from the paper's:\n\n" + markdownList(far));
}

}  // namespace kerf::app
