#include <gtest/gtest.h>

#include "app/window/window.h"

namespace kerf::app {
namespace {

TEST(WindowIcon, IsADiscOnNothingWithABladeThroughIt) {
    const render::Image icon = windowIcon();
    ASSERT_EQ(icon.width, 64);
    ASSERT_EQ(icon.height, 64);
    const auto at = [&](int x, int y) { return &icon.pixels[4 * (y * 64 + x)]; };
    for (const int corner : {0, 63}) {
        EXPECT_EQ(at(corner, corner)[3], 0);
    }
    EXPECT_GT(at(20, 20)[0], 200) << "the fruit";
    EXPECT_EQ(at(20, 20)[3], 255);
    EXPECT_EQ(at(20, 20)[2], 66) << "which is orange";
    EXPECT_LT(at(14, 14)[1], at(20, 20)[1]) << "its skin is darker";
    EXPECT_GT(at(32, 32)[1], at(32, 32)[0]) << "the blade";
}

}  // namespace
}  // namespace kerf::app
