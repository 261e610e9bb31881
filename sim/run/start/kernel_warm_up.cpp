#include "sim/run/start/kernel_warm_up.h"

#include "gpu/program.h"
#include "sim/base/math.h"
#include "sim/body/solver_uniforms.h"
#include "sim/contact/contact_solver.h"
#include "sim/mesh/triangle_soup.h"
#include "sim/solve/float_vectors.h"

namespace kerf {

namespace {

constexpr float kSpeed = 1;  // of the boxes towards each other [m/s]

}  // namespace

SurfaceMesh touchingBoxes() {
    TriangleSoup all;
    for (const double height : {0.5, 1.45}) {
        const TriangleSoup box = boxSurface(Vec3::Ones(), {2, 2, 2});
        const int first = static_cast<int>(all.positions.size());
        for (const Vec3& p : box.positions) {
            all.positions.push_back(p + Vec3(0, height, 0));
        }
        for (const Triangle& t : box.triangles) {
            all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        }
    }
    return SurfaceMesh::fromTriangles(all.positions, all.triangles);
}

BodyState approachingStateOf(const SurfaceMesh& mesh) {
    BodyState state = stateOf(mesh);
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        const bool upper = v >= state.positions.size() / 2;
        state.velocities[v] = Vec3f(0, upper ? -kSpeed : kSpeed, 0);
    }
    return state;
}

Bounds approachingVelocities() {
    return boxOf({Vec3(0, -kSpeed, 0), Vec3(0, kSpeed, 0)});
}

KernelWarmUp::KernelWarmUp(Params params) {
    params.gravity = Vec3(0, -9.81, 0);
    params.floor = 0;
    const SurfaceMesh mesh = touchingBoxes();
    start_ = approachingStateOf(mesh);
    const BodyModel model = buildBodyModel(mesh);
    solver_.setModel(model, start_);
    solver_.setUniforms(solverUniforms(params));
    solver_.collisions().setSettings(contactSettings(params));
    if (params.solver == SolverMode::implicit) {
        solver_.stepImplicitly(model, params, {}, {});
    }
}

bool KernelWarmUp::advance() {
    if (act_ == Act::done) {
        return false;
    }
    const gpu::FirstDispatches limit(1);
    solver_.setState(start_);  // What was left out makes a step worthless.
    solver_.setPulls(act_ == Act::pull ? std::vector<shared::PullRecord>(1)
                                       : std::vector<shared::PullRecord>());
    expect();
    solver_.step();
    solver_.measure();
    if (!limit.foundAny()) {
        act_ = static_cast<Act>(static_cast<int>(act_) + 1);
    }
    return act_ != Act::done;
}

void KernelWarmUp::expect() {
    RelativeMotion motion;
    motion.touching = true;
    motion.folded = act_ == Act::fold;
    solver_.collisions().expect(boundsOf(start_.positions), approachingVelocities(), motion);
}

}  // namespace kerf
