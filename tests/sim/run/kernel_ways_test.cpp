// Kernels take one of two ways, by the driver (gpu::KernelWay), and wait for each other no longer
// than they must. A body must feel neither.
#include <gtest/gtest.h>

#include "gpu/context.h"
#include "sim/run/simulation.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/shapes.h"
#include "tests/support/variable.h"

namespace kerf {
namespace {

class KernelWays : public test::GlTest {};

/// A body is cut, falls onto a box and the floor, and meets itself; the hashes of its states.
std::vector<std::string> courseOf(const SurfaceMesh& mesh, SolverMode solver) {
    constexpr int kCutSteps = 12;
    constexpr int kSteps = 36;
    Params params;
    params.solver = solver;
    params.floor = -0.53;
    params.iterations = 4;
    StaticBox box;
    box.center = Vec3(0.2, -0.55, 0);
    box.size = Vec3(0.3, 0.1, 0.3);
    Simulation simulation(mesh, params, {box});
    std::vector<std::string> hashes;
    for (int i = 0; i < kSteps; ++i) {
        if (i <= kCutSteps) {
            const double y = 0.7 - 1.5 * i / kCutSteps;
            EXPECT_EQ(simulation.execute(MoveBlade{{{-1, y, 0.013}, {1, y, 0.013}}}), "");
        } else if (i == kCutSteps + 1) {
            EXPECT_EQ(simulation.execute(LiftBlade{}), "");
        }
        simulation.step();
        hashes.push_back(simulation.stateHash());
    }
    EXPECT_EQ(simulation.report().pieces, 2);
    return hashes;
}

TEST_F(KernelWays, AndBarriersChangeNoBit) {
    for (const SolverMode solver : {SolverMode::implicit, SolverMode::pbd}) {
        for (const SurfaceMesh& mesh : {test::cubeSphere(6, 0.5), test::icosphere(4, 0.5)}) {
            SCOPED_TRACE(std::to_string(mesh.vertexCount()) + " vertices");
            const std::vector<std::string> course = courseOf(mesh, solver);
            for (const auto& [name, value] :
                 {std::pair("KERF_KERNELS", "images"), std::pair("KERF_KERNELS", "shared"),
                  std::pair("KERF_BARRIERS", "all")}) {
                if (value == std::string_view("images") && !gpu::queryDevice().software) {
                    continue;  // GPUs have too few images
                }
                const test::Variable variable(name, value);
                EXPECT_EQ(courseOf(mesh, solver), course) << name << "=" << value;
            }
        }
    }
}

}  // namespace
}  // namespace kerf
