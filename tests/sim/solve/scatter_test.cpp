#include "sim/solve/scatter.h"

#include <glad/gl.h>
#include <gtest/gtest.h>

#include "tests/support/gl_fixture.h"

namespace kerf {
namespace {

class ScatterTest : public test::GlTest {
  protected:
    /// The words of a buffer that some drivers can't bind as storage in one go.
    static std::size_t largeCount() {
        constexpr GLint64 kAffordable = 256 << 20;  // a test takes no more of a large GPU
        GLint64 limit = 0;
        glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limit);
        return static_cast<std::size_t>(std::min(limit, kAffordable)) / 4 + 100'000;
    }

    /// More of them than are written by calls, as far as the last.
    static std::vector<std::uint32_t> spreadIndices(std::size_t count) {
        constexpr std::uint32_t kWrites = 500;
        std::vector<std::uint32_t> indices;
        indices.reserve(kWrites);
        for (std::uint64_t i = 0; i < kWrites; ++i) {
            indices.push_back(static_cast<std::uint32_t>(i * (count - 1) / (kWrites - 1)));
        }
        return indices;
    }
};

TEST_F(ScatterTest, WritesWordsBeyondWhatIsBoundAtOnce) {
    const std::size_t count = largeCount();
    const std::vector<std::uint32_t> indices = spreadIndices(count);
    gpu::Buffer target(gpu::Buffer::Readers::texels);
    Scatter scatter;
    scatter.write<std::uint32_t>(target, count, indices, Scatter::Gaps::keep,
                                 [](std::uint32_t i) { return i + 1; });
    for (const std::uint32_t index : indices) {
        EXPECT_EQ(target.read<std::uint32_t>(index, 1).front(), index + 1);
        EXPECT_EQ(target.read<std::uint32_t>(index == 0 ? 1 : index - 1, 1).front(), 0u);
    }
    EXPECT_EQ(indices.back(), count - 1);
}

}  // namespace
}  // namespace kerf
