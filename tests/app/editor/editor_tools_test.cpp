// The hand that pulls, the pins, the straight stroke.

#include "app/scene/readout/scene_readout.h"
#include "app/tools/box_placement.h"
#include "app/tools/stroke_tool.h"

namespace kerf::app {
namespace {

const Vec2 kMiddle(kWidth / 2.0, kHeight / 2.0);

class EditorToolsTest : public EditorTest {
  protected:
    void dragWith(const ui::Modifiers& modifiers, const Vec2& from, const Vec2& to, int points) {
        editor->post(ui::PointerMove{from.x(), from.y(), modifiers});
        editor->post(ui::ButtonChange{Button::left, true, modifiers});
        for (int i = 1; i <= points; ++i) {
            const Vec2 p = from + (to - from) * i / points;
            editor->post(ui::PointerMove{p.x(), p.y(), modifiers});
        }
        editor->post(ui::ButtonChange{Button::left, false, modifiers});
        settle();
    }
    /// Takes hold in the middle, pulls to the right and holds there for some pictures.
    void pull(int pictures) {
        moveTo(kMiddle);
        press(true, 2);
        moveTo(kMiddle.x() + 120, kMiddle.y());
        frames(pictures);
    }
    Session savedSession() {
        saveByKeys();
        return readSession(onlyFile(folder.path()));
    }
};

/// Pixels of the picture that are as bright and teal as the blade's edge and the outline of its
/// way.
int tealPixels(const render::Image& picture) {
    int count = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
        const int red = picture.pixels[i];
        const int green = picture.pixels[i + 1];
        count += green > 100 && green > red + 40 ? 1 : 0;
    }
    return count;
}

TEST_F(EditorToolsTest, ADragShowsItsBladeWithinTwoPictures) {
    moveTo(kTop);
    settle();
    press(true);
    settle();  // The hint goes, whose bar is teal too.
    const int before = tealPixels(editor->readPicture());
    moveTo(kTop.x() + 40, kTop.y() + 120, 2);
    EXPECT_GT(tealPixels(editor->readPicture()), before + 40);
}

TEST_F(EditorToolsTest, TheWheelChangesTheDepthOfAScalpelThatCuts) {
    tap(Key::s);
    moveTo(kMiddle - Vec2(60, 0), 1);
    const double before = panels().tools.scalpel.depth;
    press(true, 1);
    moveTo(kMiddle, 2);
    editor->post(ui::Wheel{0, -2});
    frames(2);
    const double depth = panels().tools.scalpel.depth;
    EXPECT_LT(depth, before);
    EXPECT_GT(depth, 0);
    ASSERT_EQ(panels().view.overlay.labels.size(), 1U);
    EXPECT_EQ(panels().view.overlay.labels[0].text, millimetreText(depth));
    release();
    EXPECT_TRUE(panels().view.overlay.labels.empty());
    editor->post(ui::Wheel{0, -2});
    frames(2);
    EXPECT_EQ(panels().tools.scalpel.depth, depth) << "now it zooms";
}

TEST_F(EditorToolsTest, DotsTellHowFarTheCutLagsBehindThePointer) {
    moveTo(kTop);
    press(true);
    settle();
    moveTo(kTop.x(), kBottom.y(), 2);
    const std::vector<ui::PlotPoint> lag = panels().view.overlay.lag;
    ASSERT_GE(lag.size(), 2U);
    EXPECT_NEAR(lag.back().y, kBottom.y(), 1) << "up to the pointer";
    EXPECT_LT(lag.front().y, kBottom.y() - 50);
    EXPECT_TRUE(panels().view.overlay.touched.empty()) << "on request alone";
    settle(1);
    EXPECT_NEAR(panels().view.overlay.lag.front().y, kBottom.y(), 10) << "it has caught up";
}

TEST_F(EditorToolsTest, AStrokeBesideTheBodyLeavesNoMark) {
    dragAndSettle(Vec2(kWidth / 3.0, 20), Vec2(kWidth / 3.0, kHeight - 60), 10);
    EXPECT_GT(panels().transport.step, 0);
    EXPECT_EQ(panels().body.triangles, 768);
    EXPECT_TRUE(panels().session.past.empty());
    dragAndSettle(kTop, kBottom, 20);
    ASSERT_EQ(panels().session.past.size(), 1U);
    EXPECT_GT(panels().session.past[0].step, 0);
}

TEST_F(EditorToolsTest, AStrokeIsTheSameHoweverSlowThePicturesAre) {
    const auto run = [&](int eventsPerPicture) {
        tap(Key::r);
        moveTo(kTop);
        press(true);
        for (int i = 1; i <= 40; ++i) {
            // A curved way, so that a pose that is lost changes the cut.
            const double t = i / 40.0;
            moveTo(kTop.x() + 60 * std::sin(3 * t), kTop.y() + t * (kBottom.y() - kTop.y()));
            if (i % eventsPerPicture == 0) {
                editor->frame(1.0 / 3);
            }
        }
        release();
        moveTo(kWidth / 2.0, 5);
        settle();
        return std::pair(panels().body.triangles, viewPixels(editor->readPicture()));
    };
    const auto fast = run(1);
    EXPECT_EQ(panels().pieces.rows.size(), 2U);
    EXPECT_EQ(run(7), fast);
    EXPECT_EQ(run(41), fast);
}

TEST_F(EditorToolsTest, AHandPullsTheBodyWhileItHoldsIt) {
    tap(Key::d, 1);
    moveTo(kMiddle, 2);
    EXPECT_FALSE(panels().view.overlay.guides.empty()) << "a ring shows what it would take";
    pull(20);
    EXPECT_GE(panels().transport.step, 20) << "time runs while it holds";
    ASSERT_EQ(panels().view.overlay.handles.size(), 1U);
    EXPECT_NEAR(panels().view.overlay.handles[0].at.x, kMiddle.x() + 120, 0.5);
    release();
    const int step = panels().transport.step;
    frames(5);
    EXPECT_EQ(panels().transport.step, step) << "and stands when it lets go";
    ASSERT_EQ(panels().changes.rows.size(), 1U);
    EXPECT_EQ(panels().changes.rows[0].name, "Pull");
}

TEST_F(EditorToolsTest, APressBesideTheBodySaysSo) {
    for (const Key tool : {Key::d, Key::y, Key::m}) {
        start(options());  // without a toast
        tap(tool, 1);
        drag({kWidth / 2.0, 40}, {kWidth / 2.0, 60}, 2);
        frames(1);
        EXPECT_EQ(panels().toast.text, "Nothing is there. Press on the model.") << int(tool);
    }
}

TEST_F(EditorToolsTest, APullIsRecordedAndReplaysToTheSameBits) {
    tap(Key::d);
    pull(12);
    moveTo(kMiddle.x() + 140, kMiddle.y() + 30, 3);
    release();
    expectReplayed(savedSession(), sphereDocument().mesh);
}

TEST_F(EditorToolsTest, UndoWhileItHoldsTakesThePullBackAndLetsGo) {
    tap(Key::d);
    pull(10);
    editor->post(ui::KeyChange{Key::z, true, {.control = true}});
    frames(2);
    EXPECT_EQ(panels().changes.done, 0U);
    EXPECT_TRUE(panels().view.overlay.handles.empty()) << "it holds nothing any more";
    release();
    expectReplayed(savedSession(), sphereDocument().mesh);
}

TEST_F(EditorToolsTest, TheSurfaceIsSearchedOnceForEachQuestion) {
    tap(Key::s);
    moveTo(kMiddle);
    settle();
    const auto searches = [this] { return editor->scene()->readout().look().searches(); };
    const int before = searches();
    EXPECT_GT(before, 0);
    frames(5);
    EXPECT_EQ(searches(), before) << "nothing has changed";
    for (int i = 1; i <= 10; ++i) {
        moveTo(kMiddle.x() + i, kMiddle.y());
    }
    frames(1);
    EXPECT_LE(searches(), before + 1) << "one picture, however many moves";
    settle();
    EXPECT_EQ(searches(), before + 1);
    tap(Key::period);
    settle();
    EXPECT_EQ(searches(), before + 2) << "a step moves the body";
    moveTo(kWidth / 2.0, 3);
    settle();
    EXPECT_EQ(searches(), before + 2) << "the pointer is beside the body";
}

TEST_F(EditorToolsTest, TheBrushPinsInOneChangeAndTheControlKeyFrees) {
    tap(Key::p);
    dragWith({}, kMiddle - Vec2(60, 0), kMiddle + Vec2(60, 0), 6);
    const std::size_t pinned = panels().body.pinned;
    EXPECT_GT(pinned, 10U);
    ASSERT_EQ(panels().changes.rows.size(), 1U);
    EXPECT_EQ(panels().changes.rows[0].name, "Pin");
    dragWith({.control = true}, kMiddle, kMiddle + Vec2(1, 0), 1);
    EXPECT_LT(panels().body.pinned, pinned);
    undo();
    EXPECT_EQ(panels().body.pinned, pinned);
    editor->post(ui::KeyChange{Key::p, true, {.shift = true}});
    settle();
    EXPECT_EQ(panels().body.pinned, 0U);
}

TEST_F(EditorToolsTest, ABoxPinsThroughTheWholeBody) {
    tap(Key::digit1);
    tap(Key::digit5);
    settle();
    tap(Key::p);
    const ui::Rect view = ui::layoutPanels(kWidth, kHeight, 1, {}, true).view;
    const Vec2 middle(kMiddle.x(), view.y + view.height / 2);
    dragWith({.shift = true}, middle, middle + Vec2(300, -200), 4);
    // A quarter of the sphere, front and back.
    EXPECT_GT(panels().body.pinned, 386U / 5);
    EXPECT_LT(panels().body.pinned, 386U / 3);
}

TEST_F(EditorToolsTest, PinsForcesAndMotionsAreRecordedAndReplayToTheSameBits) {
    tap(Key::p, 2);
    dragWith({}, kMiddle - Vec2(10, 60), kMiddle + Vec2(10, -60), 4);
    click("pin.Push");
    dragWith({}, kMiddle - Vec2(60, 0), kMiddle - Vec2(20, 0), 4);
    click("pin.Move");
    ASSERT_EQ(panels().tools.pin.kind, ui::PinKind::move);
    dragWith({}, kMiddle + Vec2(20, 0), kMiddle + Vec2(60, 0), 4);
    ASSERT_EQ(panels().changes.rows.size(), 3U);
    EXPECT_EQ(panels().changes.rows[1].name, "Force: (0, 1, 0) N");
    EXPECT_EQ(panels().changes.rows[2].name, "Move: (0, 0.1, 0) m/s");
    tap(Key::v);
    playFor(10);
    expectReplayed(savedSession(), sphereDocument().mesh);
}

// A session with less than a microsecond could not be read again.
TEST_F(EditorToolsTest, TheShortestMotionIsReadAgain) {
    editor->resize(kWidth, 2 * kHeight);
    tap(Key::p, 2);
    click("pin.Move");
    click("pin.seconds.number");
    type("1e-9");
    tap(Key::enter);
    ASSERT_EQ(panels().tools.pin.seconds, 1e-9);
    dragWith({}, Vec2(kWidth / 2.0, kHeight), Vec2(kWidth / 2.0 + 60, kHeight), 4);
    ASSERT_EQ(panels().changes.rows.size(), 1U);
    tap(Key::period);
    expectReplayed(savedSession(), sphereDocument().mesh);
}

TEST_F(EditorToolsTest, ALengthIsTypedWithItsUnit) {
    click("blade.through");
    for (const auto& [text, depth] : {std::pair("60 mm", 0.06), {"30 cm", 0.3}, {"2 kPa", 0.3}}) {
        click("blade.Depth.number");
        type(text);
        tap(Key::enter, 2);
        EXPECT_DOUBLE_EQ(panels().tools.stroke.depth, depth) << text;
    }
    EXPECT_TRUE(editor->itemRects().contains("refused.Type a length, such as 5 mm"));
    EXPECT_EQ(panels().tools.tool, ui::ToolKind::stroke) << "letters are no keys meanwhile";
}

TEST_F(EditorToolsTest, AStrokeWithShiftHeldIsStraight) {
    const ui::Modifiers shift{.shift = true};
    editor->post(ui::PointerMove{kTop.x(), kTop.y(), shift});
    editor->post(ui::ButtonChange{Button::left, true, shift});
    for (int i = 1; i <= 20; ++i) {
        const double y = kTop.y() + i * (kBottom.y() - kTop.y()) / 20;
        editor->post(ui::PointerMove{kTop.x() + (i % 2 == 0 ? 14.0 : -14.0) * (i > 1), y, shift});
    }
    frames(1);
    const auto& swept = panels().view.overlay.swept;
    editor->post(ui::ButtonChange{Button::left, false, shift});
    frames(1);
    for (const ui::Overlay::Line& line : swept) {
        EXPECT_NEAR(line[0].x, kTop.x(), 1);
        EXPECT_NEAR(line[1].x, kTop.x(), 1);
    }
    settle();
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
}

TEST(Ruler, TakesTheNearestOfTwentyFourDirectionsAndKeepsIt) {
    Ruler ruler(Vec2(100, 100));
    EXPECT_EQ(ruler.along(Vec2(105, 103)), std::nullopt) << "too near to tell";
    EXPECT_LT((*ruler.along(Vec2(150, 104)) - Vec2(150, 100)).norm(), 1e-9);
    EXPECT_LT((*ruler.along(Vec2(160, 190)) - Vec2(160, 100)).norm(), 1e-9) << "it stays";
    Ruler slanted(Vec2(0, 0));
    const Vec2 on = *slanted.along(Vec2(100, 60));
    EXPECT_NEAR(std::atan2(on.y(), on.x()), std::numbers::pi / 6, 1e-12);
}

TEST(BoxBetween, IsTheRectangleOfAStraightOrthographicView) {
    ViewFrame view;
    view.width = 800;
    view.height = 400;
    view.camera.eye = Vec3(0, 0, 5);
    view.camera.orthographic = true;
    Bounds body{Vec3(-1, -1, -0.5), Vec3(1, 1, 0.7)};
    const Bounds box = boxBetween(view, Vec2(400, 200), Vec2(500, 100), body);
    const double perPixel = 2 * 5 * std::tan(17.5 * std::numbers::pi / 180) / 400;
    EXPECT_LT((box.low.head<2>() - Vec2(0, 0)).norm(), 1e-9);
    EXPECT_LT((box.high.head<2>() - 100 * perPixel * Vec2(1, 1)).norm(), 1e-9);
    EXPECT_LT(box.low.z(), -0.5);
    EXPECT_GT(box.high.z(), 0.7);
}

}  // namespace
}  // namespace kerf::app
