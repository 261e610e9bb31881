// llvmpipe ends all loops of a thread after 65,535 turns together. What the kernel of sweeps does
// turn is counted here, and compared with what is reckoned.
#include "sim/solve/sweep_group.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "gpu/data_path.h"
#include "gpu/shader_source.h"
#include "sim/body/solver_uniforms.h"
#include "sim/solve/gpu_solver.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/plain_pbd.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kTurnsBinding = 16;  // what no kernel uses
constexpr std::uint32_t kThreads = 128;      // of the group on llvmpipe
constexpr std::size_t kSpared = 65535 - kMostTurns;

/// Eight threads of llvmpipe run side by side, and look at the condition of a loop together: all
/// of them load the same count, then all store it.
const std::string kCounter =
    "layout(std430, binding = " + std::to_string(kTurnsBinding) + ") buffer Turns { uint turns[" +
    std::to_string(kThreads / 8) +
    "]; };\nuint countTurn() { return turns[gl_LocalInvocationID.x / 8u] += 1u; }\n";

/// The kernel with all that it includes, where each loop counts its turns.
std::string countingKernel() {
    static const std::regex kLoop(R"(\bfor \(([^;]*);([^;]*);)");
    const std::string text = gpu::loadShaderSource(gpu::shaderRoot(), "sim/sweeps.comp", {}).text;
    const std::string body = text.substr(text.find('\n') + 1);  // without #version
    return kCounter + std::regex_replace(body, kLoop, "for ($1; (countTurn(), $2);");
}

/// Shaders are those of a folder where that kernel is the counting one.
class SweepGroupTest : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (gpu::kernelWay() != gpu::KernelWay::images) {
            GTEST_SKIP() << "only llvmpipe counts turns";
        }
        const std::string kernel = countingKernel();
        fs::copy(gpu::shaderRoot(), folder_ / "shaders", fs::copy_options::recursive);
        test::writeText(folder_ / "shaders/sim/sweeps.comp", kernel);
        fs::create_directory_symlink(gpu::dataPath("assets"), folder_ / "assets");
        setenv("KERF_DATA_DIR", folder_.path().c_str(), 1);
    }
    void TearDown() override {
        unsetenv("KERF_DATA_DIR");
        GlTest::TearDown();
    }

    /// Turns of the thread that turns most in a step of so many sweeps, which is one dispatch.
    static std::size_t turnsOf(int sweeps, const BodyModel& model, const BodyState& start) {
        Params params = test::plainPbd();
        params.iterations = sweeps;
        GpuSolver gpu;
        gpu.setModel(model, start);
        gpu.setUniforms(solverUniforms(params));
        gpu::Buffer turns;
        turns.resize(kThreads / 8 * sizeof(std::uint32_t));
        turns.bindStorage(kTurnsBinding);
        turns.clear();
        gpu.step();
        EXPECT_EQ(gpu.dispatches(), 2) << "with the masses";
        return std::ranges::max(turns.read<std::uint32_t>(0, kThreads / 8));
    }

  private:
    test::TemporaryFolder folder_;
};

TEST_F(SweepGroupTest, TurnsNoMoreOftenThanReckoned) {
    const std::vector<SurfaceMesh> bodies{
        test::builtin("sphere20"), test::builtin("sphere768"), test::bentTube(), test::icosphere(4),
        test::meshOf(test::joined(test::icosphereSoup(2), test::icosphereSoup(1), {3, 0, 0}))};
    for (const SurfaceMesh& mesh : bodies) {
        SCOPED_TRACE(std::to_string(mesh.vertexCount()) + " vertices");
        const BodyModel model = buildBodyModel(mesh);
        const std::size_t two = turnsOf(2, model, stateOf(mesh));
        const std::size_t four = turnsOf(4, model, stateOf(mesh));
        const std::size_t each = (four - two) / 2;
        const std::size_t reckoned = mostTurnsOfSweep(model, kThreads);
        EXPECT_LE(each, reckoned);
        EXPECT_GE(each, reckoned / 4);
        EXPECT_LE(two - 2 * each, kSpared);
    }
}

}  // namespace
}  // namespace kerf
