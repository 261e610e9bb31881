#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "app/doctor/findings.h"
#include "app/files/import/builtin_models.h"
#include "app/files/import/model_source.h"
#include "app/files/io/file_io.h"
#include "app/session/headless_session.h"
#include "gpu/data_path.h"
#include "render/scene/picture_comparison.h"
#include "sim/mesh/invariants.h"
#include "sim/run/simulation.h"

namespace kerf::app {
namespace {

constexpr const char* kModel = "sphere768";
constexpr const char* kCutSession = "assets/sessions/sphere768.kerf.json";
constexpr int kMostCutSteps = 260;         // through the cut and the fall, onto the floor
constexpr double kMostVolumeError = 0.01;  // of rest, in motion
constexpr const char* kPictureFile = "assets/doctor/cut.png";
constexpr int kPictureWidth = 640;
constexpr int kPictureHeight = 360;

SurfaceMesh model() {
    return loadModel(builtinModelFile(kModel));
}

double heightOf(const Simulation& simulation) {
    return (simulation.bounds().low.y() + simulation.bounds().high.y()) / 2;
}

DriverFinding volumeFinding(const std::string& check, double ratio) {
    return {check, fmt::format("{:.2f} % of rest", 100 * ratio),
            fmt::format("100 % to {:.0f} %", 100 * kMostVolumeError),
            std::abs(ratio - 1) <= kMostVolumeError};
}

/// Lets a body fall for so many steps of so many substeps. Returns how far it came over how far it
/// should.
double fallenShare(Simulation& simulation, int substeps, int steps, double& speed) {
    simulation.execute(SetParam{"iterations", double(substeps)});
    const Params params = simulation.params();
    const double before = heightOf(simulation);
    for (int i = 0; i < steps; ++i) {
        simulation.step();
    }
    const double time = steps * params.timeStep;
    const double g = params.gravity.y();
    // Speeds change at the beginning of a substep.
    const double expected = speed * time + g * time * (time + params.timeStep / substeps) / 2;
    speed += g * time;
    return (heightOf(simulation) - before) / expected;
}

DriverFinding fallFinding(int substeps, double share) {
    constexpr double kMostError = 0.01;
    return {fmt::format("Free fall, {} a step", substeps == 1 ? "1 substep" : "20 substeps"),
            fmt::format("{:.2f} % of the way", 100 * share),
            fmt::format("100 % to {:.0f} %", 100 * kMostError), std::abs(share - 1) <= kMostError};
}

}  // namespace

std::vector<DriverFinding> freeFallFindings() {
    Params params;
    params.floor.reset();
    params.airDrag = 0;
    Simulation simulation(model(), params);
    double speed = 0;
    constexpr int kSteps = 20;
    const double single = fallenShare(simulation, 1, kSteps, speed);
    const double twenty = fallenShare(simulation, 20, kSteps, speed);
    return {fallFinding(1, single), fallFinding(20, twenty),
            volumeFinding("Volume in free fall", simulation.report().volumeRatio)};
}

std::vector<DriverFinding> restFindings() {
    constexpr int kSteps = 300;
    constexpr double kDrop = 0.05;        // of the diagonal
    constexpr double kDeepest = 0.005;    // below the floor, the same
    constexpr double kMostJoules = 1e-3;  // a kilogram at 0.04 m/s
    const SurfaceMesh mesh = model();
    const Bounds bounds = meshBounds(mesh);
    Params params;
    params.floor = bounds.low.y() - kDrop * bounds.diagonal();
    params.airDrag = 8;  // else it bounces for long
    Simulation simulation(mesh, params);
    for (int i = 0; i < kSteps; ++i) {
        simulation.step();
    }
    const StepReport& report = simulation.report();
    const double depth = (*params.floor - simulation.bounds().low.y()) / bounds.diagonal();
    const double mass = params.density * report.volume;
    const double motion = report.kineticEnergy / mass;
    return {{"On the floor: how deep", fmt::format("{:.3f} % of the diagonal", 100 * depth),
             fmt::format("at most {:.1f} %", 100 * kDeepest), depth <= kDeepest},
            {"On the floor: motion", fmt::format("{:.1e} J/kg", motion),
             fmt::format("at most {:.0e} J/kg", kMostJoules), motion <= kMostJoules},
            volumeFinding("On the floor: volume", report.volumeRatio)};
}

namespace {

/// What a played session ended in.
struct CutRun {
    std::string stateHash;
    int pieces = 0;
    double volumeRatio = 0;  ///< against rest
    bool closed = true;      ///< after every step
    render::Image picture;   ///< of the end
};

CutRun playCut(const Session& session) {
    const SessionSchedule schedule(session);
    HeadlessSession play(session, loadSessionModel(session), 0, render::Quality::light);
    CutRun run;
    while (play.simulation().stepCount() < session.steps) {
        run.closed = play.stepBy(schedule).closed && run.closed;
    }
    run.stateHash = play.simulation().stateHash();
    run.pieces = play.simulation().report().pieces;
    run.volumeRatio = play.simulation().report().volumeRatio;
    run.picture = play.draw(play.camera(), kPictureWidth, kPictureHeight);
    return run;
}

/// The picture must be what the software renderer drew, as people see it.
DriverFinding pictureFinding(const render::Image& picture) {
    const render::PictureLimits& limits = render::kTolerantLimits;
    const render::PictureComparison comparison =
        render::comparePictures(picture, readPicture(gpu::dataPath(kPictureFile)));
    return {"Picture",
            fmt::format("{:.2f} % of its pixels differ, by {:.2f} at worst",
                        100 * comparison.shareDiffering(), comparison.worst),
            fmt::format("at most {:.0f} %, by {:.2f}", 100 * limits.pixels, limits.worst),
            render::withinLimits(comparison, limits)};
}

}  // namespace

CutFindings cutFindings() {
    Session session = readSession(gpu::dataPath(kCutSession));
    session.steps = std::min(session.steps, kMostCutSteps);
    CutRun first = playCut(session);
    const CutRun second = playCut(session);
    CutFindings result;
    result.findings = {
        {"A cut parts the body", fmt::format("{} pieces", first.pieces), "2 pieces",
         first.pieces == 2},
        {"The surface stays closed", first.closed ? "after every step" : "not after every step",
         "after every step", first.closed},
        volumeFinding("Volume of the halves", first.volumeRatio),
        {"The same cut again", first.stateHash == second.stateHash ? "the same bits" : "other bits",
         "the same bits", first.stateHash == second.stateHash},
        pictureFinding(first.picture)};
    result.picture = std::move(first.picture);
    return result;
}

}  // namespace kerf::app
