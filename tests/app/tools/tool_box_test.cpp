// The tools of the left button, as far as they need no body.
#include "app/tools/tool_box.h"

#include <gtest/gtest.h>

#include "app/scene/editor_stroke.h"

namespace kerf::app {
namespace {

class ToolBoxTest : public ::testing::Test {
  protected:
    ToolBoxTest() {
        bounds.add(Vec3(-0.5, 0, -0.5));
        bounds.add(Vec3(0.5, 1, 0.5));
        tools.begin(bounds);
    }

    ToolContext at(const Vec2& pixel) {
        const ViewFrame view{{.eye = {0, 0.5, 3}, .target = {0, 0.5, 0}}, 400, 300};
        return {view, pixel, {}, tools.settings(), stroke, bounds, section, nullptr};
    }
    void take(ui::Tool tool) {
        ui::ToolSettings wanted = tools.settings();
        wanted.tool = tool;
        tools.set(wanted, at({0, 0}));
    }

    Bounds bounds;
    BladeStroke stroke;
    std::optional<render::SectionPlane> section;
    ToolBox tools;
};

TEST_F(ToolBoxTest, AnotherToolEndsAStrokeThatIsHeld) {
    tools.inHand().press(at({50, 150}));
    tools.inHand().move(at({200, 150}));
    EXPECT_TRUE(tools.inHand().holds());
    EXPECT_FALSE(tools.holdsBody()) << "a blade is put away at once";
    EXPECT_TRUE(stroke.drawing());
    take(ui::Tool::guillotine);
    EXPECT_FALSE(stroke.drawing());
    take(ui::Tool::stroke);
    EXPECT_FALSE(tools.inHand().holds());
}

TEST_F(ToolBoxTest, TheGuillotineComesDownAndIsAboveTheBodyOnceItIsPutAway) {
    take(ui::Tool::guillotine);
    tools.inHand().trigger(at({0, 0}));
    EXPECT_EQ(tools.settings().guillotine.lowered, 1);
    EXPECT_GT(stroke.pending(), 0u);
    take(ui::Tool::stroke);
    EXPECT_EQ(tools.settings().guillotine.lowered, 0);
    EXPECT_EQ(stroke.pending(), 0u);
}

TEST_F(ToolBoxTest, TheGuillotineKeepsItsPoseWhileAnotherToolIsUsed) {
    take(ui::Tool::guillotine);
    ui::ToolSettings wanted = tools.settings();
    wanted.guillotine.length = 0.3;
    tools.set(wanted, at({0, 0}));
    const std::vector<Blade> way = tools.inHand().wayAhead(at({0, 0}));
    EXPECT_NEAR((way.front().b - way.front().a).norm(), 0.3, 1e-12);
    take(ui::Tool::stroke);
    take(ui::Tool::guillotine);
    EXPECT_EQ(tools.inHand().wayAhead(at({0, 0})).front().b, way.front().b);
}

TEST_F(ToolBoxTest, AnotherDocumentFitsTheSettingsAndLeavesTheToolInHand) {
    take(ui::Tool::pin);
    Bounds larger;
    larger.add(Vec3::Zero());
    larger.add(Vec3(30, 40, 0));
    tools.begin(larger);
    EXPECT_EQ(tools.settings().tool, ui::Tool::pin);
    EXPECT_DOUBLE_EQ(tools.settings().longest, 100);
    EXPECT_DOUBLE_EQ(tools.settings().pin.radius, 4);
}

}  // namespace
}  // namespace kerf::app
