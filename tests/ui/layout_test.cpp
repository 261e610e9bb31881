#include "ui/base/layout.h"

#include <gtest/gtest.h>

namespace kerf::ui {
namespace {

bool overlap(const Rect& a, const Rect& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
           b.y < a.y + a.height;
}

class LayoutTest : public ::testing::TestWithParam<std::array<float, 3>> {
  protected:
    float width() const { return GetParam()[0]; }
    float height() const { return GetParam()[1]; }
    Layout layout() const { return layoutPanels(width(), height(), GetParam()[2]); }
};

TEST_P(LayoutTest, PanelsDoNotOverlap) {
    const Layout l = layout();
    EXPECT_FALSE(overlap(l.controls, l.plots));
    EXPECT_FALSE(overlap(l.controls, l.status));
    EXPECT_FALSE(overlap(l.plots, l.status));
    EXPECT_FALSE(overlap(l.view, l.controls));
    EXPECT_FALSE(overlap(l.view, l.plots));
}

TEST_P(LayoutTest, TheFreeViewHasTheMiddleOfThePicture) {
    const Layout l = layout();
    EXPECT_NEAR(l.view.x + l.view.width / 2, width() / 2, 1e-3);
    EXPECT_GE(l.view.width, width() / 4);
}

TEST_P(LayoutTest, APanelThatIsPutAwayLeavesItsPlaceToTheView) {
    Settings settings;
    settings.showControls = false;
    const Layout l = layoutPanels(width(), height(), GetParam()[2], settings);
    EXPECT_EQ(l.controls.width, 0);
    EXPECT_GT(l.view.width, layout().view.width);
    EXPECT_FALSE(overlap(l.view, l.plots));
}

TEST_P(LayoutTest, WidthsFollowTheSettings) {
    Settings settings;
    settings.readingsWidth = 250;
    const Layout l = layoutPanels(width(), height(), GetParam()[2], settings);
    EXPECT_LE(l.plots.width, 250 * GetParam()[2]);
    EXPECT_GE(l.view.width, width() / 4);
}

TEST(LargestScale, LeavesThePanelsTheirRoom) {
    EXPECT_EQ(largestScale(1280, 720), 2);
    EXPECT_EQ(largestScale(1500, 720), 2);
    EXPECT_EQ(largestScale(1000, 2000), 1.5F);
    EXPECT_EQ(largestScale(1, 1), kLeastScale);
}

INSTANTIATE_TEST_SUITE_P(Sizes, LayoutTest,
                         ::testing::Values(std::array{1280.0F, 720.0F, 1.0F},
                                           std::array{2560.0F, 1440.0F, 2.0F},
                                           std::array{640.0F, 360.0F, 1.0F},
                                           std::array{800.0F, 600.0F, 2.0F}));

}  // namespace
}  // namespace kerf::ui
