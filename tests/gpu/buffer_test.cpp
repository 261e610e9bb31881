#include "gpu/buffer.h"

#include "gpu/bindings.h"
#include "gpu/context.h"
#include "gpu/framebuffer.h"
#include "gpu/program.h"
#include "gpu/read_back.h"
#include "gpu/traffic.h"

namespace kerf::gpu {
namespace {

class BufferTest : public GlTest {};

std::vector<int> counting(std::size_t count) {
    std::vector<int> values(count);
    std::iota(values.begin(), values.end(), 1);
    return values;
}

TEST_F(BufferTest, GivesBackWhatWasAssignedWrittenAndCleared) {
    Buffer buffer;
    buffer.assign(counting(1000));
    EXPECT_EQ(buffer.size(), 4000u);
    EXPECT_EQ(buffer.read<int>(0, 1000), counting(1000));
    EXPECT_EQ(buffer.read<int>(998, 2), (std::vector<int>{999, 1000}));
    buffer.write<int>(1, std::vector<int>{20, 30});
    EXPECT_THAT(buffer.read<int>(0, 5), ElementsAre(1, 20, 30, 4, 5));
    buffer.clear();
    EXPECT_THAT(buffer.read<int>(0, 1000), Each(0));
}

TEST_F(BufferTest, GrowthKeepsTheContentAndAddsZeros) {
    Buffer buffer;
    buffer.assign(counting(3));
    buffer.resize(1000 * sizeof(int));
    EXPECT_THAT(buffer.read<int>(0, 3), ElementsAre(1, 2, 3));
    EXPECT_THAT(buffer.read<int>(3, 997), Each(0));
    buffer.resize(sizeof(int));
    buffer.resize(4 * sizeof(int));
    EXPECT_THAT(buffer.read<int>(0, 4), ElementsAre(1, 0, 0, 0)) << "nothing old";
}

TEST_F(BufferTest, GrowsWithHeadroom) {
    Buffer buffer;
    buffer.resize(1000);
    buffer.resize(1001);
    EXPECT_EQ(buffer.size(), 1001u);
    EXPECT_EQ(buffer.capacity(), 1500u);
    const std::uint32_t id = buffer.id();
    buffer.resize(1500);
    EXPECT_EQ(buffer.id(), id);
}

TEST_F(BufferTest, EmptyAssignLeavesBindableZeros) {
    Buffer buffer;
    buffer.assign(counting(8));
    buffer.assign(std::vector<int>{});
    EXPECT_EQ(buffer.size(), 16u);
    EXPECT_THAT(buffer.read<int>(0, 4), Each(0));
    buffer.bindStorage(0);
    Buffer nothing;
    nothing.resize(0);
    EXPECT_EQ(nothing.size(), 0u);
    nothing.bindStorage(0);
}

TEST_F(BufferTest, ACopyHasSizeAndContentAndIsOnItsOwn) {
    Buffer original;
    original.assign(counting(3));
    Buffer copy;
    copy.assign(counting(9));
    copy.copyFrom(original);
    original.clear();
    EXPECT_EQ(copy.size(), 12u);
    EXPECT_THAT(copy.read<int>(0, 3), ElementsAre(1, 2, 3));
}

TEST_F(BufferTest, MoveTakesTheStorageAlong) {
    Buffer first;
    first.assign(counting(2));
    Buffer second = std::move(first);
    Buffer third;
    third = std::move(second);
    EXPECT_THAT(third.read<int>(0, 2), ElementsAre(1, 2));
}

TEST_F(BufferTest, PartsOfStorageAreAllThereIs) {
    Buffer buffer;
    buffer.assign(counting(1000));
    std::size_t next = 0;
    buffer.bindStorageParts(0, sizeof(int), [&](std::size_t first, std::size_t count) {
        EXPECT_EQ(first, next);
        GLint64 offset = -1;
        GLint64 bytes = -1;
        glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, 0, &offset);
        glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, 0, &bytes);
        EXPECT_EQ(offset, GLint64(first * sizeof(int)));
        EXPECT_EQ(bytes, GLint64(count * sizeof(int)));
        next = first + count;
    });
    EXPECT_EQ(next, 1000u);
}

TEST_F(BufferTest, TooLargeIsRefusedWithTheNumbersAndChangesNothing) {
    GLint64 limit = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limit);
    const std::size_t tooLarge = static_cast<std::size_t>(limit) + 1;
    Buffer buffer;
    buffer.assign(counting(2));
    try {
        buffer.resize(tooLarge);
        FAIL() << "took " << tooLarge << " bytes";
    } catch (const OutOfMemory& error) {
        EXPECT_THAT(error.what(), HasSubstr(std::to_string(tooLarge) + " bytes"));
        EXPECT_THAT(error.what(), HasSubstr(std::to_string(limit) + " bytes"));
    }
    EXPECT_THAT(buffer.read<int>(0, 2), ElementsAre(1, 2));
}

using ::testing::ElementsAreArray;

using Values = std::vector<std::uint32_t>;

class SentTogether : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        kernel_ = Program::compute(std::string(KERF_SOURCE_DIR) + "/tests/gpu/shaders/scale.comp",
                                   {{"OFFSET", "1u"}});
    }

    /// A kernel writes multiples of `factor`, and one, into a buffer.
    void write(Buffer& buffer, std::uint32_t count, std::uint32_t factor) {
        buffer.resize(count * sizeof(std::uint32_t));
        buffer.bindStorage(0);
        kernel_->set("count", count);
        kernel_->set("factor", factor);
        kernel_->dispatch(count);
    }

    static Values written(std::uint32_t count, std::uint32_t factor) {
        Values values(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            values[i] = i * factor + 1;
        }
        return values;
    }

    std::span<const std::uint32_t> read(std::size_t place, std::uint32_t count) const {
        return back_.read<std::uint32_t>(place, count);
    }

    std::optional<Program> kernel_;  ///< once there is a context
    ReadBack back_;
};

TEST_F(SentTogether, GivesBackWhatAKernelWrote) {
    Buffer buffer;
    write(buffer, 1000, 3);
    const std::size_t place = back_.ask(buffer, buffer.size());
    back_.send();
    EXPECT_THAT(read(place, 1000), ElementsAreArray(written(1000, 3)));
    EXPECT_THAT(read(place, 1000), ElementsAreArray(written(1000, 3))) << "read again";
}

TEST_F(SentTogether, SendsSeveralTogetherForOneWait) {
    Buffer one, two, three;
    write(one, 1001, 2);  // no multiple of an alignment
    write(two, 3, 5);
    write(three, 500, 7);
    const std::size_t first = back_.ask(one, 1001 * sizeof(std::uint32_t));
    const std::size_t second = back_.ask(two, 3 * sizeof(std::uint32_t));
    const std::size_t third = back_.ask(three, 100 * sizeof(std::uint32_t));
    back_.send();
    const Traffic before = traffic();
    EXPECT_THAT(read(third, 100), ElementsAreArray(written(100, 7)));
    EXPECT_THAT(read(first, 1001), ElementsAreArray(written(1001, 2)));
    EXPECT_THAT(read(second, 3), ElementsAreArray(written(3, 5)));
    const Traffic during = traffic() - before;
    EXPECT_EQ(during.waits, 1u);
    EXPECT_EQ(during.reads, 0u);
}

TEST_F(SentTogether, WhatIsWrittenAfterwardsIsNotSent) {
    Buffer buffer;
    write(buffer, 1000, 3);
    const std::size_t place = back_.ask(buffer, buffer.size());
    back_.send();
    write(buffer, 1000, 4);
    EXPECT_THAT(read(place, 1000), ElementsAreArray(written(1000, 3)));
}

/// Sizes and numbers of parts at random, so that the memory grows at times.
TEST_F(SentTogether, HoldsWhatWasSentLast) {
    const std::uint32_t seed = std::random_device{}();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (std::uint32_t turn = 1; turn <= 50; ++turn) {
        std::vector<Buffer> buffers(1 + random() % 4);
        Values counts;
        std::vector<std::size_t> places;
        for (std::uint32_t i = 0; i < buffers.size(); ++i) {
            counts.push_back(1 + static_cast<std::uint32_t>(random() % (40 * turn)));
            write(buffers[i], counts[i], turn + i);
            places.push_back(back_.ask(buffers[i], buffers[i].size()));
        }
        back_.send();
        for (std::uint32_t i = 0; i < buffers.size(); ++i) {
            ASSERT_THAT(read(places[i], counts[i]), ElementsAreArray(written(counts[i], turn + i)));
        }
    }
}

// What a pause checks of OpenGL's context.

class BindingsTest : public GlTest {};

TEST_F(BindingsTest, NamesWhatOthersTakeForUnbound) {
    EXPECT_EQ(clearBindings(), "");
    GLuint array = 0;
    glCreateVertexArrays(1, &array);
    glBindVertexArray(array);
    EXPECT_EQ(clearBindings(), "a vertex array");
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &array);
    Buffer buffer;
    buffer.resize(16);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer.id());
    EXPECT_EQ(clearBindings(), "a buffer of pixels");
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    EXPECT_EQ(clearBindings(), "");
}

TEST_F(BindingsTest, UnbindsWhatEachUserBindsAnew) {
    Buffer buffer;
    buffer.resize(16);
    buffer.bindStorage(3);
    clearBindings();
    GLint bound = -1;
    glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, 3, &bound);
    EXPECT_EQ(bound, 0);
    EXPECT_EQ(glGetError(), GL_NO_ERROR);
}

class FramebufferTest : public GlTest {
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
