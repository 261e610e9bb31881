// llvmpipe ends all loops of a thread after 65,535 turns together. What the kernel that solves
// small bodies does turn is counted here, and compared with what the solver reckons.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "gpu/data_path.h"
#include "gpu/shader_source.h"
#include "sim/body/solver_uniforms.h"
#include "sim/mesh/invariants.h"
#include "sim/solve/gpu_solver.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/shapes.h"
#include "tests/support/small_steps.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using gpu::KernelWay;

constexpr std::uint32_t kTurnsBinding = 16;  // what no kernel uses
constexpr std::size_t kThreads = 512;

/// Eight threads of llvmpipe run side by side, and look at the condition of a loop together: all
/// of them load the same count, then all store it.
const std::string kCounter =
    "layout(std430, binding = " + std::to_string(kTurnsBinding) + ") buffer Turns { uint turns[" +
    std::to_string(kThreads / 8) +
    "]; };\nuint countTurn() { return turns[gl_LocalInvocationID.x / 8u] += 1u; }\n";

/// The kernel with all that it includes, where each loop counts its turns.
std::string countingKernel() {
    static const std::regex kLoop(R"(\bfor \(([^;]*);([^;]*);)");
    const std::string text =
        gpu::loadShaderSource(gpu::shaderRoot(), "sim/small_body.comp", {}).text;
    const std::string body = text.substr(text.find('\n') + 1);  // without #version
    return kCounter + std::regex_replace(body, kLoop, "for ($1; (countTurn(), $2);");
}

/// Shaders are those of a folder where that kernel is the counting one.
class SolverLoops : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (gpu::kernelWay() != KernelWay::images) {
            GTEST_SKIP() << "only llvmpipe counts turns";
        }
        const std::string kernel = countingKernel();
        fs::copy(gpu::shaderRoot(), folder_ / "shaders", fs::copy_options::recursive);
        test::writeText(folder_ / "shaders/sim/small_body.comp", kernel);
        fs::create_directory_symlink(gpu::dataPath("assets"), folder_ / "assets");
        setenv("KERF_DATA_DIR", folder_.path().c_str(), 1);
    }
    void TearDown() override {
        unsetenv("KERF_DATA_DIR");
        GlTest::TearDown();
    }

    /// Turns of the thread that turns most in a time step, which must be one dispatch.
    std::size_t turnsOfStep(const SurfaceMesh& mesh, KernelWay way, const Params& params) {
        const BodyModel model = buildBodyModel(mesh);
        GpuSolver gpu;
        gpu.stepper().setSmallBody(SmallBodySolver(way));
        gpu.setModel(model, stateOf(mesh));
        gpu.collisions().setSettings(contactSettings(params));
        gpu.collisions().expect(meshBounds(mesh), {}, {.folded = folded_});
        shared::SolverUniforms uniforms = solverUniforms(params);
        uniforms.active_parts |= (1u << kConstraintTypes) - 1;
        gpu.setUniforms(uniforms);
        if (params.solver == SolverMode::smallSteps) {
            gpu.setPulls({{1, 0.1f, 0.2f, 0.3f, 1, 0, 0, 0}});
        }
        gpu::Buffer turns;
        turns.resize(kThreads / 8 * sizeof(std::uint32_t));
        turns.bindStorage(kTurnsBinding);
        gpu.step();
        turns.clear();
        const long before = gpu.dispatches();
        gpu.step();
        EXPECT_EQ(gpu.dispatches() - before, 1);
        const SmallBodySolver& small = gpu.stepper().smallBody();
        reckoned_ = params.solver == SolverMode::pbd ? small.turnsOfSweep()
                    : params.contact != 0            ? small.turnsOfTouching(folded_, 0)
                                                     : small.turnsOfSubstep();
        return std::ranges::max(turns.read<std::uint32_t>(0, kThreads / 8));
    }

    /// Expects no more turns than reckoned in each substep or sweep, and not many less.
    void expectReckoned(const SurfaceMesh& mesh, KernelWay way, SolverMode solver) {
        SCOPED_TRACE(std::to_string(mesh.vertexCount()) + " vertices");
        Params params = test::smallSteps();
        params.solver = solver;
        params.contact = 0;
        params.iterations = 2;
        const std::size_t two = turnsOfStep(mesh, way, params);
        params.iterations = 6;
        const std::size_t six = turnsOfStep(mesh, way, params);
        const std::size_t each = (six - two) / 4;
        EXPECT_LE(each, reckoned_);
        EXPECT_GE(each, reckoned_ / 2);
        EXPECT_LE(two - 2 * each, kSparedTurns);
    }

    /// The same with contact, where not all turn as often as they might.
    void expectTouchingReckoned(const SurfaceMesh& mesh, KernelWay way, bool folded) {
        folded_ = folded;
        Params params = test::smallSteps();
        params.iterations = 4;
        const std::size_t four = turnsOfStep(mesh, way, params);
        EXPECT_LE(four, 4 * reckoned_ + kSparedTurns);
        EXPECT_GE(four, reckoned_);
    }

  private:
    bool folded_ = false;
    test::TemporaryFolder folder_;
    std::size_t reckoned_ = 0;
};

std::vector<SurfaceMesh> loopedBodies() {
    return {test::builtin("sphere20"), test::builtin("sphere768"), test::cubeSphere(8),
            test::bentTube(),
            test::meshOf(test::joined(test::icosphereSoup(2), test::icosphereSoup(1), {3, 0, 0}))};
}

TEST_F(SolverLoops, OfASubstepTurnAsOftenAsReckoned) {
    for (const SurfaceMesh& mesh : loopedBodies()) {
        expectReckoned(mesh, KernelWay::images, SolverMode::smallSteps);
    }
    expectReckoned(test::cubeSphere(8), KernelWay::shared, SolverMode::smallSteps);
}

/// Every vertex of both has triangles near it that it may touch.
SurfaceMesh nestedSpheres() {
    TriangleSoup inner = test::icosphereSoup(2);
    for (Vec3& p : inner.positions) {
        p *= 1.001;
    }
    return test::meshOf(test::joined(test::icosphereSoup(2), inner, Vec3::Zero()));
}

TEST_F(SolverLoops, OfATouchingSubstepTurnAsOftenAsReckoned) {
    for (const KernelWay way : {KernelWay::images, KernelWay::shared}) {
        for (const bool folded : {false, true}) {
            expectTouchingReckoned(nestedSpheres(), way, folded);
        }
    }
}

TEST_F(SolverLoops, OfASweepTurnAsOftenAsReckoned) {
    for (const SurfaceMesh& mesh : loopedBodies()) {
        expectReckoned(mesh, KernelWay::images, SolverMode::pbd);
    }
    expectReckoned(test::icosphere(4), KernelWay::images, SolverMode::pbd);
    expectReckoned(test::cubeSphere(8), KernelWay::shared, SolverMode::pbd);
}

}  // namespace
}  // namespace kerf
