#include "gpu/timer.h"

#include <glad/gl.h>

#include <chrono>

#include "gpu/buffer.h"
#include "gpu/framebuffer.h"
#include "gpu/program.h"
#include "tests/paths.h"
#include "tests/support/gl_fixture.h"

namespace kerf::gpu {
namespace {

class TimerTest : public test::GlTest {
  protected:
    /// GPU work that takes longer than the clock's step.
    static void work() {
        const Program program = Program::compute(
            std::string(KERF_SOURCE_DIR) + "/tests/gpu/shaders/scale.comp", {{"OFFSET", "1u"}});
        Buffer values;
        values.resize(kCount * sizeof(std::uint32_t));
        values.bindStorage(0);
        program.set("count", kCount);
        program.dispatch(kCount);
    }

    static constexpr std::uint32_t kCount = 1 << 18;
};

TEST_F(TimerTest, MeasuresComputeWork) {
    Timer timer;
    timer.begin();
    work();
    timer.end();
    EXPECT_GT(timer.takeMilliseconds(), 0.0);
}

/// llvmpipe takes timestamps with the picture: they would be alike here.
TEST_F(TimerTest, MeasuresComputeWorkWhileAPictureIsDrawn) {
    const Framebuffer picture(GL_RGBA8, GL_DEPTH_COMPONENT24, 256, 256);
    picture.bind();
    ComputeTimer timer;
    work();  // compiles
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    timer.begin();
    work();
    timer.end();
    glFinish();
    const std::chrono::duration<double, std::milli> all = std::chrono::steady_clock::now() - start;
    const double measured = timer.takeMilliseconds();
    EXPECT_GT(measured, 0.2 * all.count());
    EXPECT_EQ(timer.takeMilliseconds(), 0.0);
}

TEST_F(TimerTest, TakeStartsAnew) {
    Timer timer;
    EXPECT_EQ(timer.takeMilliseconds(), 0.0);
    timer.begin();
    work();
    timer.end();
    timer.begin();
    timer.end();
    timer.takeMilliseconds();
    EXPECT_EQ(timer.takeMilliseconds(), 0.0);
}

}  // namespace
}  // namespace kerf::gpu
