// No work is lost: what an editor leaves behind that ended without being closed, and questions
// before work goes.
#include <gmock/gmock.h>

#include <cerrno>

#include "app/journal/journal_folder.h"
#include "app/scene/editor_scene.h"
#include "app/scene/readout/scene_readout.h"
#include "sim/run/simulation.h"
#include "tests/app/editor/editor_fixture.h"
#include "tests/app/session/replayed_session.h"
#include "tests/support/file_fault.h"

namespace kerf::app {
namespace {

using ::testing::HasSubstr;

class EditorJournalTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        test::writeText(folder / "ball.obj", test::objText(test::icosphereSoup(2)));
        test::writeText(folder / "box.obj", test::objText(test::boxSoup(Vec3::Ones(), 4)));
        test::writeText(folder / "settings.json", "{}");
        editor.reset();
        editor = newEditor();
        frames(2);
    }
    std::unique_ptr<Editor> newEditor(bool byTheClock = false) {
        EditorOptions options = EditorTest::options();
        options.byTheClock = byTheClock;
        options.portion = 1e-6;
        options.settingsFile = folder / "settings.json";
        options.journals = journals.path();
        return std::make_unique<Editor>(options, openDocument(folder / "ball.obj"));
    }
    /// As after a crash: what was asked for reaches the disk, and nothing is put in order.
    void crash() { editor.reset(); }
    /// Until it asks something.
    void awaitQuestion() {
        for (int i = 0; i < 2000 && panels().question.text.empty(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            frames(1);
        }
        frames(2);
        ASSERT_FALSE(panels().question.text.empty());
    }
    bool asksSoon() {
        for (int i = 0; i < 40 && panels().question.text.empty(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            frames(1);
        }
        return !panels().question.text.empty();
    }
    void cut() {
        drag(kTop, kBottom, 10);
        settle();
        frames(2);
    }
    void cutAcross() {
        drag(kTop + Vec2(-80, 0), kBottom + Vec2(100, 0), 10);
        settle();
        frames(2);
    }
    std::string hash() { return editor->scene()->simulation().stateHash(); }
    std::size_t files() {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(journals.path()), {}));
    }
    /// Until there are so many files beside each other.
    void expectFiles(std::size_t count) {
        for (int i = 0; i < 2000 && files() != count; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            frames(1);
        }
        EXPECT_EQ(files(), count);
    }
    /// Goes on from what was left, until the journal of this editor alone has it.
    void takeOver() {
        const std::filesystem::path left = lookForLeftWork(journals.path()).at(0).journal->file();
        goOn();
        for (int i = 0; i < 2000 && std::filesystem::exists(left); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            frames(1);
        }
        ASSERT_FALSE(std::filesystem::exists(left));
    }
    /// The session that can be gone on from.
    Session leftSession() {
        const std::vector<LeftWork> left = lookForLeftWork(journals.path());
        EXPECT_EQ(left.size(), 1U);
        return left.empty() ? Session{} : parseSession(left[0].kept.session, {});
    }
    void goOn() {
        editor = newEditor();
        awaitQuestion();
        click("question.0");
        waitForWork();
        settle();
        frames(2);
    }
    /// What comes back has the bits that were lost, and a replay has them too.
    void expectAllIsBack(const std::string& before, const std::string& title) {
        const Session session = leftSession();
        EXPECT_EQ(replayedHash(session, loadSessionModel(session)), before);
        goOn();
        EXPECT_EQ(hash(), before);
        EXPECT_EQ(editor->title(), title);
    }

    test::TemporaryFolder journals;
};

TEST_F(EditorJournalTest, AfterACrashItGoesOnWithTheSameBits) {
    cut();
    cutAcross();
    dragSlider("param.iterations");
    const std::string before = hash();
    const std::string title = editor->title();
    crash();
    expectAllIsBack(before, title);
    drag(kTop + Vec2(-40, 0), kBottom + Vec2(-30, 0), 10);
    settle();
    EXPECT_NE(editor->title(), title) << "it can be gone on from";
}

TEST_F(EditorJournalTest, TheQuestionHasNameCountAndPicture) {
    cut();
    frames(90);
    crash();
    editor = newEditor();
    awaitQuestion();
    EXPECT_EQ(panels().question.title, "Recover unsaved work?");
    EXPECT_THAT(panels().question.text, HasSubstr("1 cut,"));
    ASSERT_NE(panels().question.picture, nullptr);
    EXPECT_GT(panels().question.picture->width, 100);
    EXPECT_LE(panels().question.picture->width, 320);
    EXPECT_TRUE(editor->itemRects().contains("question.picture"));
}

TEST_F(EditorJournalTest, ACrashAfterACrashLosesNothingEither) {
    cut();
    crash();
    takeOver();
    cutAcross();
    const std::string before = hash();
    const std::string title = editor->title();
    EXPECT_NE(title, "Kerf - ball - 2 pieces");
    crash();
    expectAllIsBack(before, title);
}

TEST_F(EditorJournalTest, ACrashWhileItGoesOnLosesNothing) {
    cut();
    const std::string before = hash();
    crash();
    editor = newEditor();
    awaitQuestion();
    click("question.0");
    crash();
    expectAllIsBack(before, "Kerf - ball - 2 pieces");
}

// The plots had read from the scene before, which was gone.
TEST_F(EditorJournalTest, WhatComesBackInPortionsIsToldOfAtOnce) {
    cut();
    crash();
    editor = newEditor(true);
    awaitQuestion();
    click("question.0");
    waitForWork();
    EXPECT_EQ(panels().plots.history, &editor->scene()->readout().readings().history());
}

TEST_F(EditorJournalTest, UndoneAndFallingWorkComesBackToo) {
    cut();
    cutAcross();
    tap(Key::z, {.control = true});
    settle();
    tap(Key::space);
    frames(12);
    tap(Key::space);
    frames(3);
    const std::string before = hash();
    crash();
    expectAllIsBack(before, "Kerf - ball - 2 pieces");
}

TEST_F(EditorJournalTest, AnAddedModelComesBackWithoutACut) {
    tap(Key::o, {.shift = true, .control = true});
    frames(2);
    type("box.obj");
    tap(Key::enter);
    waitForWork();
    EXPECT_EQ(panels().model.models.size(), 2U);
    crash();
    goOn();
    EXPECT_EQ(panels().model.models.size(), 2U);
}

TEST_F(EditorJournalTest, WhatAPersonAddsToASessionComesBackWithIt) {
    test::writeText(folder / "slice.kerf.json", R"({
        "format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"},
        "params": {"gravity": [0, 0, 0], "floor": null, "iterations": 4}, "steps": 60,
        "events": [{"step": 1, "type": "blade", "a": [-2, 1.5, 0.1], "b": [2, 1.5, 0.1]},
                   {"step": 40, "type": "blade", "a": [-2, -1.5, 0.1], "b": [2, -1.5, 0.1]},
                   {"step": 41, "type": "lift"}]})");
    openAtStart(folder / "slice.kerf.json");
    editor->scene()->seek(20);
    settle();
    tap(Key::v);
    frames(2);
    editor->scene()->seek(60);
    settle();
    frames(2);
    const std::string before = hash();
    crash();
    expectAllIsBack(before, "Kerf - slice - 2 pieces");
}

TEST_F(EditorJournalTest, WhatWasNotChangedIsNotOffered) {
    frames(5);
    crash();
    editor = newEditor();
    EXPECT_FALSE(asksSoon());
    expectFiles(1);
}

TEST_F(EditorJournalTest, WhatWasSavedIsNotOffered) {
    cut();
    saveByKeys();
    crash();
    editor = newEditor();
    EXPECT_FALSE(asksSoon());
    expectFiles(1);
}

TEST_F(EditorJournalTest, DiscardedWorkIsGoneAndPutOffWorkIsOfferedAgain) {
    cut();
    crash();
    editor = newEditor();
    awaitQuestion();
    tap(Key::escape);
    frames(3);
    EXPECT_TRUE(panels().question.text.empty());
    crash();
    editor = newEditor();
    awaitQuestion();
    click("question.1");
    frames(2);
    EXPECT_FALSE(asksSoon());
    crash();
    editor = newEditor();
    EXPECT_FALSE(asksSoon());
}

TEST_F(EditorJournalTest, OtherWindowsAreLeftAlone) {
    cut();
    auto other = std::exchange(editor, newEditor());
    EXPECT_FALSE(asksSoon());
    cutAcross();
    expectFiles(2);
    crash();
    other.reset();
    editor = newEditor();
    awaitQuestion();
    click("question.1");
    awaitQuestion();
    click("question.1");
    frames(2);
    EXPECT_FALSE(asksSoon());
}

TEST_F(EditorJournalTest, OneThatIsSwitchedOffKeepsNothing) {
    crash();
    std::filesystem::remove_all(journals.path());
    test::writeText(folder / "settings.json", R"({"keep_journal": false})");
    editor = newEditor();
    cut();
    frames(90);
    EXPECT_FALSE(std::filesystem::exists(journals.path()));
    std::filesystem::create_directories(journals.path());
}

TEST_F(EditorJournalTest, AModelThatHasChangedSinceIsSaidAndTheWorkStays) {
    cut();
    crash();
    test::writeText(folder / "ball.obj", test::objText(test::icosphereSoup(1)));
    goOn();
    EXPECT_TRUE(panels().toast.isError);
    EXPECT_THAT(panels().toast.text, HasSubstr("ball.obj"));
    EXPECT_THAT(panels().toast.text, HasSubstr("offered again"));
    crash();
    test::writeText(folder / "ball.obj", test::objText(test::icosphereSoup(2)));
    goOn();
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
}

TEST_F(EditorJournalTest, OnAFullDiskOneSentenceComesAndEditingGoesOn) {
    // Else the journal of the ball might be what the full disk meets.
    for (int i = 0; i < 2000 && editor->idleSeconds() < 1; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        frames(1);
    }
    ASSERT_GE(editor->idleSeconds(), 1);
    const test::FileFault fault(1, ENOSPC, true);
    editor->open(folder / "box.obj");
    waitForWork();
    const auto isSaid = [&] {
        return panels().toast.text.find("save the session now and then") != std::string::npos;
    };
    for (int i = 0; i < 2000 && !isSaid(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        frames(1);
    }
    EXPECT_TRUE(isSaid());
    cut();
    EXPECT_EQ(editor->title(), "Kerf - box - 2 pieces");
    EXPECT_EQ(std::ranges::count_if(panels().log,
                                    [](const ui::LogLine& line) {
                                        return line.text.find("now and then") != std::string::npos;
                                    }),
              1);
}

// --- Questions before work goes ----------------------------------------------------------------

TEST_F(EditorJournalTest, LeavingAsksAndEscStays) {
    cut();
    tap(Key::q, {.control = true});
    frames(2);
    EXPECT_THAT(panels().question.title, HasSubstr("Quit"));
    tap(Key::escape);
    frames(2);
    EXPECT_FALSE(editor->closing());
    EXPECT_TRUE(panels().question.text.empty());
    editor->askToLeave();
    frames(2);
    click("question.1");
    EXPECT_TRUE(editor->closing());
    expectFiles(0);
}

TEST_F(EditorJournalTest, LeavingWithoutWorkDoesNotAsk) {
    tap(Key::q, {.control = true});
    EXPECT_TRUE(editor->closing());
    expectFiles(0);
}

TEST_F(EditorJournalTest, LeavingSavesFirstIfThatIsWanted) {
    cut();
    tap(Key::q, {.control = true});
    frames(2);
    tap(Key::enter);
    frames(2);
    ASSERT_EQ(panels().files.purpose, ui::FilePurpose::saveSession);
    EXPECT_FALSE(editor->closing());
    type("kept");
    tap(Key::enter);
    waitForWork();
    EXPECT_TRUE(editor->closing());
    EXPECT_TRUE(std::filesystem::exists(folder / "kept.kerf.json"));
    expectFiles(0);
}

TEST_F(EditorJournalTest, LeavingWaitsForWhatIsBeingSaved) {
    cut();
    tap(Key::s, {.control = true});
    frames(2);
    type("kept");
    editor->post(ui::KeyChange{Key::enter, true, {}});
    editor->post(ui::KeyChange{Key::enter, false, {}});
    editor->post(ui::KeyChange{Key::q, true, {.control = true}});
    editor->frame(1.0 / 60);
    EXPECT_TRUE(panels().question.text.empty());
    waitForWork();
    EXPECT_TRUE(editor->closing());
    EXPECT_TRUE(std::filesystem::exists(folder / "kept.kerf.json"));
}

TEST_F(EditorJournalTest, ADialogLeftWithoutANameStays) {
    cut();
    tap(Key::q, {.control = true});
    frames(2);
    tap(Key::enter);
    frames(2);
    tap(Key::escape);
    frames(2);
    EXPECT_FALSE(editor->closing());
    saveByKeys();
    EXPECT_FALSE(editor->closing()) << "that was another wish";
}

TEST_F(EditorJournalTest, WhereSavingFailsTheWindowStaysAndSoDoesTheWork) {
    cut();
    const std::string before = hash();
    tap(Key::q, {.control = true});
    frames(2);
    tap(Key::enter);
    frames(2);
    {
        const test::FileFault fault(1, ENOSPC, true);
        tap(Key::enter);
        waitForWork();
    }
    EXPECT_FALSE(editor->closing());
    EXPECT_TRUE(panels().toast.isError);
    EXPECT_THAT(panels().toast.text, HasSubstr("free some space"));
    EXPECT_EQ(hash(), before);
    tap(Key::q, {.control = true});
    frames(2);
    EXPECT_FALSE(panels().question.text.empty()) << "it is still in no file";
}

TEST_F(EditorJournalTest, OpeningAnotherFileAsks) {
    cut();
    editor->post(ui::FileDrop{{folder / "box.obj"}});
    frames(3);
    EXPECT_THAT(panels().question.title, HasSubstr("box.obj"));
    tap(Key::escape);
    frames(2);
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
    editor->post(ui::FileDrop{{folder / "box.obj"}});
    frames(3);
    click("question.1");
    waitForWork();
    EXPECT_EQ(editor->title(), "Kerf - box - 1 piece");
    crash();
    editor = newEditor();
    EXPECT_FALSE(asksSoon()) << "it was not to be saved";
}

}  // namespace
}  // namespace kerf::app
