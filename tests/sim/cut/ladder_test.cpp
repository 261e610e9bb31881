#include "sim/cut/ladder.h"

#include <gtest/gtest.h>

namespace kerf::cut {
namespace {

TEST(Ladder, LeavesABridgeOnlyAtTheLastChance) {
    ASSERT_GT(attemptCount(false), 0);
    ASSERT_GT(attemptCount(true), attemptCount(false));
    for (int i = 0; i < attemptCount(true); ++i) {
        EXPECT_EQ(attemptAt(i, 1e-5, 1).allowStub, i >= attemptCount(false)) << i;
    }
}

}  // namespace
}  // namespace kerf::cut
