#include "app/session/hash_trace.h"

#include <gtest/gtest.h>

#include "app/files/io/errors.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

const std::string kA = "aaaaaaaaaaaaaaaa";
const std::string kB = "bbbbbbbbbbbbbbbb";
const std::string kC = "cccccccccccccccc";

class HashTraceTest : public testing::Test {
  protected:
    HashTrace read(const std::string& text) const {
        test::writeText(folder_ / "hashes.csv", text);
        return HashTrace::read(folder_ / "hashes.csv");
    }

    test::TemporaryFolder folder_;
};

StateHashes hashesOf(const std::string& state, const std::string& part) {
    StateHashes hashes{state, {}};
    hashes.parts.fill(part);
    return hashes;
}

TEST_F(HashTraceTest, ReadsWhatWasWritten) {
    const HashTrace trace = read(hashesHeader() + formatHashes(0, hashesOf(kA, kB)) +
                                 formatHashes(1, hashesOf(kB, kC)));
    ASSERT_EQ(trace.steps(), 2);
    EXPECT_EQ(trace.stateHash(0), kA);
    EXPECT_TRUE(trace.differingParts(1, hashesOf(kB, kC)).empty());
    StateHashes other = hashesOf(kA, kC);
    other.parts[static_cast<std::size_t>(StatePart::velocities)] = kA;
    EXPECT_EQ(trace.differingParts(1, other), std::vector<std::string>{"velocities"});
}

TEST_F(HashTraceTest, NamesWhatAFileDoesNotHoldWhereTheStateAloneDiffers) {
    const HashTrace trace =
        read("step,state_hash,topology_hash,positions_hash\n0," + kA + "," + kB + "," + kB + "\n");
    EXPECT_EQ(trace.differingParts(0, hashesOf(kC, kB)),
              std::vector<std::string>{"velocities or boxes"});
    EXPECT_TRUE(trace.differingParts(0, hashesOf(kA, kB)).empty());
}

TEST_F(HashTraceTest, NamesTheStateWhereAFileHoldsAllPartsAndTheyAgree) {
    const HashTrace trace = read(hashesHeader() + formatHashes(0, hashesOf(kA, kB)));
    EXPECT_EQ(trace.differingParts(0, hashesOf(kC, kB)), std::vector<std::string>{"the state"});
}

TEST_F(HashTraceTest, StepsComeInOrderAndHashesHaveSixteenDigits) {
    EXPECT_THROW(read(hashesHeader() + formatHashes(1, hashesOf(kA, kB))), InputError);
    EXPECT_THROW(read(hashesHeader() + formatHashes(0, hashesOf("abc", kB))), InputError);
    EXPECT_THROW(read("step,state_hash\n0," + kA + "\n"), InputError) << "no topology";
}

}  // namespace
}  // namespace kerf::app
