#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "app/doctor/findings.h"
#include "app/files/import/builtin_models.h"
#include "app/files/import/model_source.h"
#include "sim/mesh/invariants.h"
#include "sim/run/simulation.h"

namespace kerf::app {
namespace {

constexpr int kSteps = 200;
constexpr double kFarBelow = 2;     // the floor, in diagonals, where nothing may come to it
constexpr double kGripShare = 0.2;  // of the diagonal: what a hand or pins take hold of

/// A body that moves as little as what it meets lets it.
struct Stage {
    SurfaceMesh mesh = loadModel(builtinModelFile("sphere768"));
    Bounds bounds = meshBounds(mesh);
    double diagonal = bounds.diagonal();
    Params params;

    /// `floor`: how far below the body [diagonals].
    explicit Stage(double floor) {
        params.floor = bounds.low.y() - floor * diagonal;
        params.airDrag = 8;  // else it bounces for long
    }
    Vec3 top() const { return {bounds.center().x(), bounds.high.y(), bounds.center().z()}; }
};

void run(Simulation& simulation) {
    for (int i = 0; i < kSteps; ++i) {
        simulation.step();
    }
}

/// That something is at most so far from where it should be, in shares of the diagonal.
DriverFinding placeFinding(const std::string& check, double off, double most) {
    return {check, fmt::format("{:.2f} % of the diagonal off", 100 * off),
            fmt::format("at most {:.1f} %", 100 * most), std::abs(off) <= most};
}

/// Leads a blade through a body, level and through its middle.
void cutAcross(Simulation& simulation, const Bounds& bounds) {
    constexpr int kCutSteps = 12;
    const Vec3 middle = bounds.center();
    const double reach = bounds.diagonal();
    for (int i = 0; i <= kCutSteps; ++i) {
        const double x = middle.x() + reach * (2.0 * i / kCutSteps - 1);
        simulation.execute(
            MoveBlade{{{x, middle.y(), middle.z() - reach}, {x, middle.y(), middle.z() + reach}}});
        simulation.step();
    }
    simulation.execute(LiftBlade{});
}

}  // namespace

DriverFinding halvesFinding() {
    const std::string check = "A half on the other";
    const Stage stage(0);
    Simulation simulation(stage.mesh, stage.params);
    cutAcross(simulation, stage.bounds);
    run(simulation);
    const std::vector<Bounds>& boxes = simulation.pieceBounds();
    if (boxes.size() != 2) {
        return {check, fmt::format("{} pieces", boxes.size()), "2 pieces", false};
    }
    const bool firstIsLower = boxes[0].center().y() < boxes[1].center().y();
    const Bounds& lower = boxes[firstIsLower ? 0 : 1];
    const Bounds& upper = boxes[firstIsLower ? 1 : 0];
    return placeFinding(check, (upper.low.y() - lower.high.y()) / stage.diagonal, 0.03);
}

DriverFinding boxFinding() {
    constexpr double kThickness = 0.2;  // of the box [diagonals]
    const Stage stage(kFarBelow);
    const double top = stage.bounds.low.y() - 0.05 * stage.diagonal;
    StaticBox box;
    box.center = stage.bounds.center();
    box.center.y() = top - kThickness / 2 * stage.diagonal;
    box.size = Vec3(1, kThickness, 1) * stage.diagonal;
    Simulation simulation(stage.mesh, stage.params, {box});
    run(simulation);
    return placeFinding("On a box", (simulation.bounds().low.y() - top) / stage.diagonal, 0.01);
}

DriverFinding handFinding() {
    const Stage stage(kFarBelow);
    Simulation simulation(stage.mesh, stage.params);
    simulation.execute(Grab{0, stage.top(), kGripShare * stage.diagonal});
    run(simulation);
    return placeFinding(
        "In a hand", (simulation.bounds().high.y() - stage.bounds.high.y()) / stage.diagonal, 0.02);
}

namespace {

DriverFinding pinsFinding() {
    const Stage stage(kFarBelow);
    Simulation simulation(stage.mesh, stage.params);
    simulation.execute(Pin{Ball{stage.top(), kGripShare * stage.diagonal}});
    run(simulation);
    const SurfaceMesh& mesh = simulation.mesh();
    double farthest = 0;
    for (const std::uint32_t v : simulation.pinnedVertices()) {
        farthest = std::max(
            farthest,
            (mesh.position(static_cast<int>(v)) - stage.mesh.position(static_cast<int>(v))).norm());
    }
    return placeFinding("What is pinned", farthest / stage.diagonal, 0);
}

}  // namespace

std::vector<DriverFinding> meetingFindings() {
    return {halvesFinding(), boxFinding(), handFinding(), pinsFinding()};
}

}  // namespace kerf::app
