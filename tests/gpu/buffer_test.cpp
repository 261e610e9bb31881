#include "gpu/buffer.h"

#include <glad/gl.h>
#include <gmock/gmock.h>

#include "gpu/context.h"
#include "tests/support/gl_fixture.h"

namespace kerf::gpu {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class BufferTest : public test::GlTest {};

std::vector<int> counting(std::size_t count) {
    std::vector<int> values(count);
    std::iota(values.begin(), values.end(), 1);
    return values;
}

TEST_F(BufferTest, GivesBackWhatWasAssigned) {
    Buffer buffer;
    buffer.assign(counting(1000));
    EXPECT_EQ(buffer.size(), 4000u);
    EXPECT_EQ(buffer.read<int>(0, 1000), counting(1000));
    EXPECT_EQ(buffer.read<int>(998, 2), (std::vector<int>{999, 1000}));
}

TEST_F(BufferTest, GrowthKeepsTheContentAndAddsZeros) {
    Buffer buffer;
    buffer.assign(counting(3));
    buffer.resize(1000 * sizeof(int));
    EXPECT_THAT(buffer.read<int>(0, 3), ElementsAre(1, 2, 3));
    EXPECT_THAT(buffer.read<int>(3, 997), Each(0));
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

TEST_F(BufferTest, ShrunkAndGrownAgainShowsNothingOld) {
    Buffer buffer;
    buffer.assign(counting(4));
    buffer.resize(sizeof(int));
    buffer.resize(4 * sizeof(int));
    EXPECT_THAT(buffer.read<int>(0, 4), ElementsAre(1, 0, 0, 0));
}

TEST_F(BufferTest, WriteReplacesOnlyItsRange) {
    Buffer buffer;
    buffer.assign(counting(5));
    buffer.write<int>(1, std::vector<int>{20, 30});
    EXPECT_THAT(buffer.read<int>(0, 5), ElementsAre(1, 20, 30, 4, 5));
}

TEST_F(BufferTest, EmptyAssignLeavesBindableZeros) {
    Buffer buffer;
    buffer.assign(counting(8));
    buffer.assign(std::vector<int>{});
    EXPECT_EQ(buffer.size(), 16u);
    EXPECT_THAT(buffer.read<int>(0, 4), Each(0));
    buffer.bindStorage(0);
}

TEST_F(BufferTest, ResizedToNothingCanBeBound) {
    Buffer buffer;
    buffer.resize(0);
    EXPECT_EQ(buffer.size(), 0u);
    buffer.bindStorage(0);
}

TEST_F(BufferTest, ClearZeroesTheSizeInUse) {
    Buffer buffer;
    buffer.assign(counting(7));
    buffer.clear();
    EXPECT_THAT(buffer.read<int>(0, 7), Each(0));
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

}  // namespace
}  // namespace kerf::gpu
