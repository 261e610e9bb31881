// The camera, the axes in the corner, what is shown and how.
#include "app/session.h"
#include "tests/app/editor_fixture.h"

namespace kerf::app {
namespace {

class EditorViewTest : public EditorTest {
  protected:
    /// A click in the middle of a named item.
    void click(const std::string& item) {
        const ui::Rect place = editor->places().at(item);
        const Vec2 at(place.x + place.width / 2, place.y + place.height / 2);
        drag(at, at, 1);
        settle();
    }
    Vec3 axis(int i) const { return panels().axes.axes[i]; }
};

TEST_F(EditorViewTest, WithoutPerspectiveAStrokeStillCutsTheSphereInTwo) {
    tap(Key::digit5);
    settle();
    EXPECT_TRUE(panels().orthographic);
    drag(kTop, kBottom, 30);
    settle();
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
}

TEST_F(EditorViewTest, WithoutPerspectiveTheScalpelFindsTheSurface) {
    tap(Key::digit5);
    tap(Key::s);
    drag(Vec2(kWidth / 2.0 - 60, kHeight / 2.0), Vec2(kWidth / 2.0 + 60, kHeight / 2.0), 12);
    settle();
    EXPECT_GT(panels().triangles, 768);
    EXPECT_EQ(panels().changes.rows.size(), 1U);
}

TEST_F(EditorViewTest, WithoutPerspectiveAGuillotineHandleFollowsThePointer) {
    tap(Key::digit5);
    tap(Key::g);
    moveTo(kWidth / 2.0, kHeight / 2.0);
    frames(2);
    ASSERT_EQ(panels().overlay.handles.size(), 4U);
    const ui::PlotPoint before = panels().overlay.handles[0].at;
    drag(Vec2(before.x, before.y), Vec2(before.x + 40, before.y + 30), 3);
    frames(2);
    EXPECT_NEAR(panels().overlay.handles[0].at.x, before.x + 40, 0.5);
    EXPECT_NEAR(panels().overlay.handles[0].at.y, before.y + 30, 0.5);
}

TEST_F(EditorViewTest, TheKeysOfTheAxesLookAlongThem) {
    tap(Key::digit3);
    settle();
    EXPECT_NEAR(axis(0).z(), 1, 1e-3) << "x comes towards the eye";
    tap(Key::digit7);
    settle();
    EXPECT_NEAR(axis(1).z(), 1, 1e-3);
    EXPECT_NEAR(axis(0).x(), 1, 1e-3);
    tap(Key::digit1);
    settle();
    EXPECT_NEAR(axis(2).z(), 1, 1e-3);
}

TEST_F(EditorViewTest, AClickOnAnEndOfTheAxesLooksFromThere) {
    settle();
    click("axes.-X");
    EXPECT_NEAR(axis(0).z(), -1, 1e-3);
    EXPECT_EQ(panels().step, 0) << "and cuts nothing";
}

TEST_F(EditorViewTest, AViewFromAboveIsSavedAndReadAgain) {
    tap(Key::digit7);
    tap(Key::digit5);
    saveByKeys();
    const Session session = readSession(onlyFile(folder.path()));
    EXPECT_TRUE(session.view->orthographic);
    EXPECT_NEAR(session.view->towardsEye(Vec3::Zero()).y(), 1, 1e-3);
}

TEST_F(EditorViewTest, AStrokeThatBeginsWhileTheViewFliesIsMadeInTheViewAtItsEnd) {
    tap(Key::digit3);
    frames(2);
    ASSERT_EQ(editor->idleSeconds(), 0) << "it still flies";
    moveTo(kTop.x(), kTop.y());
    press(true);
    frames(2);
    EXPECT_NEAR(axis(0).z(), 1, 1e-3);
}

}  // namespace
}  // namespace kerf::app
