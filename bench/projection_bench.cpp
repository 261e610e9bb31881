// Million constraint projections per second: a whole step of ours on the GPU beside the links of
// Bullet's soft body on one core, of which only the projections are timed. Edges, bends and ISPCs
// are counted; prediction and floor take their time too. In plain PBD, as in Bullet, they come once
// a step and its 20 iterations are sweeps over the constraints.

#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "bench/bullet_soft_body.h"
#include "bench/timing.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "sim/body/solver_uniforms.h"
#include "sim/mesh/triangle_soup.h"
#include "sim/solve/gpu_solver.h"
#include "tests/support/plain_pbd.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

constexpr int kIterations = 20;
constexpr int kRepeats = 9;

Params benchParams() {
    Params params = test::plainPbd();
    params.iterations = kIterations;
    return params;
}

std::size_t constraintsOf(const BodyModel& model) {
    return model.edges.size() + model.bends.size() + model.ispcs.size();
}

double perSecond(std::size_t constraints, double milliseconds) {
    return 1e-3 * static_cast<double>(constraints) * kIterations / milliseconds;
}

double ourSpeed(const BodyModel& model) {
    GpuSolver solver;
    solver.setModel(model, {model.restPositions,
                            std::vector<Vec3f>(model.restPositions.size(), Vec3f::Zero())});
    solver.setUniforms(solverUniforms(benchParams(), model));
    return perSecond(constraintsOf(model), medianMilliseconds(kRepeats, [&] {
                         solver.step();
                         gpu::finish();
                     }));
}

double theirSpeed(const BodyModel& model) {
    BulletSoftBody body(model, kIterations);
    const double step = benchParams().timeStep;
    std::vector<double> times;
    for (int i = 0; i < kRepeats; ++i) {
        body.predict(step);
        times.push_back(medianMilliseconds(1, [&] { body.project(); }));
    }
    return perSecond(static_cast<std::size_t>(body.links()), median(times));
}

void bench(int subdivisions) {
    // As loading would give it: vertices in the order in which triangles name them.
    const TriangleSoup sphere = weldExactly(test::icosphereSoup(subdivisions, 0.5));
    const BodyModel model =
        buildBodyModel(SurfaceMesh::fromTriangles(sphere.positions, sphere.triangles));
    const double theirs = theirSpeed(model);
    const double ours = ourSpeed(model);
    const nlohmann::ordered_json line = {
        {"name", "projections/" + std::to_string(model.triangles.size())},
        {"ours", ours},
        {"theirs", theirs},
        {"peer", "Bullet's soft body, links alone, one core"},
        {"ratio", ours / theirs},
        {"unit", "million projections/s"}};
    std::puts(line.dump().c_str());
    std::fflush(stdout);
}

}  // namespace
}  // namespace kerf

int main() {
    try {
        const kerf::gpu::EglContext context;
        kerf::bench(5);
        kerf::bench(7);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
