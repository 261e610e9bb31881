#pragma once

#include "sim/run/simulation.h"
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
