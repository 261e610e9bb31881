#include "app/editor/steps/background_work.h"
#include "gpu/buffer.h"
#include "gpu/kernel_way.h"
#include "gpu/program.h"
#include "tests/app/editor/editor_fixture.h"

namespace kerf::app {
namespace {

/// Whether the editor has run a kernel. It is made again from the same sources, and asked to do
/// nothing.
bool hasRun(const std::string& kernel, const gpu::Defines& defines = {}) {
    const gpu::Program program = gpu::Program::compute(kernel, defines);
    gpu::Buffer groups;
    groups.assign(std::span<const std::uint32_t>(std::array<std::uint32_t, 3>{}));
    const gpu::FirstDispatches none(0);
    program.dispatchIndirect(groups, 0);
    return !none.foundAny();
}

class KernelPreparationTest : public EditorTest {
  protected:
    void startWarmingUp(bool warmsUp) {
        EditorOptions options = plainOptions();
        options.warmsUp = warmsUp;
        start(options);
    }
    static constexpr std::array kOfContact{"sim/contact/candidates.comp", "sim/contact/fit.comp"};
};

// The first stroke of a start had stood still for seconds while they were compiled.
TEST_F(KernelPreparationTest, KernelsOfContactRunBeforeAnybodyTouchesTheBody) {
    startWarmingUp(true);
    for (int i = 0; i < 2000 && editor->idleSeconds() < 1; ++i) {
        editor->frame(0.05);
    }
    for (const char* kernel : kOfContact) {
        EXPECT_TRUE(hasRun(kernel)) << kernel;
    }
    if (gpu::kernelWay() == gpu::KernelWay::images) {
        EXPECT_TRUE(hasRun("sim/implicit/reach.comp", {{"GROUP", "8u"}, {"LOAD_IMAGES", "1"}}));
        EXPECT_TRUE(hasRun("sim/implicit/meet.comp", {{"UNFOLDS", "1"}, {"LOAD_IMAGES", "1"}}));
    }
    EXPECT_EQ(panels().transport.step, 0) << "and nothing happened to it";
}

TEST_F(KernelPreparationTest, WhereItIsNotWantedNothingRuns) {
    startWarmingUp(false);
    EXPECT_GT(editor->idleSeconds(), 1);
    EXPECT_FALSE(hasRun(kOfContact[0]));
}

TEST_F(KernelPreparationTest, ItWaitsWhileSomebodyDoesSomething) {
    startWarmingUp(true);
    for (int i = 0; i < 20; ++i) {
        moveTo(400 + i, 200);
        editor->frame(0.1);
    }
    EXPECT_FALSE(hasRun(kOfContact[0]));
}

}  // namespace
}  // namespace kerf::app
