#include "tests/support/every_kernel.h"

#include "sim/base/boxes.h"
#include "sim/body/solver_uniforms.h"
#include "sim/contact/contact_solver.h"
#include "sim/solve/float_vectors.h"
#include "sim/solve/gpu_solver.h"
#include "sim/solve/implicit/vertex_groups.h"
#include "sim/solve/implicit_stepper.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

/// Two boxes of a metre, one above the other, that overlap a little: a body that needs the kernels
/// of contact.
SurfaceMesh touchingBoxes() {
    const TriangleSoup box = test::boxSoup(Vec3::Ones(), 2);
    return test::meshOf(test::joined(box, box, Vec3(0, 0.95, 0)));
}

/// A body, and how it is solved.
struct Case {
    SurfaceMesh mesh;
    Params params;
    bool folded = false;
};

Params paramsOf(SolverMode mode, bool paperContact) {
    Params params;
    params.solver = mode;
    params.floor = -0.5;
    params.paperContact = paperContact ? 1 : 0;
    return params;
}

/// Thin, so that it may pierce the skin.
StaticBox plate() {
    StaticBox box;
    box.size = Vec3(2, 1e-3, 2);
    return box;
}

/// So thick that nothing pierces it.
StaticBox block() {
    StaticBox box = plate();
    box.size = Vec3(2, 1, 2);
    return box;
}

BladeMotion standingBlade() {
    BladeFrame frame;
    frame.halfLength = 1;
    BladeMotion motion;
    motion.frames = {frame, frame};
    motion.back = 1;
    motion.bevel = 0.1;
    motion.halfThickness = 0.01;
    return motion;
}

PressingEdge pressingEdge() {
    PressingEdge edge;
    edge.to = Vec3::UnitX();
    edge.ahead = -Vec3::UnitY();
    edge.reach = edge.stiffness = edge.mostForce = 1;
    return edge;
}

/// A step of a body that meets all that bodies meet, so that it asks for the kernels of all.
void beginStepOf(const Case& wanted) {
    const BodyState state = stateOf(wanted.mesh);
    GpuSolver solver;
    solver.setModel(buildBodyModel(wanted.mesh), state);
    solver.setUniforms(solverUniforms(wanted.params));
    solver.collisions().setSettings(contactSettings(wanted.params));
    solver.step();  // meets nothing
    solver.collisions().setBoxes({plate()});
    solver.collisions().setBlade(standingBlade());
    solver.collisions().feelBlade(true);
    solver.collisions().setEdge(pressingEdge());
    solver.setPulls(std::vector<shared::PullRecord>(1));
    RelativeMotion motion;
    motion.touching = true;
    motion.folded = wanted.folded;
    solver.collisions().expect(boundsOf(state.positions), boxOf({Vec3(0, -1, 0), Vec3(0, 1, 0)}),
                               motion);
    solver.step();
    ImplicitStep small;
    small.aggregateSize = kPatchSize;  // so many that large meshes have regions
    solver.stepImplicitly(buildBodyModel(wanted.mesh), wanted.params, small, {});
    solver.step();
    solver.stepBySweeps();
    solver.collisions().setBlade(std::nullopt);
    solver.collisions().setEdge(std::nullopt);
    for (const std::vector<StaticBox>& boxes : {std::vector{block()}, {}}) {
        solver.collisions().setBoxes(boxes);
        solver.step();
    }
    if (wanted.params.paperContact != 0) {
        solver.collisions().respondAsThePaper();
    }
}

}  // namespace

void linkEveryKernel() {
    for (const bool folded : {true, false}) {
        beginStepOf({touchingBoxes(), paramsOf(SolverMode::implicit, false), folded});
    }
    beginStepOf({test::box(Vec3::Ones(), 20), paramsOf(SolverMode::implicit, false)});
    beginStepOf({touchingBoxes(), paramsOf(SolverMode::pbd, false)});
    beginStepOf({touchingBoxes(), paramsOf(SolverMode::pbd, true)});
}

}  // namespace kerf
