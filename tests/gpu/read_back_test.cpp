#include "gpu/read_back.h"

#include <gmock/gmock.h>

#include <random>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/traffic.h"
#include "tests/paths.h"
#include "tests/support/gl_fixture.h"

namespace kerf::gpu {
namespace {

using ::testing::ElementsAreArray;

using Values = std::vector<std::uint32_t>;

class SentTogether : public test::GlTest {
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

}  // namespace
}  // namespace kerf::gpu
