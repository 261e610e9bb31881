// The checks of tests/fuzz/fuzzer.cpp on so many random texts, for which no libFuzzer is needed.

#include "tests/support/fuzz/fuzz_target.h"
#include "tests/support/fuzz/text_mutator.h"

namespace kerf::test {
namespace {

constexpr std::uint32_t kSeed = 20261121;

class FuzzTargets : public ::testing::TestWithParam<FuzzTarget> {};

/// The beginning of a text, with numbers for what would not print.
std::string shown(const std::string& text) {
    return ::testing::PrintToString(text.substr(0, 2000));
}

TEST_P(FuzzTargets, TextsToStartFromKeepThePromise) {
    for (const std::string& text : GetParam().texts()) {
        EXPECT_EQ(GetParam().read(text).broken, "") << shown(text);
    }
}

TEST_P(FuzzTargets, TextsThatAreRefusedKeepThePromise) {
    for (const std::string& text :
         GetParam().refused != nullptr ? GetParam().refused() : std::vector<std::string>{}) {
        const FuzzOutcome outcome = GetParam().read(text);
        EXPECT_EQ(outcome.broken, "") << shown(text);
        EXPECT_FALSE(outcome.accepted) << shown(text);
    }
}

TEST_P(FuzzTargets, WhatWasFoundOnceKeepsThePromise) {
    for (const std::string& text : foundTexts(GetParam())) {
        EXPECT_EQ(GetParam().read(text).broken, "") << shown(text);
    }
}

TEST_P(FuzzTargets, RandomTextsAreRefusedOrReadBackAsTheSame) {
    const std::uint32_t seed = fuzzSeed(kSeed);
    TextMutator mutator(GetParam().texts(), GetParam().words(), seed);
    int accepted = 0;
    for (int i = 0; i < GetParam().rounds; ++i) {
        const std::string text = mutator.next();
        const FuzzOutcome outcome = GetParam().read(text);
        ASSERT_EQ(outcome.broken, "") << "seed " << seed << ", text " << i << ": " << shown(text);
        accepted += outcome.accepted ? 1 : 0;
    }
    std::cout << accepted << " of " << GetParam().rounds << " were accepted\n";
    EXPECT_GE(accepted, GetParam().leastAccepted)
        << "too few to say anything about what is written";
}

std::string nameOf(const ::testing::TestParamInfo<FuzzTarget>& tested) {
    std::string name(tested.param.name);
    std::erase(name, '-');
    return name;
}
INSTANTIATE_TEST_SUITE_P(Of, FuzzTargets, ::testing::ValuesIn(fuzzTargets()), nameOf);

TEST(FuzzFindings, EachFolderOfFindingsIsThatOfATarget) {
    for (const auto& entry : fs::directory_iterator(KERF_SOURCE_DIR "/tests/fuzz/found")) {
        EXPECT_NE(findFuzzTarget(entry.path().filename().string()), nullptr) << entry.path();
    }
}

}  // namespace
}  // namespace kerf::test
