#pragma once

#include "sim/body/body_updater.h"
#include "sim/cut/cut_change.h"
#include "sim/run/simulation.h"
#include "sim/solve/gpu_solver.h"
#include "tests/support/gl_fixture.h"

namespace kerf::test {

/// Nothing falls and nothing lies under it.
inline Params weightless() {
    Params params;
    params.gravity = Vec3::Zero();
    params.floor.reset();
    params.iterations = 10;
    return params;
}

inline void step(Simulation& simulation, int steps) {
    for (int i = 0; i < steps; ++i) {
        simulation.step();
    }
}

/// Leads the blade straight from one place to another.
inline void leadBlade(Simulation& simulation, const Blade& from, const Blade& to, int steps) {
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const Blade blade{from.a + share * (to.a - from.a), from.b + share * (to.b - from.b)};
        EXPECT_EQ(simulation.execute(MoveBlade{blade}), "");
        simulation.step();
    }
}

/// The same, and lifts it in a step more.
inline void makeStroke(Simulation& simulation, const Blade& from, const Blade& to, int steps) {
    leadBlade(simulation, from, to, steps);
    EXPECT_EQ(simulation.execute(LiftBlade{}), "");
    simulation.step();
}

/// Tells a solver what a cut changed in a body; the vertices that were given anew.
inline std::vector<std::uint32_t> followCut(GpuSolver& solver, BodyUpdater& body,
                                            const SurfaceMesh& mesh, const CutDelta& delta) {
    const BodyChange change = body.update(delta);
    std::vector<std::uint32_t> written = rewrittenVertices(mesh, delta);
    solver.update(body.model(), change, written, stateOf(mesh, written));
    return written;
}

/// Base of tests of one simulation, which is made in SetUp() of the test and ends with it.
class SimulationFixture : public GlTest {
  protected:
    void TearDown() override {
        simulation.reset();
        GlTest::TearDown();
    }
    void run(int steps) { step(*simulation, steps); }

    std::optional<Simulation> simulation;
};

}  // namespace kerf::test
