// The check of tests/fuzz/session_fuzzer.cpp on so many random texts, for which no libFuzzer is
// needed.
#include "tests/support/session_fuzz.h"

#include <gtest/gtest.h>

#include "app/session/session.h"
#include "tests/support/fuzz_seed.h"
#include "tests/support/session_samples.h"

namespace kerf::test {
namespace {

constexpr std::uint32_t kSeed = 20261121;
constexpr int kTexts = 100'000;

bool isAccepted(const std::string& text) {
    try {
        app::parseSession(text, "/");
        return true;
    } catch (const app::InputError&) {
        return false;
    }
}

TEST(SessionFuzz, TextsToStartFromKeepThePromise) {
    for (const std::string& text : sessionTexts()) {
        EXPECT_EQ(brokenPromise(text), "") << text;
    }
}

TEST(SessionFuzz, RandomTextsAreRefusedOrReadBackAsTheSameSession) {
    const std::uint32_t seed = fuzzSeed(kSeed);
    TextMutator mutator({sessionWith(""), sessionWithEveryKey(), sessionWithEveryEvent()}, seed);
    int accepted = 0;
    for (int i = 0; i < kTexts; ++i) {
        const std::string text = mutator.next();
        ASSERT_EQ(brokenPromise(text), "") << "seed " << seed << ", text " << i << ": " << text;
        accepted += isAccepted(text) ? 1 : 0;
    }
    EXPECT_GT(accepted, kTexts / 50) << "too few to say anything about what is written";
}

}  // namespace
}  // namespace kerf::test
