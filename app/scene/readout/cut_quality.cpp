#include "app/scene/readout/cut_quality.h"

#include <spdlog/fmt/fmt.h>

#include "sim/base/text.h"
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
               "Cut faces of both sides, and skin triangles that were divided"},
    FigureText{"Minimum angle, worst",
               [](const CutFigures& f) { return angleText(f, f.triangles().worstAngle); },
               "Smallest angle of all these triangles at rest; 60\u00b0 is ideal"},
    FigureText{"Minimum angle, mean",
               [](const CutFigures& f) { return angleText(f, f.triangles().meanAngle()); },
               "Mean of each triangle's smallest angle"},
    FigureText{"Slivers",
               [](const CutFigures& f) { return fmt::format("{}", f.triangles().slivers); },
               "Triangles whose height is below 0.02 of their longest edge"},
    FigureText{"Aspect < 0.001",
               [](const CutFigures& f) { return fmt::format("{}", f.triangles().bareSlivers); },
               "Triangles whose height is below 0.001 of their longest edge"},
    FigureText{"Cut area", [](const CutFigures& f) { return areaText(f.woundArea); },
               "Area of the cut faces at rest, both sides"},
    FigureText{
        "Ratio to swept area",
        [](const CutFigures& f) {
            const std::optional<double> ratio = f.woundToSwept();
            return ratio ? fmt::format("{:.4f}", *ratio) : "-";
        },
        "Cut area divided by twice the area that the blade swept inside the material, at rest"},
    FigureText{"Cutting steps",
               [](const CutFigures& f) { return fmt::format("{}", f.steps.cutSteps); },
               "Steps in which the blade cut"},
    FigureText{"Retried",
               [](const CutFigures& f) { return fmt::format("{}", f.steps.retriedSteps); },
               "Steps that needed more than one try"},
    FigureText{"Refused",
               [](const CutFigures& f) { return fmt::format("{}", f.steps.refusedSteps); },
               "Steps without a valid result; the next step cuts that part, too"},
    FigureText{"Recut", [](const CutFigures& f) { return fmt::format("{}", f.steps.cutAnew); },
               "Cut fronts that were dropped and cut again from behind"},
    FigureText{
        "Slit end length", [](const CutFigures& f) { return lengthText(f.slitLength); },
        "Length of the edges where slits end inside the material; 0 for cuts all the way through"},
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
    rows.push_back(
        {"Volume error", volumeErrorText(report.volumeError), "",
         "Relative difference between the rest volume of all pieces and that of the uncut body"});
    rows.push_back(
        {"Self-intersections", fmt::format("{}", report.crossings.all), "",
         fmt::format(
             "Pairs of triangles that intersect at rest: {} from cuts, the others from the model",
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
        return rows_.empty() ? "No cuts yet." : "";
    }
    return job_ ? "Measuring the cuts..." : "Measured when the stroke ends.";
}

}  // namespace kerf::app
