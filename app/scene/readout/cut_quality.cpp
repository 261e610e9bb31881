#include "app/scene/readout/cut_quality.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <utility>

#include "sim/base/quantity_text.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {

namespace {

struct FigureText {
    const char* quantity;
    std::string (*text)(const CutFigures& figures);
    const char* tooltip;
};

std::string angleText(const CutFigures& figures, double angle) {
    return figures.triangles().triangles == 0 ? "-" : fmt::format("{:.1f}\u00b0", angle);
}

/// What each stroke has of its own.
constexpr std::array kTexts{
    FigureText{"Triangles",
               [](const CutFigures& f) { return fmt::format("{}", f.triangles().triangles); },
               "Walls of both sides, and skin that was divided"},
    FigureText{"Smallest angle, worst",
               [](const CutFigures& f) { return angleText(f, f.triangles().worstAngle); },
               "The smallest angle of all these triangles at rest, 60\u00b0 at best"},
    FigureText{"Smallest angle, mean",
               [](const CutFigures& f) { return angleText(f, f.triangles().meanAngle()); },
               "The mean of the smallest angle of each"},
    FigureText{"Slivers",
               [](const CutFigures& f) { return fmt::format("{}", f.triangles().slivers); },
               "Lower than 0.02 of their longest edge"},
    FigureText{"below 0.001",
               [](const CutFigures& f) { return fmt::format("{}", f.triangles().bareSlivers); },
               "Lower than 0.001 of their longest edge"},
    FigureText{"Area of the wound", [](const CutFigures& f) { return areaText(f.woundArea); },
               "Of the walls at rest, both sides"},
    FigureText{"against the blade's",
               [](const CutFigures& f) {
                   const std::optional<double> ratio = f.woundToSwept();
                   return ratio ? fmt::format("{:.4f}", *ratio) : "-";
               },
               "Over twice the area that the blade swept in the material, as it rests"},
    FigureText{"Steps that cut",
               [](const CutFigures& f) { return fmt::format("{}", f.steps.cutSteps); },
               "Steps in which the blade cut"},
    FigureText{"tried again",
               [](const CutFigures& f) { return fmt::format("{}", f.steps.retriedSteps); },
               "Steps that took more than one try"},
    FigureText{"refused",
               [](const CutFigures& f) { return fmt::format("{}", f.steps.refusedSteps); },
               "Steps without a valid result: the next one reaches farther"},
    FigureText{"cut anew", [](const CutFigures& f) { return fmt::format("{}", f.steps.cutAnew); },
               "Fronts that were let go and cut anew from behind"},
    FigureText{"Ends of slits", [](const CutFigures& f) { return lengthText(f.slitLength); },
               "Length of the edges where a slit ends in the material. A stroke right through has "
               "none"},
};

/// A zero has no unit, nor a sign.
std::string volumeErrorText(double share) {
    return share == 0 ? "0" : fmt::format("{:.1e}", share);
}

}  // namespace

std::vector<ui::CutRow> rowsOf(const CutReport& report) {
    std::vector<ui::CutRow> rows;
    rows.reserve(kTexts.size() + 2);
    for (const auto& [quantity, text, tooltip] : kTexts) {
        rows.push_back({quantity, text(report.all), text(report.strokes.back()), tooltip});
    }
    rows.push_back({"Volume error", volumeErrorText(report.volumeError), "",
                    "Rest volume of all pieces against that of the uncut body, as a share"});
    rows.push_back(
        {"Self-intersections", fmt::format("{}", report.crossings.all), "",
         fmt::format("Pairs of triangles that pass through each other at rest. Cuts made "
                     "{} of them; the model has the others of its own",
                     report.crossings.ofCuts)});
    return rows;
}

bool CutQuality::follow(Simulation& simulation, bool wanted) {
    if (!wanted) {
        return false;
    }
    const std::string before = note_;
    const bool ready = job_ && job_->done();
    if (ready) {
        takeReady();
    }
    const bool strokes = !simulation.rung().empty();
    if (!job_ && !strokes && known_ != simulation.modelRevision()) {
        begin(simulation);
    }
    note_ = noteOf(simulation);
    return ready || note_ != before;
}

/// Without a stroke there is nothing to measure.
void CutQuality::begin(Simulation& simulation) {
    const std::vector<StrokeRecord>& strokes = simulation.strokes();
    if (std::ranges::none_of(strokes, &StrokeRecord::metBody)) {
        rows_.clear();
        known_ = simulation.modelRevision();
        return;
    }
    working_ = simulation.modelRevision();
    auto body = std::make_shared<const SurfaceMesh>(simulation.meshAsRead());
    job_ = std::make_unique<BackgroundJob<Report>>(
        [body, uncut = simulation.uncut(), strokes](WorkProgress&) {
            return reportOn({*body, uncut->mesh, strokes});
        });
}

void CutQuality::takeReady() {
    const Report report = job_->take();
    rows_ = report ? rowsOf(*report) : std::vector<ui::CutRow>{};
    known_ = std::exchange(working_, -1);
    job_.reset();
}

std::string CutQuality::noteOf(const Simulation& simulation) const {
    if (known_ == simulation.modelRevision()) {
        return rows_.empty() ? "No cut yet." : "";
    }
    return job_ ? "Measuring the cuts..." : "Measured when the stroke ends.";
}

}  // namespace kerf::app
