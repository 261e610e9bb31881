#include "app/window/monitor.h"

#include "app/window/window.h"

namespace kerf::app {
namespace {

TEST(MonitorScale, FollowsThePhysicalSize) {
    EXPECT_EQ(scaleOf(1920, 1080, 527, 296), 1) << "24 inches";
    EXPECT_EQ(scaleOf(2560, 1440, 597, 336), 1) << "27 inches: still a plain one";
    EXPECT_EQ(scaleOf(3840, 2160, 597, 336), 1.5F);
    EXPECT_EQ(scaleOf(3840, 2160, 508, 286), 2);
    EXPECT_EQ(scaleOf(3840, 2160, 344, 194), 2.75F) << "a laptop";
    EXPECT_EQ(scaleOf(3840, 2160, 1210, 680), 1) << "a television";
}

TEST(MonitorScale, IgnoresNonsense) {
    EXPECT_EQ(scaleOf(3840, 2160, 160, 90), 1) << "the ratio of the sides";
    EXPECT_EQ(scaleOf(3840, 2160, 16, 9), 1);
    EXPECT_EQ(scaleOf(3840, 2160, 0, 0), 1);
    EXPECT_EQ(scaleOf(1920, 1080, 40, 30), 1);
    EXPECT_EQ(scaleOf(1920, 1080, 9000, 5000), 1) << "a projector";
}

TEST(WindowPlace, CountsOnlyWhereAMonitorIs) {
    const std::array<Monitor, 2> two{{{0, 0, 1920, 1080}, {1920, 0, 1280, 1024}}};
    EXPECT_EQ(monitorOf({100, 50, 800, 600}, two), two.data());
    EXPECT_EQ(monitorOf({2500, 500, 800, 900}, two), &two[1]) << "its lower part is outside";
    EXPECT_EQ(monitorOf({3300, 50, 800, 600}, two), nullptr);
    EXPECT_EQ(monitorOf({100, -200, 800, 600}, two), nullptr) << "its title can't be reached";
    EXPECT_EQ(monitorOf({100, 50, 800, 600}, {}), nullptr);
    EXPECT_EQ(monitorOf({}, two), nullptr) << "unknown";
    EXPECT_EQ(monitorOf({100, 50, 800, 0}, two), nullptr) << "no window is that low";
}

TEST(WindowPlace, IsMovedOntoItsMonitor) {
    const Monitor monitor{1920, 0, 1280, 1024};
    EXPECT_EQ(fitted({2000, 50, 800, 600}, monitor), (ui::WindowPlace{2000, 50, 800, 600}));
    EXPECT_EQ(fitted({3000, 900, 800, 600}, monitor), (ui::WindowPlace{2400, 424, 800, 600}));
    EXPECT_EQ(fitted({1700, 300, 1920, 1080, true}, monitor),
              (ui::WindowPlace{1920, 0, 1280, 1024, true}));
}

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
