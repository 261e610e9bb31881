// Milliseconds of one step of a shallow cut into spheres of 1.3k to 328k triangles: the blade
// scales with the edges, so that a step touches equally many triangles, while the body deforms
// between the steps. A step costs what it touches where the figures do not grow with the body.
//
// The processor's caches are emptied before each step, in bodies of every size, as solving and
// drawing a frame empty them in the editor. Without that a small body's steps run from the caches
// and the ratio tells how much of those the machine has to spare: step_in_caches, for comparison.
// The sizes take turns, several rounds of them, so that whatever else keeps the machine busy falls
// on all.

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>

#include "bench/timing.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "sim/base/math.h"
#include "sim/base/stopwatch.h"
#include "sim/body/body_updater.h"
#include "sim/cut/cut_change.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/run/simulation.h"
#include "sim/solve/gpu_solver.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

constexpr double kRadius = 0.5;
constexpr int kFirstStep = 4;  // the blade is inside by then
constexpr int kSteps = 28;
constexpr int kRounds = 5;
constexpr int kRebuilds = 3;
constexpr std::size_t kMoreThanCaches = std::size_t(64) << 20;  // [bytes]
constexpr std::size_t kCacheLine = 64;                          // [bytes]

// The blade, in edges.
constexpr double kDepth = 1.3;
constexpr double kHandle = 3;
constexpr double kAdvance = 0.6;

// The motion of the body: waves of this height and number, and how far they go in a step.
constexpr double kWaveHeight = 0.02 * kRadius;
constexpr double kWaveNumber = 3 / kRadius;
constexpr double kWaveSpeed = 0.1;

// The fall in a step stays below a fifth of the smallest edge.
constexpr double kGravity = 1;  // [m/s^2]

Vec3 deformed(const Vec3& p, int step) {
    const Vec3 phase =
        kWaveNumber * Vec3(p.y(), p.z(), p.x()) + kWaveSpeed * step * Vec3(1, 1.3, 0.7);
    return p + kWaveHeight * Vec3(phase.array().sin());
}

/// Returns how far a vertex has moved at most.
double deform(SurfaceMesh& mesh, int step) {
    double most = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 p = nearestFloats(deformed(mesh.restPosition(v), step));
        most = std::max(most, (p - mesh.position(v)).norm());
        mesh.setPosition(v, p);
    }
    return most;
}

/// Along a meridian of the body at rest.
Blade bladeAt(int step, double edge) {
    const double angle = 0.3 + kAdvance * step * edge / kRadius;
    const Vec3 outward(std::sin(angle), std::cos(angle), 0.0137);
    return {(kRadius + kHandle * edge) * outward, (kRadius - kDepth * edge) * outward};
}

Blade deformed(const Blade& blade, int step) {
    return {deformed(blade.a, step), deformed(blade.b, step)};
}

void emptyCaches() {
    static std::vector<unsigned char> memory(kMoreThanCaches);
    for (std::size_t i = 0; i < memory.size(); i += kCacheLine) {
        ++memory[i];
    }
}

enum class Caches { asTheyAre, emptied };

/// Each phase of the cutting steps [ms].
struct Times {
    std::vector<double> cutter;
    std::vector<double> model;
    std::vector<double> upload;
    std::vector<double> step;
    std::vector<double> touched;
};

struct Figures {
    int triangles = 0;
    double touched = 0;
    double cutter = 0;
    double model = 0;
    double upload = 0;
    double step = 0;
    double stepInCaches = 0;  ///< without emptying them
    double simulation = 0;    ///< what Simulation takes for the cut, with reading back
    double rebuild = 0;       ///< model from scratch and upload of everything
};

class LocalCut {
  public:
    explicit LocalCut(const SurfaceMesh& whole) : mesh_(whole), body_(mesh_), cutter_(mesh_, {}) {
        solver_.setModel(body_.model(), stateOf(mesh_));
        solver_.measure();
    }

    /// Appends to `times`.
    void run(Caches caches, Times& times) {
        cutter_.begin(deformed(bladeAt(0, body_.model().edgeLength), 0));
        for (int i = 1; i < kSteps; ++i) {
            cutter_.boundMotion(deform(mesh_, i));
            if (caches == Caches::emptied) {
                emptyCaches();
            }
            step(i, times);
        }
    }

    double rebuild() {
        std::vector<double> times;
        for (int i = 0; i < kRebuilds; ++i) {
            const Stopwatch watch;
            const BodyModel model = buildBodyModel(mesh_);
            solver_.setModel(model, stateOf(mesh_));
            solver_.measure();
            times.push_back(watch.milliseconds());
        }
        return median(times);
    }

  private:
    void step(int index, Times& times) {
        const Blade blade = deformed(bladeAt(index, body_.model().edgeLength), index);
        Stopwatch watch;
        const CutResult result = cutter_.advance(blade);
        const double cutter = 1000 * watch.restart();
        if (result.outcome == CutOutcome::refused) {
            std::fprintf(stderr, "step %d: %s\n", index, result.reason.c_str());
        }
        if (result.outcome != CutOutcome::cut) {
            return;
        }
        const BodyChange change = body_.update(result.delta);
        const double model = 1000 * watch.restart();
        const std::vector<std::uint32_t> written = rewrittenVertices(mesh_, result.delta);
        solver_.update(body_.model(), change, written, stateOf(mesh_, written));
        gpu::finish();
        const double upload = 1000 * watch.restart();
        if (index >= kFirstStep) {
            times.cutter.push_back(cutter);
            times.model.push_back(model);
            times.upload.push_back(upload);
            times.step.push_back(cutter + model + upload);
            times.touched.push_back(result.statistics.touchedTriangles);
        }
    }

    SurfaceMesh mesh_;
    BodyUpdater body_;
    Cutter cutter_;
    GpuSolver solver_;
};

/// The same cut by the whole simulation, of a body that falls, and the blade with it.
double simulatedCut(const SurfaceMesh& whole, double edge) {
    Params params;
    params.iterations = 1;
    params.gravity = Vec3(0, -kGravity, 0);
    params.floor.reset();
    Simulation simulation(whole, params);
    std::vector<double> times;
    for (int i = 0; i < kSteps; ++i) {
        const Vec3 fallen = params.gravity * (params.timeStep * params.timeStep * i * (i + 1) / 2);
        const Blade blade = bladeAt(i, edge);
        simulation.execute(MoveBlade{{blade.a + fallen, blade.b + fallen}});
        const StepReport& report = simulation.step();
        if (i >= kFirstStep && simulation.lastCut().outcome == CutOutcome::cut) {
            times.push_back(report.times.cut);
        }
    }
    return median(times);
}

/// A sphere and how long its cuts took.
class SphereBench {
  public:
    explicit SphereBench(int subdivisions) : whole_(test::icosphere(subdivisions, kRadius)) {}

    void runRound() {
        LocalCut(whole_).run(Caches::asTheyAre, asTheyAre_);
        LocalCut(whole_).run(Caches::emptied, emptied_);
    }

    Figures figures() const {
        Figures out;
        out.triangles = whole_.triangleSlots();
        out.touched = median(emptied_.touched);
        out.cutter = median(emptied_.cutter);
        out.model = median(emptied_.model);
        out.upload = median(emptied_.upload);
        out.step = median(emptied_.step);
        out.stepInCaches = median(asTheyAre_.step);
        out.rebuild = LocalCut(whole_).rebuild();
        out.simulation = simulatedCut(whole_, buildBodyModel(whole_).edgeLength);
        return out;
    }

  private:
    SurfaceMesh whole_;
    Times asTheyAre_;
    Times emptied_;
};

void print(const Figures& f) {
    const nlohmann::ordered_json line = {{"name", "cut/local/" + std::to_string(f.triangles)},
                                         {"touched_triangles", f.touched},
                                         {"cutter", f.cutter},
                                         {"model_update", f.model},
                                         {"upload", f.upload},
                                         {"step", f.step},
                                         {"step_in_caches", f.stepInCaches},
                                         {"simulation", f.simulation},
                                         {"full_rebuild", f.rebuild},
                                         {"unit", "ms"}};
    std::puts(line.dump().c_str());
    std::fflush(stdout);
}

void printRatios(const Figures& small, const Figures& large) {
    const nlohmann::ordered_json line = {
        {"name", "cut/scaling"},
        {"from_triangles", small.triangles},
        {"to_triangles", large.triangles},
        {"cutter", large.cutter / small.cutter},
        {"model_update", large.model / small.model},
        {"upload", large.upload / small.upload},
        {"step", large.step / small.step},
        {"step_in_caches", large.stepInCaches / small.stepInCaches},
        {"simulation", large.simulation / small.simulation},
        {"rebuild_over_update_and_upload", large.rebuild / (large.model + large.upload)}};
    std::puts(line.dump().c_str());
}

std::vector<int> subdivisionsOf(int count, char** words) {
    if (count < 2) {
        return {3, 5, 6, 7};
    }
    std::vector<int> chosen;
    std::transform(words + 1, words + count, std::back_inserter(chosen), std::atoi);
    return chosen;
}

}  // namespace
}  // namespace kerf

/// Usage: kerf_cut_bench [SUBDIVISIONS...], 20 * 4^n triangles each.
int main(int count, char** words) {
    try {
        const kerf::gpu::EglContext context;
        std::vector<kerf::SphereBench> spheres;
        for (const int subdivisions : kerf::subdivisionsOf(count, words)) {
            spheres.emplace_back(subdivisions);
        }
        for (int round = 0; round < kerf::kRounds; ++round) {
            for (kerf::SphereBench& sphere : spheres) {
                sphere.runRound();
            }
        }
        std::vector<kerf::Figures> figures;
        for (const kerf::SphereBench& sphere : spheres) {
            figures.push_back(sphere.figures());
            kerf::print(figures.back());
        }
        kerf::printRatios(figures.front(), figures.back());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
