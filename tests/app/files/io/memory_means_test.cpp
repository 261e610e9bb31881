// What memory there is, and what is said where it does not do.
#include "app/files/io/memory_means.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <cstdlib>

#include "tests/support/variable.h"

namespace kerf::app {
namespace {

using ::testing::HasSubstr;

constexpr const char* kBytes = "KERF_MEMORY_BYTES";

std::string sentenceBy(const std::function<void()>& call) {
    try {
        call();
    } catch (const MemoryShortage& shortage) {
        return shortage.what();
    }
    return "";
}

TEST(MemoryMeans, AVariableStandsForTheMachine) {
    const std::uint64_t free = freeMemory();
    EXPECT_GT(free, 10'000'000U);
    const test::Variable variable(kBytes, "1000000");
    EXPECT_EQ(freeMemory(), 1'000'000U);
    for (const char* wrong : {"1GB", "x", "", "-1"}) {
        const test::Variable other(kBytes, wrong);
        EXPECT_GT(freeMemory(), 10'000'000U) << wrong;
    }
}

TEST(MemoryMeans, AnswersToTheLimitsOfTheProcess) {
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_DATA, &before), 0);
    rlimit limit = before;
    limit.rlim_cur = 64ULL << 30;
    const std::uint64_t free = freeMemory();
    if (::setrlimit(RLIMIT_DATA, &limit) != 0) {
        GTEST_SKIP() << "this process may not limit itself";
    }
    EXPECT_LE(freeMemory(), 64ULL << 30);
    limit.rlim_cur = 1ULL << 30;
    ASSERT_EQ(::setrlimit(RLIMIT_DATA, &limit), 0);
    EXPECT_LE(freeMemory(), 1ULL << 30);
    ASSERT_EQ(::setrlimit(RLIMIT_DATA, &before), 0);
    EXPECT_NEAR(static_cast<double>(freeMemory()) / static_cast<double>(free), 1, 0.5);
}

TEST(MemoryMeans, NothingIsSaidWhereItDoes) {
    const MemoryNeed need{.memory = 10, .program = 5, .graphics = 3, .largestBuffer = 2};
    EXPECT_EQ(sentenceBy([&] { requireMemory("a", need, {}); }), "");
    EXPECT_EQ(sentenceBy([&] { requireMemory("a", need, {.free = 15}); }), "");
    EXPECT_NE(sentenceBy([&] { requireMemory("a", need, {.free = 14}); }), "");
    EXPECT_EQ(sentenceBy([&] { requireMemory("a", need, {.free = 14, .programRuns = true}); }), "");
    EXPECT_NE(sentenceBy([&] { requireMemory("a", need, {.free = 15, .holdsGraphics = true}); }),
              "");
    EXPECT_NE(sentenceBy([&] { requireMemory("a", need, {.largestBuffer = 1}); }), "");
}

TEST(MemoryMeans, OneSentenceSaysHowMuchAndWhatToDo) {
    const MemoryNeed need{.memory = 3'400'000'000, .graphics = 1, .largestBuffer = 150'000'000};
    const std::string memory =
        sentenceBy([&] { requireMemory("bunny.ply", need, {.free = 210'000'000}); });
    EXPECT_THAT(memory, HasSubstr("bunny.ply: cutting it needs about 3.4 GB of memory"));
    EXPECT_THAT(memory, HasSubstr("210 MB are free"));
    EXPECT_THAT(memory, HasSubstr("--remesh"));
    const std::string buffer =
        sentenceBy([&] { requireMemory("bunny.ply", need, {.largestBuffer = 134'217'728}); });
    EXPECT_THAT(buffer, HasSubstr("a graphics buffer of 150 MB"));
    EXPECT_THAT(buffer, HasSubstr("134 MB"));
}

}  // namespace
}  // namespace kerf::app
