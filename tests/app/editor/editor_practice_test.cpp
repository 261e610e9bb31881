// A task in the window: shown, cut, scored and kept.

#include "app/session/task_run.h"
#include "ui/state/action_table.h"

namespace kerf::app {
namespace {

class EditorPractice : public EditorTest {
  protected:
    EditorOptions options() override {
        EditorOptions options = EditorTest::options();
        options.tries = folder / "tries";
        return options;
    }
    void SetUp() override {
        EditorTest::SetUp();
        Session session = sphereDocument().session;
        session.params.bladeFeels = true;
        session.params.floor.reset();
        session.steps = 1;
        session.view = sphereDocument().camera;
        Task task;
        task.name = "Halve it";
        task.about = "From top to bottom.";
        task.lines = {{{Vec3(0.02, 0.49, 0.1), Vec3(-0.02, 0.49, -0.1)}}};
        task.reach = 0.2;
        task.spareRegions = {Ball{Vec3(0.4, 0, 0), 0.05}};
        task.limits.deviation = 0.1;
        session.task = task;
        writeText(folder / "halves.kerf.json", formatSession(session));
        start(options(), openDocument(folder / "halves.kerf.json"));
    }
    /// Down through the ball, `aside` pixels beside its middle.
    void cutDown(double aside) {
        const ui::Rect view = ui::layoutPanels(float(kWidth), float(kHeight), 1, {}, true).view;
        const Vec2 middle(view.x + view.width / 2 + aside, view.y + view.height / 2);
        dragAndSettle(middle - Vec2(0, 200), middle + Vec2(0, 200), 60);
    }
    const ui::PracticeState& practice() { return panels().session.practice; }
    std::string figure(const std::string& label) {
        for (const ui::ScoreRow& row : practice().rows) {
            if (row.figure.starts_with(label)) return row.now;
        }
        return "no such figure";
    }
    std::vector<fs::path> keptTries() {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(folder / "tries")) {
            if (entry.path().string().ends_with(kSessionEnding)) files.push_back(entry.path());
        }
        return files;
    }
};

TEST_F(EditorPractice, TheTaskIsShownAndNothingIsScoredBeforeACut) {
    EXPECT_EQ(practice().name, "Halve it");
    EXPECT_TRUE(editor->itemRects().contains("practice.finish"));
    EXPECT_FALSE(panels().view.overlay.traces.empty());
    tap(Key::enter, {.shift = true}, 3);
    EXPECT_FALSE(practice().finished);
    EXPECT_THAT(panels().toast.text, HasSubstr("Nothing was cut yet"));
}

TEST_F(EditorPractice, ATryIsScoredKeptAndReplayedToTheSameScore) {
    cutDown(0);
    click("practice.finish", 3);
    ASSERT_TRUE(practice().finished);
    EXPECT_NE(figure("Largest deviation"), "");
    EXPECT_NE(figure("Largest force"), "");
    EXPECT_NE(figure("Time"), "");
    const auto files = keptTries();
    ASSERT_EQ(files.size(), 1U);
    const Json kept = Json::parse(
        readBytes(files.front().parent_path() / (shortName(files.front()) + ".score.json")));
    const Session session = readSession(files.front());
    const auto score = runForScore(session);
    ASSERT_TRUE(score);
    EXPECT_EQ(Json(toJson(*score, *session.task)), kept);
}

TEST_F(EditorPractice, ATryThatWaitsForItsBladeEndsWithItsScene) {
    moveTo(kTop.x(), kTop.y());
    press(true);
    moveTo(kBottom.x(), kBottom.y());
    tap(Key::enter, {.shift = true}, 2);
    EXPECT_FALSE(practice().finished) << "the blade still cuts";
    writeText(folder / "other.obj", objText(icosphereSoup(2)));
    editor->open(folder / "other.obj");
    press(false);
    waitWhile([this] { return panels().name != "other"; });
    frames(4);
    EXPECT_EQ(practice().name, "");
    EXPECT_FALSE(fs::exists(folder / "tries"));
}

TEST_F(EditorPractice, ANewStartForgetsTheTryBeforeUnlessItIsBroughtBack) {
    cutDown(0);
    click("practice.finish", 3);
    const Session once = readSession(keptTries().front());
    const auto score = runForScore(once);
    Session again = once;
    again.events.push_back({once.steps, Restart{}});
    Session broughtBack = again;
    for (SessionEvent event : once.events) {
        event.step += once.steps;
        again.events.push_back(event);
    }
    again.steps += once.steps;
    const auto second = runForScore(again);
    ASSERT_TRUE(score && second);
    EXPECT_NEAR(*second->forceMax, *score->forceMax, 0.01 * *score->forceMax);
    EXPECT_NEAR(*second->time, *score->time, 1e-9);
    EXPECT_EQ(*second->undos, 0);

    Session waving = broughtBack;
    waving.events.push_back({once.steps, MoveBlade{{{5, 0, 0}, {6, 0, 0}}}});
    waving.steps += 2;
    const auto nothing = runForScore(waving);
    ASSERT_TRUE(nothing);
    EXPECT_FALSE(nothing->forceMax);
    EXPECT_EQ(*nothing->undos, 0);
    broughtBack = waving;
    broughtBack.events.insert(broughtBack.events.end() - 1, {once.steps, Undo{}});
    const auto cheated = runForScore(broughtBack);
    ASSERT_TRUE(cheated);
    EXPECT_EQ(*cheated->undos, 1);
    EXPECT_FALSE(cheated->passed());
}

TEST_F(EditorPractice, ATryIsOfThePersonWhoseNameItHas) {
    cutDown(0);
    click("practice.finish", 3);
    ASSERT_EQ(keptTries().size(), 1U);
    const fs::path session = keptTries().front();
    const fs::path score = session.parent_path() / (shortName(session) + ".score.json");
    const auto keep = [&](const std::string& name, const std::string& text) {
        fs::copy_file(session, session.parent_path() / (name + ".kerf.json"));
        writeText(session.parent_path() / (name + ".score.json"), text);
    };
    keep("Halve-it_Ann-Lee_2026-01-01", readBytes(score));
    keep("Halve-it_Zoe_2026-01-01", R"({"time": "x", "path": [], "taken": true})");
    const auto lastOf = [&](const std::string& person) {
        click("practice.person");
        tap(Key::a, {.control = true});
        type(person, 2);
        return practice().hasLast;
    };
    EXPECT_FALSE(lastOf("Ann"));
    EXPECT_TRUE(lastOf("Ann Lee"));
    EXPECT_FALSE(lastOf("Z"));
    EXPECT_TRUE(lastOf("Zoe")) << "a score of other types shows less";
}

TEST_F(EditorPractice, AgainMakesItTheLastTry) {
    cutDown(0);
    click("practice.finish", 3);
    ASSERT_TRUE(practice().finished);
    EXPECT_FALSE(practice().hasLast);
    click("practice.again");
    settle(2);
    EXPECT_FALSE(practice().finished);
    EXPECT_TRUE(practice().hasLast);
}

TEST_F(EditorPractice, AnotherCutOrUndoTakesTheScoreAway) {
    cutDown(0);
    tap(Key::enter, {.shift = true}, 3);
    ASSERT_TRUE(practice().finished);
    tap(Key::z, {.control = true});
    settle(2);
    EXPECT_FALSE(practice().finished);
}

TEST_F(EditorPractice, AnotherTryIsCutInABodyThatIsPinnedLikeBefore) {
    Session session = readSession(folder / "halves.kerf.json");
    session.events = {{0, Pin{Bounds{Vec3(-0.6, -0.6, -0.6), Vec3(0.6, -0.3, 0.6)}}}};
    writeText(folder / "pinned.kerf.json", formatSession(session));
    open(folder / "pinned.kerf.json");
    settle();
    const auto pinned = editor->scene()->simulation().pinnedVertices();
    ASSERT_FALSE(pinned.empty());
    cutDown(0);
    tap(Key::enter, {.shift = true}, 3);
    tap(Key::r);
    settle();
    EXPECT_EQ(editor->scene()->simulation().pinnedVertices(), pinned);
    EXPECT_TRUE(editor->scene()->simulation().strokes().empty());
    cutDown(0);
    EXPECT_FALSE(editor->scene()->simulation().pinnedVertices().empty());
}

TEST_F(EditorPractice, ATaskSetsItsToolAndItsDepth) {
    Session session = readSession(folder / "halves.kerf.json");
    session.task->depth = 0.02;
    writeText(folder / "deep.kerf.json", formatSession(session));
    tap(Key::g);
    open(folder / "deep.kerf.json");
    EXPECT_EQ(panels().tools.tool, ui::ToolKind::scalpel);
    EXPECT_EQ(panels().tools.scalpel.depth, 0.02);
    tap(Key::y);
    open(folder / "halves.kerf.json");
    EXPECT_EQ(panels().tools.tool, ui::ToolKind::stroke);
    EXPECT_TRUE(panels().tools.stroke.throughAll);
}

TEST_F(EditorPractice, ItsHintsLeadToTheScore) {
    EXPECT_THAT(panels().help.hint.text, HasSubstr("along the purple line"));
    const Vec2 middle(kWidth / 2.0, kHeight / 2.0);
    dragAndSettle(middle - Vec2(0, 200), middle, 30);
    frames(2);
    const auto choice = [&] {
        const auto& choices = panels().help.hint.choices;
        return choices.size() == 1 ? std::optional(choices[0].id) : std::nullopt;
    };
    EXPECT_EQ(choice(), ui::ActionId::finishTry) << "of an incision";
    tap(Key::enter, {.shift = true}, 3);
    EXPECT_EQ(choice(), ui::ActionId::reset);
    tap(Key::r, {}, 3);
    EXPECT_THAT(panels().help.hint.text, HasSubstr("along the purple line"));
}

TEST_F(EditorPractice, WhatBreaksALimitIsMarkedAndOnesBladeIsShownOnItsWay) {
    const auto shown = [&] {
        return std::ranges::count(panels().view.overlay.traces, ui::Overlay::Trace::Kind::last,
                                  &ui::Overlay::Trace::kind);
    };
    cutDown(60);
    EXPECT_EQ(shown(), 0);
    tap(Key::enter, {.shift = true}, 3);
    ASSERT_TRUE(practice().finished);
    EXPECT_FALSE(practice().violations.empty());
    EXPECT_TRUE(std::ranges::any_of(practice().rows, &ui::ScoreRow::broken));
    EXPECT_EQ(keptTries().size(), 1U);
    EXPECT_GT(shown(), 0);
    EXPECT_THAT(practice().advice, HasSubstr("Slow down"));
    EXPECT_TRUE(editor->itemRects().contains("practice.advice"));
}

/// The line and the edges of its band, on the skin, end at a gap.
TEST_F(EditorPractice, NoLineCrossesTheOpenCut) {
    const auto longest = [&] {
        double most = 0;
        for (const auto& [kind, line] : panels().view.overlay.traces) {
            const bool ofTask =
                kind == ui::Overlay::Trace::Kind::line || kind == ui::Overlay::Trace::Kind::band;
            const double length = std::hypot(line[1].x - line[0].x, line[1].y - line[0].y);
            most = ofTask ? std::max(most, length) : most;
        }
        return most;
    };
    tap(Key::digit7);  // from above
    settle();
    const double whole = longest();
    ASSERT_GT(whole, 0);
    cutDown(0);
    const ApplyForce pull{Ball{{0.4, 0, 0}, 0.2}, {3000, 0, 0}};
    EXPECT_EQ(editor->scene()->execute(pull), "");
    tap(Key::space, {.shift = true}, 80);
    EXPECT_GT(longest(), 0);
    EXPECT_LT(longest(), 4 * whole);
}

TEST_F(EditorPractice, WithoutATaskThereIsNoSuchSection) {
    start(options());
    EXPECT_FALSE(editor->itemRects().contains("practice.finish"));
}

}  // namespace
}  // namespace kerf::app
