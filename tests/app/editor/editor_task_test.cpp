// A task that is made in the window of what was cut.

#include "app/session/task_run.h"

namespace kerf::app {
namespace {

class EditorTaskTest : public EditorTest {
  protected:
    const Vec2 kMiddle{kWidth / 2.0, kHeight / 2.0};

    void incise() {
        tap(Key::s);
        dragAndSettle(kMiddle - Vec2(90, 10), kMiddle + Vec2(90, 10), 40);
        ASSERT_FALSE(scene().simulation().strokes().empty());
    }
    void make() {
        tap(Key::p, {.control = true}, 2);
        type("make a task");
        confirm(2);
        settle();
    }
    EditorScene& scene() { return *editor->scene(); }
    const Task& task() { return *scene().document().session.task; }
    const ui::PracticeState& practice() { return panels().session.practice; }
    fs::path save() {
        saveByKeys();
        return folder / "ball-cut.kerf.json";
    }
};

TEST_F(EditorTaskTest, WithoutACutItSaysWhatToDo) {
    make();
    EXPECT_THAT(panels().toast.text, HasSubstr("Nothing was cut yet."));
    EXPECT_FALSE(scene().document().session.task);
}

TEST_F(EditorTaskTest, TheLineIsWhereTheBladeWent) {
    tap(Key::s);
    const double depth = panels().tools.scalpel.depth;
    incise();
    make();
    ASSERT_EQ(task().lines.size(), 1U);
    const std::vector<Vec3>& points = task().lines[0].points;
    EXPECT_GE(points.size(), 2U);
    for (const Vec3& point : points) {
        EXPECT_NEAR(point.norm(), 0.5, 0.02) << "on the skin";
    }
    EXPECT_LT(points.front().x(), -0.1);
    EXPECT_GT(points.back().x(), 0.1);
    EXPECT_FALSE(task().lines[0].closed);
    EXPECT_NEAR(*task().depth, depth, 0.2 * depth);
    EXPECT_LT(task().into.z(), -0.9);
    EXPECT_TRUE(scene().simulation().strokes().empty()) << "it begins anew";
    EXPECT_EQ(practice().name, "Incision");
    EXPECT_THAT(practice().about, HasSubstr("Cut along the line, "));
    undo();
    EXPECT_EQ(scene().simulation().strokes().size(), 1U) << "the cut is back";
    EXPECT_FALSE(scene().document().session.task);
}

TEST_F(EditorTaskTest, ABodyThatNothingPinsStaysBelowItsLine) {
    ASSERT_EQ(scene().execute(SetParam{"gravity", Vec3(0, -9.81, 0)}), "");
    incise();
    make();
    EXPECT_TRUE(scene().simulation().params().gravity.isZero(0));
    EXPECT_FALSE(scene().simulation().params().bladeFeels);
    EXPECT_THAT(panels().toast.text, HasSubstr("Nothing is pinned"));
    undo();
    ASSERT_EQ(scene().execute(Pin{Ball{{0, -0.5, 0}, 0.2}}), "");
    make();
    EXPECT_FALSE(scene().simulation().params().gravity.isZero(0)) << "it is pinned";
    EXPECT_TRUE(scene().simulation().params().bladeFeels);
}

TEST_F(EditorTaskTest, ACutThroughTheBodyHasNoDepthAndALoopIsClosed) {
    dragAndSettle(kMiddle - Vec2(0, 200), kMiddle + Vec2(0, 200), 60);
    tap(Key::s);
    moveTo(kMiddle + Vec2(60, 0), 1);
    make();
    EXPECT_FALSE(task().depth);
    EXPECT_EQ(practice().about, "Cut along the line, right through.");
    start(options());
    tap(Key::s);
    moveTo(kMiddle + Vec2(70, 0), 2);
    press(true, 1);
    for (int i = 0; i <= 60; ++i) {
        const double turn = 2 * M_PI * i / 60;
        moveTo(kMiddle + 70 * Vec2(std::cos(turn), std::sin(turn)), 1);
    }
    release();
    make();
    ASSERT_EQ(task().lines.size(), 1U);
    EXPECT_TRUE(task().lines[0].closed);
    EXPECT_GE(task().lines[0].points.size(), 6U);
}

TEST_F(EditorTaskTest, ATryThatPassesIsSavedAsTheExpertsAndTheTaskWithoutIt) {
    ASSERT_EQ(scene().execute(Pin{Ball{{0, -0.5, 0}, 0.2}}), "");
    incise();
    make();
    ASSERT_TRUE(practice().draft);
    incise();
    tap(Key::enter, {.shift = true}, 3);
    ASSERT_TRUE(practice().finished);
    EXPECT_THAT(practice().violations, IsEmpty());
    tap(Key::r, {}, 3);  // takes the score away, but not the try
    EXPECT_FALSE(practice().finished);
    const fs::path file = save();
    const Session saved = readSession(file);
    ASSERT_EQ(saved.events.size(), 1U) << "the pin";
    ASSERT_TRUE(saved.task);
    EXPECT_EQ(saved.task->person, "");
    ASSERT_TRUE(fs::exists(saved.task->expert));
    const auto score = runForScore(readSession(saved.task->expert));
    ASSERT_TRUE(score);
    EXPECT_THAT(score->violations, IsEmpty());
    EXPECT_NEAR(*score->economy, 1, 1e-6);
    const Json kept = Json::parse(readBytes(scoreFileOf(saved.task->expert)));
    EXPECT_EQ(kept["economy"], 1) << "as it is computed";
    start(options());
    open(file, 2);
    settle(2);
    EXPECT_TRUE(practice().hasExpert);
    EXPECT_FALSE(practice().draft) << "it is made";
    EXPECT_EQ(panels().tools.tool, ui::ToolKind::scalpel);
}

TEST_F(EditorTaskTest, WhatATeacherSetsIsSaved) {
    incise();
    make();
    click("task.through", 2);
    EXPECT_FALSE(task().depth);
    EXPECT_EQ(task().about, "Cut along the line, right through.") << "as nobody wrote another";
    click("task.through", 2);
    ASSERT_TRUE(task().depth);
    click("task.name");
    tap(Key::a, {.control = true}, 1);
    type("Slit", 2);
    EXPECT_EQ(task().name, "Slit");
    tap(Key::escape, 1);
    const Session saved = readSession(save());
    EXPECT_EQ(saved.task->name, task().name);
    EXPECT_EQ(saved.task->depth, task().depth);
    EXPECT_TRUE(saved.task->expert.empty()) << "no try passed";
}

}  // namespace
}  // namespace kerf::app
