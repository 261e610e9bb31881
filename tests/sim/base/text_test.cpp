#include "sim/base/text.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(Text, CountsWithTheRightNoun) {
    EXPECT_EQ(counted(0, "piece", "pieces"), "0 pieces");
    EXPECT_EQ(counted(1, "piece", "pieces"), "1 piece");
    EXPECT_EQ(counted(2u, "piece", "pieces"), "2 pieces");
}

TEST(Text, JoinsWithSeparatorsBetweenOnly) {
    EXPECT_EQ(joined(std::vector<std::string>{}, ", "), "");
    EXPECT_EQ(joined(std::vector<std::string>{"a"}, ", "), "a");
    EXPECT_EQ(joined(std::vector<std::string>{"a", "b", "c"}, "; "), "a; b; c");
}

}  // namespace
}  // namespace kerf
