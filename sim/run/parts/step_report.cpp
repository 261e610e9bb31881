#include "sim/run/parts/step_report.h"

#include <spdlog/fmt/fmt.h>

#include "sim/base/params.h"
#include "sim/base/text.h"
#include "sim/body/body_model.h"
#include "sim/solve/body_measure.h"

namespace kerf {

void StepReport::add(const CutStatistics& cut) {
    touchedTriangles += cut.touchedTriangles;
    addTo(subdivisions, cut.patterns);
    seeds += cut.seeds;
    swept.add(cut.swept);
}

void StepReport::describe(const BodyModel& model, const BodyMeasure& measure) {
    volume = 0;
    vertices = 0;
    for (std::size_t p = 0; p < model.pieces.size(); ++p) {
        volume += measure.pieceVolumes[p];
        vertices += static_cast<int>(model.pieces[p].vertexCount);
    }
    volumeRatio = volume / model.uncutRestVolume;
    pieces = static_cast<int>(model.pieces.size());
    triangles = static_cast<int>(model.triangles.size());
    ispcs = static_cast<int>(model.ispcs.size());
    contacts = measure.contacts;
    kineticEnergy = measure.kineticEnergy;
    potentialEnergy = measure.potentialEnergy;
    strainEnergy = measure.strainEnergy;
}

bool mayTear(const Params& params) {
    return params.solver != SolverMode::pbd && params.openCut == 0 && params.toughness > 0;
}

std::string tearSentence(const StepReport& report, const Params& params, bool toreLately) {
    if (params.tearing == 0) {
        return "";
    }
    if (!mayTear(params)) {
        return "Nothing tears with a toughness of 0, the solver pbd or the open cut.";
    }
    if (!report.tear) {
        return "";
    }
    const TearReport& tear = *report.tear;
    if (tear.failed()) {
        return fmt::format("Can't tear here: {}. Pull another way.", tear.failure);
    }
    if (toreLately) {
        return tear.opening > 0 ? "Tearing at the end of a slit."
                                : "Torn through, or where the stress exceeds the tensile strength.";
    }
    if (tear.opening > 0 || tear.hasSlit) {
        return fmt::format(
            "Not tearing: the slit is opened to {:.0f} % of what its end needs. Pull farther.",
            std::min(100 * tear.opening, 99.0));
    }
    return fmt::format(
        "Not tearing: the skin bears {:.0f} % of its strength. Cut a slit first, or pull farther.",
        std::min(100 * tear.stress, 99.0));
}

std::string refusalSentence(const CutResult& result, int step) {
    return fmt::format("step {}: the cut was refused ({}); the blade goes on", step, result.reason);
}

std::vector<std::string> sentencesAboutEnd(const CutResult& result, int step) {
    std::vector<std::string> sentences;
    const Debris& debris = result.statistics.debris;
    if (debris.pieces > 0) {
        sentences.push_back(fmt::format("step {}: removed {} ({:.2g} mm\u00b3)", step,
                                        debris.pieces == 1
                                            ? "a tiny fragment"
                                            : fmt::format("{} tiny fragments", debris.pieces),
                                        1e9 * debris.volume));
    }
    const WoundClosing& closing = result.statistics.closing;
    if (closing.slits > 0) {
        sentences.push_back(
            fmt::format("step {}: the stroke ended inside the body, where a wound has no loop to "
                        "patch; {} closed by the walls that the blade swept",
                        step, counted(closing.slits, "wound is", "wounds are")));
    }
    if (closing.unpatched > 0) {
        sentences.push_back(fmt::format(
            "step {}: {} closed by the walls that the blade swept instead of a patch ({})", step,
            counted(closing.unpatched, "wound is", "wounds are"), closing.reason));
    }
    return sentences;
}

void StrokeRecord::add(const CutResult& step) {
    const CutStatistics& statistics = step.statistics;
    cutSteps += step.outcome == CutOutcome::cut ? 1 : 0;
    refusedSteps += statistics.refusedPieces > 0 ? 1 : 0;
    retriedSteps += statistics.tries > 1 ? 1 : 0;
    cutAnew += statistics.resumed;
    swept.add(statistics.swept);
    debris.add(statistics.debris);
}

void StrokeRecord::add(const StrokeRecord& other) {
    cutSteps += other.cutSteps;
    refusedSteps += other.refusedSteps;
    retriedSteps += other.retriedSteps;
    cutAnew += other.cutAnew;
    swept.add(other.swept);
    debris.add(other.debris);
}

}  // namespace kerf
