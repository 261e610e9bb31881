// Pictures, checks and exports of a session, added and removed in the window.
#include <gmock/gmock.h>

#include "app/scene/editor_scene.h"
#include "app/session/session.h"
#include "tests/app/editor/editor_fixture.h"

namespace kerf::app {
namespace {

using ::testing::HasSubstr;
using Kind = ui::SessionMark::Kind;

class EditorSessionTest : public EditorTest {
  protected:
    void openSession() {
        test::writeText(folder / "slice.kerf.json", R"({
            "format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"},
            "params": {"gravity": [0, 0, 0], "floor": null, "iterations": 4}, "steps": 60,
            "events": [{"step": 1, "type": "blade", "a": [-2, 1.5, 0.1], "b": [2, 1.5, 0.1]},
                       {"step": 20, "type": "screenshot", "file": "half.png"},
                       {"step": 40, "type": "blade", "a": [-2, -1.5, 0.1], "b": [2, -1.5, 0.1]},
                       {"step": 41, "type": "lift"},
                       {"step": 60, "type": "check", "hash": "0123456789abcdef"}]})");
        editor->open(folder / "slice.kerf.json");
        waitForWork();
        settle();
    }
    void goTo(int step) {
        editor->scene()->seek(step);
        settle();
        frames(1);
    }
    Session savedAs(const std::string& name) {
        tap(Key::s, {.control = true});
        frames(2);
        type(name);
        tap(Key::enter);
        waitForWork();
        return readSession(folder / (name + ".kerf.json"));
    }
    std::vector<Kind> kinds() {
        std::vector<Kind> all;
        for (const ui::SessionMark& mark : panels().marks) {
            all.push_back(mark.kind);
        }
        return all;
    }
    /// Clicks on the time line below a step.
    void clickMark(int step, Button button) {
        const ui::Rect strip = editor->itemRects().at("timeline.marks");
        constexpr double kHalfKnob = 8;  // of the slider [px]
        const double share = double(step) / panels().playback.steps;
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
    tap(Key::c, {.shift = true});
    frames(2);
    EXPECT_EQ(kinds(), (std::vector{Kind::picture, Kind::picture, Kind::exported, Kind::check,
                                    Kind::check}));
    EXPECT_EQ(panels().marks[1].text, "slice-30.png");
    EXPECT_EQ(panels().marks[1].step, 30);
    EXPECT_EQ(panels().marks[3].text, "2 pieces, state");
    goTo(10);
    const Session session = savedAs("more");
    EXPECT_EQ(session.events.size(), 8U);
    EXPECT_EQ(session.steps, 60);
    EXPECT_THAT(panels().toast, ::testing::Not(HasSubstr("Since you")));
}

TEST_F(EditorSessionTest, AMarkOnTheTimeLineIsGoneToAndRemoved) {
    openSession();
    clickMark(20, Button::left);
    settle();
    EXPECT_EQ(panels().playback.step, 20);
    clickMark(20, Button::right);
    click("mark.remove.20");
    frames(2);
    EXPECT_EQ(kinds(), std::vector{Kind::check});
    EXPECT_EQ(savedAs("less").events.size(), 4U);
}

TEST_F(EditorSessionTest, TheListRemovesTooAndHasButtonsThatAdd) {
    openSession();
    click("tab.Session");
    frames(2);
    click("session.remove.20");
    click("session.Picture");
    frames(2);
    EXPECT_EQ(kinds(), (std::vector{Kind::picture, Kind::check}));
    EXPECT_EQ(panels().marks[0].text, "slice-0.png");
    click("session.add");
    frames(2);
    click("add.Shift+E");
    frames(2);
    EXPECT_EQ(panels().marks[1].text, "slice-0.ply");
}

TEST_F(EditorSessionTest, SavingSaysWhatBecameOfTheChecks) {
    openSession();
    goTo(30);
    editor->scene()->execute(SetParam{"air_drag", 2.0});
    savedAs("changed");
    EXPECT_THAT(panels().toast, HasSubstr("Since you changed it at step 30, 1 check was dropped."));
    EXPECT_THAT(panels().toast, HasSubstr("changed.kerf.json"));
}

TEST_F(EditorSessionTest, AMereClickLetsTheSessionPlayOnAndAStrokeEndsIt) {
    openSession();
    goTo(5);
    moveTo(kWidth / 2.0, kHeight / 2.0);
    press(true);
    press(false);
    frames(3);
    EXPECT_GT(panels().playback.steps, 0);
    drag(kTop, kBottom, 5);
    settle();
    EXPECT_EQ(panels().playback.steps, 0);
    savedAs("mine");
    EXPECT_THAT(panels().toast, HasSubstr("4 later events were left out"));
}

TEST_F(EditorSessionTest, ThePicturesOfADocumentThatIsNoSessionAreListedAndSaved) {
    drag(kTop, kBottom, 6);
    settle();
    tap(Key::f12, {.shift = true});
    frames(2);
    const int step = panels().step;
    ASSERT_EQ(kinds(), std::vector{Kind::picture});
    const std::string file = "ball-" + std::to_string(step) + ".png";
    EXPECT_EQ(panels().marks[0].text, file);
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
    EXPECT_FALSE(panels().toastChoice) << "nothing is recorded";
    tap(Key::r, {.control = true});
    tap(Key::space);
    frames(4);
    tap(Key::f12);
    const int step = panels().step;
    waitForWork();
    frames(5);
    ASSERT_TRUE(panels().toastChoice);
    click("toast.Shift+F12");
    frames(2);
    ASSERT_EQ(panels().marks.size(), 1U);
    EXPECT_NEAR(panels().marks[0].step, step, 1) << "of the screenshot, not of now";
    EXPECT_FALSE(panels().toastChoice);
    tap(Key::f12, {.shift = true});
    frames(2);
    ASSERT_EQ(panels().marks.size(), 2U);
    EXPECT_GT(panels().marks[1].step, step + 3) << "of now";
}

TEST_F(EditorSessionTest, TheViewOfASessionIsChosenByAKey) {
    openSession();
    drag(kTop, kTop + Vec2(200, 50), 5, Button::right);
    settle();
    EXPECT_FALSE(savedAs("own").view);
    tap(Key::home, {.shift = true});
    EXPECT_TRUE(savedAs("chosen").view);
}

}  // namespace
}  // namespace kerf::app
