// Pictures, checks and exports of a session, added and removed in the window.

namespace kerf::app {
namespace {

using Kind = ui::SessionMark::Kind;

class EditorSessionTest : public EditorTest {
  protected:
    void openSession() {
        writeText(folder / "slice.kerf.json", sliceSession(kLift + R"(,
            {"step": 20, "type": "screenshot", "file": "half.png"},
            {"step": 60, "type": "check", "hash": "0123456789abcdef"})"));
        openAtStart(folder / "slice.kerf.json");
        settle();
    }
    void goTo(int step) {
        editor->scene()->seek(step);
        settle(1);
    }
    Session savedAs(const std::string& name) {
        tap(Key::s, {.shift = true, .control = true}, 2);
        type(name);
        confirm();
        return readSession(folder / (name + ".kerf.json"));
    }
    fs::path sessionFile(const std::string& name) { return folder / (name + ".kerf.json"); }
    /// Asks for a test. A question about its picture is answered by Enter.
    void askForTest(const std::string& name, bool picture) {
        tap(Key::t, {.control = true}, 2);
        if (picture) {
            ASSERT_FALSE(panels().question.text.empty());
            tap(Key::enter, 2);
        }
        ASSERT_EQ(panels().files.purpose, ui::FilePurpose::saveTest);
        type(name);
        tap(Key::enter);
    }
    void expectTestHolds(const std::string& name) {
        const ProgramRun run = runKerf({"test", sessionFile(name)});
        EXPECT_EQ(run.exitCode, 0) << run.out << run.errors;
        EXPECT_THAT(run.out, HasSubstr("passed "));
    }
    std::vector<Kind> kinds() {
        std::vector<Kind> all;
        for (const ui::SessionMark& mark : panels().session.marks) {
            all.push_back(mark.kind);
        }
        return all;
    }
    /// Clicks on the time line below a step.
    void clickMark(int step, Button button) {
        const ui::Rect strip = editor->itemRects().at("timeline.marks");
        constexpr double kHalfKnob = 8;  // of the slider [px]
        const double share = double(step) / panels().session.playback.steps;
        moveTo(strip.x + kHalfKnob + share * (strip.width - 2 * kHalfKnob),
               strip.y + strip.height / 2);
        frames(2);
        press(true, button);
        press(false, button);
        frames(3);
    }
};

TEST_F(EditorSessionTest, KeysAddWhatAReplayMakesAtThisStep) {
    openSession();
    EXPECT_EQ(kinds(), (std::vector{Kind::picture, Kind::check}));
    goTo(30);
    tap(Key::f12, {.shift = true});
    tap(Key::e, {.shift = true});
    goTo(50);
    tap(Key::c, {.shift = true}, 2);
    EXPECT_EQ(kinds(), (std::vector{Kind::picture, Kind::picture, Kind::exported, Kind::check,
                                    Kind::check}));
    EXPECT_EQ(panels().session.marks[1].text, "slice-30.png");
    EXPECT_EQ(panels().session.marks[1].step, 30);
    EXPECT_EQ(panels().session.marks[3].text, "2 pieces, state");
    goTo(10);
    const Session session = savedAs("more");
    EXPECT_EQ(session.events.size(), 8U);
    EXPECT_EQ(session.steps, 60);
    EXPECT_THAT(panels().toast.text, Not(HasSubstr("Since you")));
}

TEST_F(EditorSessionTest, TheCameraOfFilmsIsWhereAPersonLooks) {
    openSession();
    tap(Key::digit7);
    goTo(30);
    tap(Key::m, {.shift = true}, 2);
    EXPECT_EQ(kinds(), (std::vector{Kind::picture, Kind::camera, Kind::check}));
    EXPECT_EQ(panels().toast.text, "Added a camera keyframe at step 30 to the session");
    const Session session = savedAs("seen");
    ASSERT_EQ(session.events.size(), 6U);
    EXPECT_EQ(session.events[2].step, 30);
    const auto& key = std::get<CameraEvent>(session.events[2].action);
    EXPECT_GT(key.camera.eye.y(), 1) << "from the top";
    clickMark(30, Button::right);
    click("mark.remove.30", 2);
    EXPECT_EQ(kinds(), (std::vector{Kind::picture, Kind::check}));
}

TEST_F(EditorSessionTest, AMarkOnTheTimeLineIsGoneToAndRemoved) {
    openSession();
    clickMark(20, Button::left);
    settle();
    EXPECT_EQ(panels().session.playback.step, 20);
    clickMark(20, Button::right);
    click("mark.remove.20", 2);
    EXPECT_EQ(kinds(), std::vector{Kind::check});
    EXPECT_EQ(savedAs("less").events.size(), 4U);
}

TEST_F(EditorSessionTest, TheListRemovesTooAndHasButtonsThatAdd) {
    openSession();
    click("tab.Session", 2);
    click("session.remove.20");
    click("session.Picture", 2);
    EXPECT_EQ(kinds(), (std::vector{Kind::picture, Kind::check}));
    EXPECT_EQ(panels().session.marks[0].text, "slice-0.png");
    click("session.add", 2);
    click("add.Shift+E", 2);
    EXPECT_EQ(panels().session.marks[1].text, "slice-0.ply");
}

TEST_F(EditorSessionTest, SavingSaysWhatBecameOfTheChecks) {
    openSession();
    goTo(30);
    editor->scene()->execute(SetParam{"air_drag", 2.0});
    savedAs("changed");
    EXPECT_THAT(panels().toast.text,
                HasSubstr("Since you changed it at step 30, 1 check was dropped."));
    EXPECT_THAT(panels().toast.text, HasSubstr("changed.kerf.json"));
}

TEST_F(EditorSessionTest, AMereClickLetsTheSessionPlayOnAndAStrokeEndsIt) {
    openSession();
    goTo(5);
    moveTo(kWidth / 2.0, kHeight / 2.0);
    press(true);
    press(false, 3);
    EXPECT_TRUE(panels().session.playback.played);
    dragAndSettle(kTop, kBottom, 5);
    EXPECT_FALSE(panels().session.playback.played);
    savedAs("mine");
    EXPECT_THAT(panels().toast.text, HasSubstr("4 later events were dropped"));
}

TEST_F(EditorSessionTest, ThePicturesOfADocumentThatIsNoSessionAreListedAndSaved) {
    dragAndSettle(kTop, kBottom, 6);
    tap(Key::f12, {.shift = true}, 2);
    const int step = panels().transport.step;
    ASSERT_EQ(kinds(), std::vector{Kind::picture});
    const std::string file = "ball-" + std::to_string(step) + ".png";
    EXPECT_EQ(panels().session.marks[0].text, file);
    tap(Key::period);
    const Session session = savedAs("cut");
    EXPECT_TRUE(std::ranges::any_of(session.events, [&](const SessionEvent& event) {
        const auto* picture = std::get_if<ScreenshotEvent>(&event.action);
        return picture != nullptr && picture->file == file && event.step == step;
    }));
}

TEST_F(EditorSessionTest, AScreenshotWhileRecordingIsOfferedForTheSession) {
    tap(Key::f12);
    waitForWork();
    EXPECT_FALSE(panels().toast.choice) << "nothing is recorded";
    tap(Key::r, {.control = true});
    tap(Key::space, 4);
    tap(Key::f12);
    const int step = panels().transport.step;
    waitForWork(5);
    ASSERT_TRUE(panels().toast.choice);
    click("toast.Shift+F12", 2);
    ASSERT_EQ(panels().session.marks.size(), 1U);
    EXPECT_NEAR(panels().session.marks[0].step, step, 1) << "of the screenshot, not of now";
    EXPECT_FALSE(panels().toast.choice);
    tap(Key::f12, {.shift = true}, 2);
    ASSERT_EQ(panels().session.marks.size(), 2U);
    EXPECT_GT(panels().session.marks[1].step, step + 3) << "of now";
}

TEST_F(EditorSessionTest, TheViewOfASessionIsChosenByAKey) {
    openSession();
    dragAndSettle(kTop, kTop + Vec2(200, 50), 5, Button::right);
    EXPECT_FALSE(savedAs("own").view);
    tap(Key::home, {.shift = true});
    EXPECT_TRUE(savedAs("chosen").view);
}

TEST_F(EditorSessionTest, ATestThatFailsFromTheStartIsRefusedAndOneThatHoldsIsSaved) {
    openSession();
    askForTest("kept", false);
    waitForWork();
    EXPECT_TRUE(panels().toast.isError);
    EXPECT_THAT(panels().toast.text, HasSubstr("No test was saved: "));
    EXPECT_THAT(panels().toast.text, HasSubstr("0123456789abcdef"));
    EXPECT_FALSE(fs::exists(sessionFile("kept")));
    EXPECT_FALSE(fs::exists(folder / "kept.expected"));

    clickMark(60, Button::right);
    click("mark.remove.60", 2);
    goTo(30);
    tap(Key::c, {.shift = true});
    askForTest("kept", false);
    waitForWork();
    EXPECT_FALSE(panels().toast.isError) << panels().toast.text;
    EXPECT_THAT(panels().toast.text, HasSubstr("kept.kerf.json with 1 picture"));
    EXPECT_TRUE(fs::exists(folder / "kept.expected/half.png"));
    EXPECT_EQ(readSession(sessionFile("kept")).events.size(), 5U);
    expectTestHolds("kept");
}

TEST_F(EditorSessionTest, WhatWasDoneSinceTheStartIsSavedAsATestWithAPictureOfItsEnd) {
    dragAndSettle(kTop, kBottom, 6);
    askForTest("cut", true);
    waitForWork();
    EXPECT_FALSE(panels().toast.isError) << panels().toast.text;
    const Session session = readSession(sessionFile("cut"));
    const SessionEvent& last = session.events.back();
    EXPECT_EQ(last.step, session.steps);
    ASSERT_TRUE(std::holds_alternative<ScreenshotEvent>(last.action)) << "no check of the editor's";
    const std::string picture = std::get<ScreenshotEvent>(last.action).file;
    EXPECT_TRUE(fs::exists(folder / "cut.expected" / picture));
    EXPECT_EQ(kinds(), std::vector{Kind::picture}) << "what is open has it too";
    expectTestHolds("cut");
}

TEST_F(EditorSessionTest, ATestMayGoWithoutAPictureOrNotBeSavedAtAll) {
    tap(Key::t, {.control = true}, 2);
    tap(Key::escape, 2);
    EXPECT_TRUE(panels().question.text.empty());
    EXPECT_EQ(panels().files.purpose, ui::FilePurpose::none);
    tap(Key::t, {.control = true}, 3);
    click("question.1", 2);
    enter("bare");
    EXPECT_THAT(panels().toast.text, HasSubstr("with no picture"));
    EXPECT_THAT(kinds(), IsEmpty());
    expectTestHolds("bare");
}

TEST_F(EditorSessionTest, TheWindowGoesOnWhileALongTestIsSavedAndCancellingLeavesNothing) {
    writeText(folder / "long.kerf.json", R"({
        "format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"},
        "steps": 1000000,
        "events": [{"step": 9, "type": "screenshot", "file": "9.png"}]})");
    start(options(), openDocument(folder / "long.kerf.json"));
    askForTest("mine", false);
    const auto isReplaying = [&] {
        frames(1);
        return panels().work.stage.starts_with("Replaying step ");
    };
    for (int i = 0; i < 6000 && !isReplaying(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_THAT(panels().work.title, HasSubstr("mine.kerf.json"));
    EXPECT_THAT(panels().work.stage, HasSubstr("of 1000000"));
    tap(Key::escape);
    EXPECT_FALSE(editor->working());
    editor.reset();  // waits for what was cancelled
    EXPECT_FALSE(fs::exists(sessionFile("mine")));
    EXPECT_FALSE(fs::exists(folder / "mine.expected"));
}

}  // namespace
}  // namespace kerf::app
