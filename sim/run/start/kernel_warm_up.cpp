#include "sim/run/start/kernel_warm_up.h"

#include <utility>

#include "gpu/program.h"
#include "shaders/shared/small_body_bindings.h"
#include "sim/body/solver_uniforms.h"
#include "sim/contact/contact_solver.h"
#include "sim/run/start/touching_boxes.h"
#include "sim/solve/float_vectors.h"

namespace kerf {

KernelWarmUp::KernelWarmUp(Params params, std::size_t vertices) {
    params.gravity = Vec3(0, -9.81, 0);
    params.floor = 0;
    const SurfaceMesh mesh = touchingBoxes();
    start_ = approachingStateOf(mesh);
    solver_.setModel(buildBodyModel(mesh), start_);
    solver_.setUniforms(solverUniforms(params));
    solver_.collisions().setSettings(contactSettings(params));
    solver_.stepper().allowOneGroup(vertices <= shared::kSmallBodyVertices);
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
