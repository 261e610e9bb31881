#include "gpu/framebuffer.h"

#include <glad/gl.h>
#include <gmock/gmock.h>

#include "gpu/buffer.h"
#include "tests/support/gl_fixture.h"

namespace kerf::gpu {
namespace {

class FramebufferTest : public test::GlTest {
  protected:
    /// Red below, green above, by scissored clears.
    static void paintHalves(const Framebuffer& target) {
        target.bind();
        glEnable(GL_SCISSOR_TEST);
        paint(0, target.height() / 2, target.width(), 1.0f, 0.0f);
        paint(target.height() / 2, target.height(), target.width(), 0.0f, 1.0f);
        glDisable(GL_SCISSOR_TEST);
    }

    static std::vector<int> pixel(const std::vector<std::uint8_t>& picture, int index) {
        const auto* first = picture.data() + 4 * index;
        return {first, first + 4};
    }

  private:
    static void paint(int bottom, int top, int width, float red, float green) {
        glScissor(0, bottom, width, top - bottom);
        glClearColor(red, green, 0.0f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
    }
};

using ::testing::ElementsAre;

TEST_F(FramebufferTest, ReadsTheTopRowFirst) {
    const Framebuffer target(GL_RGBA8, GL_DEPTH_COMPONENT32F, 3, 4);
    paintHalves(target);
    const std::vector<std::uint8_t> picture = target.readColor();
    ASSERT_EQ(picture.size(), 3u * 4u * 4u);
    EXPECT_THAT(pixel(picture, 0), ElementsAre(0, 255, 0, 255));
    EXPECT_THAT(pixel(picture, 11), ElementsAre(255, 0, 0, 255));
}

TEST_F(FramebufferTest, ResolvesSamplesIntoAPlainTarget) {
    const Framebuffer samples(GL_RGBA8, GL_DEPTH_COMPONENT32F, 8, 8, 4);
    const Framebuffer plain(GL_RGBA8, GL_DEPTH_COMPONENT32F, 8, 8);
    paintHalves(samples);
    samples.blitColorTo(plain);
    EXPECT_THAT(pixel(plain.readColor(), 0), ElementsAre(0, 255, 0, 255));
    EXPECT_THAT(pixel(plain.readColor(), 63), ElementsAre(255, 0, 0, 255));
}

TEST_F(FramebufferTest, DepthOnlyTargetIsComplete) {
    const Framebuffer shadow(0, GL_DEPTH_COMPONENT32F, 16, 16);
    EXPECT_EQ(glCheckNamedFramebufferStatus(shadow.id(), GL_FRAMEBUFFER),
              static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    EXPECT_EQ(shadow.color().id(), 0u);
}

TEST_F(FramebufferTest, TooLargeIsRefused) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    EXPECT_THROW(Framebuffer(GL_RGBA8, GL_DEPTH_COMPONENT32F, limit + 1, 1), OutOfMemory);
}

}  // namespace
}  // namespace kerf::gpu
