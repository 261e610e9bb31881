#include "gpu/mapped_ring.h"

#include <glad/gl.h>
#include <gmock/gmock.h>

#include <array>
#include <optional>
#include <random>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "tests/paths.h"
#include "tests/support/gl_fixture.h"

namespace kerf::gpu {
namespace {

using ::testing::Each;
using ::testing::ElementsAreArray;

using Values = std::vector<std::uint32_t>;

class MappedRingTest : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        kernel_ = Program::compute(std::string(KERF_SOURCE_DIR) + "/tests/gpu/shaders/scale.comp",
                                   {{"OFFSET", "1u"}});
    }

    /// A kernel writes multiples of `factor`, and one, into the next slot.
    int write(std::uint32_t count, std::uint32_t factor) {
        const int slot = ring_.bindNext(0);
        kernel_->set("count", count);
        kernel_->set("factor", factor);
        kernel_->dispatch(count);
        ring_.fence();
        return slot;
    }

    static Values written(std::uint32_t count, std::uint32_t factor) {
        Values values(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            values[i] = i * factor + 1;
        }
        return values;
    }

    std::span<const std::uint32_t> read(int slot, std::uint32_t count) const {
        return ring_.read<std::uint32_t>(slot, count);
    }

    std::optional<Program> kernel_;  ///< once there is a context
    MappedRing ring_;
};

TEST_F(MappedRingTest, GivesBackWhatAKernelWrote) {
    ring_.reserve(4000);
    const int slot = write(1000, 3);
    EXPECT_THAT(read(slot, 1000), ElementsAreArray(written(1000, 3)));
    EXPECT_THAT(read(slot, 1000), ElementsAreArray(written(1000, 3))) << "read again";
}

TEST_F(MappedRingTest, SlotsOnTheirWayDoNotTouchEachOther) {
    constexpr std::uint32_t kCount = 1001;  // no multiple of an alignment
    ring_.reserve(kCount * sizeof(std::uint32_t));
    std::vector<int> slots;
    for (std::uint32_t factor = 1; factor <= MappedRing::kSlots; ++factor) {
        slots.push_back(write(kCount, factor));
    }
    for (std::uint32_t factor = MappedRing::kSlots; factor >= 1; --factor) {
        EXPECT_THAT(read(slots[factor - 1], kCount), ElementsAreArray(written(kCount, factor)));
    }
}

TEST_F(MappedRingTest, ComesRoundToTheSlotOfLongestAgo) {
    ring_.reserve(400);
    const int first = write(100, 1);
    const int second = write(100, 2);
    const int third = write(100, 3);
    const std::span<const std::uint32_t> kept = read(second, 100);
    EXPECT_EQ(write(100, 4), first);
    EXPECT_THAT(read(first, 100), ElementsAreArray(written(100, 4)));
    EXPECT_THAT(kept, ElementsAreArray(written(100, 2)));
    EXPECT_THAT(read(third, 100), ElementsAreArray(written(100, 3)));
}

TEST_F(MappedRingTest, GrowsWithHeadroom) {
    ring_.reserve(1000);
    ring_.reserve(1001);
    EXPECT_EQ(ring_.capacity(), 1500u);
    ring_.reserve(10);
    EXPECT_EQ(ring_.capacity(), 1500u);
    const int slot = write(375, 7);
    EXPECT_THAT(read(slot, 375), ElementsAreArray(written(375, 7)));
}

TEST_F(MappedRingTest, NewRoomIsZero) {
    ring_.reserve(400);
    write(100, 5);
    ring_.reserve(4000);
    const int slot = ring_.bindNext(0);
    ring_.fence();
    EXPECT_THAT(read(slot, 1000), Each(0u));
}

/// Writes, reads and growth in any order; every read finds the last that was written to its slot.
TEST_F(MappedRingTest, HoldsWhatWasWrittenLast) {
    const std::uint32_t seed = std::random_device{}();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uint32_t count = 1;
    std::array<std::uint32_t, MappedRing::kSlots> factors{};  // 0: not since the ring grew
    ring_.reserve(count * sizeof(std::uint32_t));
    for (std::uint32_t turn = 1; turn <= 100; ++turn) {
        if (random() % 10 == 0) {
            count = static_cast<std::uint32_t>(ring_.capacity() / sizeof(std::uint32_t)) + 1;
            ring_.reserve(count * sizeof(std::uint32_t));
            factors = {};
        }
        factors[write(count, turn)] = turn;
        const int slot = static_cast<int>(random() % MappedRing::kSlots);
        if (factors[slot] != 0) {
            ASSERT_THAT(read(slot, count), ElementsAreArray(written(count, factors[slot])));
        }
    }
}

TEST_F(MappedRingTest, MoreThanTheDriverAllowsLeavesItAsItIs) {
    ring_.reserve(400);
    const int slot = write(100, 6);
    GLint64 limit = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limit);
    EXPECT_THROW(ring_.reserve(static_cast<std::size_t>(limit) + 1), OutOfMemory);
    EXPECT_EQ(ring_.capacity(), 400u);
    EXPECT_THAT(read(slot, 100), ElementsAreArray(written(100, 6)));
}

}  // namespace
}  // namespace kerf::gpu
