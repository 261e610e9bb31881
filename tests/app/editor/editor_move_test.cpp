// The gizmo on boxes, on pins, on the model and on the guillotine.
#include "app/tools/view_frame.h"

namespace kerf::app {
namespace {

const Vec2 kMiddle(kWidth / 2.0, kHeight / 2.0);

class EditorMoveTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        tap(Key::tab);  // No panel lies over the boxes.
        settle();
    }
    EditorScene& scene() { return *editor->scene(); }
    const StaticBox& box(int index) { return scene().simulation().boxes().at(index); }
    void addBox(const Vec3& center) {
        ASSERT_EQ(scene().execute(AddBox{{center, Vec3::Constant(0.3), Vec3::Zero()}}), "");
    }
    void takeTool() {
        tap(Key::u);
        moveTo(5, kHeight - 5, 2);
    }
    Vec2 dotOf(int axis, bool square) {
        for (const ui::Overlay::AxisDot& dot : panels().view.overlay.axisDots) {
            if (dot.axis == axis && dot.square == square) {
                return {dot.at.x, dot.at.y};
            }
        }
        ADD_FAILURE() << "no such dot";
        return kMiddle;
    }
    /// Pixel of the tip of an arrow.
    Vec2 tip(int axis) { return dotOf(axis, false); }
    Vec2 square(int axis) { return dotOf(axis, true); }
    /// Some pixel of a ring that no arrow is near.
    Vec2 ring(int axis) {
        const auto& lines = panels().view.overlay.axisLines;
        std::vector<Vec2> points;
        for (const ui::Overlay::AxisLine& line : lines) {
            if (line.axis == axis) {
                points.emplace_back(line.line[0].x, line.line[0].y);
            }
        }
        return points.at(6);  // of 48 in one quarter
    }
    void dragSlowly(const Vec2& from, const Vec2& way) {
        moveTo(from);
        press(true);
        for (int i = 1; i <= 5; ++i) {
            moveTo(from.x() + way.x() * i / 5, from.y() + way.y() * i / 5, 1);
        }
        frames(1);  // What is drawn over the scene is that of before the last input.
    }
};

TEST_F(EditorMoveTest, AnArrowMovesABoxAndOneUndoTakesTheDragBack) {
    addBox(Vec3(0.9, -0.3, 0));
    takeTool();
    const std::size_t changes = panels().changes.done;
    dragSlowly(tip(0), Vec2(40, 0));
    EXPECT_EQ(editor->cursor(), ui::Cursor::hand);
    ASSERT_EQ(panels().view.overlay.labels.size(), 1U) << "the number is shown";
    release();
    EXPECT_GT(box(0).center.x(), 0.95);
    EXPECT_EQ(box(0).center.y(), -0.3);
    EXPECT_EQ(panels().changes.done, changes + 1) << "one drag is one change";
    undo();
    EXPECT_EQ(box(0).center.x(), 0.9);
}

TEST_F(EditorMoveTest, SquaresSizeABoxAndRingsTurnIt) {
    addBox(Vec3(0.9, -0.3, 0));
    takeTool();
    dragSlowly(square(1), Vec2(0, -30));
    release();
    EXPECT_GT(box(0).size.y(), 0.33);
    EXPECT_EQ(box(0).size.x(), 0.3);
    EXPECT_NEAR(box(0).center.y() - box(0).size.y() / 2, -0.45, 1e-9) << "its underside stays";
    dragSlowly(ring(2), Vec2(-30, 20));
    release();
    EXPECT_GT(box(0).rotate.norm(), 3);
}

TEST_F(EditorMoveTest, ControlSnapsToRoundSteps) {
    addBox(Vec3(0.9, -0.3, 0));
    takeTool();
    const Vec2 from = tip(0);
    moveTo(from);
    press(true);
    editor->post(ui::PointerMove{from.x() + 33, from.y(), {.control = true}});
    release();
    const double by = box(0).center.x() - 0.9;
    EXPECT_GT(by, 0);
    EXPECT_NEAR(by / 0.05, std::round(by / 0.05), 1e-6) << by;
}

TEST_F(EditorMoveTest, EscTakesTheDragBack) {
    addBox(Vec3(0.9, -0.3, 0));
    takeTool();
    dragSlowly(tip(1), Vec2(0, -40));
    EXPECT_GT(box(0).center.y(), -0.28);
    tap(Key::escape);
    release();
    EXPECT_EQ(box(0).center.y(), -0.3);
}

TEST_F(EditorMoveTest, AClickChoosesAnotherBoxOrTheModel) {
    addBox(Vec3(-0.9, -0.3, 0));
    addBox(Vec3(0.9, -0.3, 0));
    takeTool();
    EXPECT_GT(tip(1).x(), kMiddle.x()) << "the last box";
    const Vec2 other(kMiddle.x() - (tip(1).x() - kMiddle.x()), kMiddle.y() + 60);
    moveTo(other, 2);
    EXPECT_EQ(editor->cursor(), ui::Cursor::hand) << "a click would choose it";
    press(true);
    press(false, 2);
    EXPECT_LT(tip(1).x(), kMiddle.x());
    moveTo(kMiddle);
    press(true);
    press(false, 2);
    EXPECT_NEAR(tip(1).x(), kMiddle.x(), 40) << "the model";
}

TEST_F(EditorMoveTest, TheModelIsMovedTurnedAndScaledAboutItsMiddle) {
    takeTool();
    dragSlowly(tip(0), Vec2(40, 0));
    release();
    const Placement moved = scene().simulation().placement();
    EXPECT_GT(moved.translate.x(), 0.05);
    EXPECT_NEAR(scene().rest().bounds().center().x(), moved.translate.x(), 0.01);
    EXPECT_EQ(moved.scale, 1);
    frames(2);
    const ui::Overlay::AxisDot* corner = nullptr;
    for (const ui::Overlay::AxisDot& dot : panels().view.overlay.axisDots) {
        corner = dot.axis < 0 ? &dot : corner;
    }
    ASSERT_NE(corner, nullptr);
    const Vec3 middle = scene().rest().bounds().center();
    dragSlowly(Vec2(corner->at.x, corner->at.y), Vec2(30, -30));
    release();
    EXPECT_GT(scene().simulation().placement().scale, 1.1);
    EXPECT_LT((scene().rest().bounds().center() - middle).norm(), 1e-3) << "about its middle";
    undo();
    undo();
    EXPECT_EQ(scene().simulation().placement(), Placement{});
}

TEST_F(EditorMoveTest, ACutModelStaysAndSaysWhy) {
    dragAndSettle(kTop, kBottom, 8);
    takeTool();
    EXPECT_TRUE(panels().view.overlay.axisDots.empty());
    moveTo(kMiddle.x() + 40, kMiddle.y());
    press(true);
    release();
    EXPECT_THAT(panels().toast.text, HasSubstr("A cut model can't be moved"));
}

TEST_F(EditorMoveTest, WhatIsPinnedIsMovedAndReplaysToTheSameBits) {
    ASSERT_EQ(scene().execute(Pin{Ball{Vec3(0, 0.5, 0), 0.25}, true}), "");
    takeTool();
    const std::vector<std::uint32_t> pinned = scene().simulation().pinnedVertices();
    const Vec3 before = scene().simulation().mesh().position(int(pinned[0]));
    const std::size_t changes = panels().changes.done;
    dragSlowly(tip(0), Vec2(30, 0));
    release();
    const Vec3 after = scene().simulation().mesh().position(int(pinned[0]));
    EXPECT_GT(after.x(), before.x() + 0.05);
    EXPECT_NEAR(after.y(), before.y(), 1e-6);
    EXPECT_EQ(panels().changes.done, changes + 1);
    EXPECT_EQ(panels().changes.rows.back().name, "Move pins");
    EXPECT_GT(panels().transport.step, 5) << "time runs, so that the body follows";
    EXPECT_GT(scene().simulation().bounds().center().x(), 0.02);
    dragSlowly(ring(1), Vec2(20, 10));
    release();
    saveByKeys();
    expectReplayed(readSession(onlyFile(folder.path())), sphereDocument().mesh);
}

TEST_F(EditorMoveTest, TheGuillotineHasTheSameGizmo) {
    tap(Key::g);
    moveTo(5, kHeight - 5, 2);
    ASSERT_EQ(panels().view.overlay.handles.size(), 4U);
    EXPECT_EQ(panels().view.overlay.axisDots.size(), 3U);
    const auto middle = [this] { return panels().view.overlay.handles[0].at; };
    const ui::PlotPoint before = middle();
    const Vec2 up = tip(1);
    dragSlowly(up, Vec2(0, 30));
    const ui::PlotPoint held = middle();
    EXPECT_NEAR(held.y, before.y + 30, 3);
    EXPECT_NEAR(held.x, before.x, 3);
    tap(Key::escape);
    press(false, 2);
    EXPECT_NEAR(middle().y, before.y, 0.5) << "Esc brings it back";
    EXPECT_EQ(panels().transport.step, 0) << "posing cuts nothing";
}

}  // namespace
}  // namespace kerf::app
