// No work is lost: what an editor leaves behind that ended without being closed, and questions
// before work goes.

#include "app/journal/journal.h"
#include "app/scene/readout/scene_readout.h"
#include "tests/support/file_limit.h"

namespace kerf::app {
namespace {

class EditorJournalTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        writeText(folder / "ball.obj", objText(icosphereSoup(2)));
        writeText(folder / "box.obj", objText(boxSoup(Vec3::Ones(), 4)));
        writeText(folder / "settings.json", "{}");
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
        waitWhile([&] { return panels().question.text.empty(); });
        frames(2);
        ASSERT_FALSE(panels().question.text.empty());
    }
    bool asksSoon() {
        waitWhile([&] { return panels().question.text.empty(); }, 40);
        return !panels().question.text.empty();
    }
    void cut() {
        dragAndSettle(kTop, kBottom, 10);
        frames(2);
    }
    void cutAcross() {
        dragAndSettle(kTop + Vec2(-80, 0), kBottom + Vec2(100, 0), 10);
        frames(2);
    }
    std::string hash() { return editor->scene()->simulation().stateHash(); }
    std::size_t files() {
        return static_cast<std::size_t>(
            std::ranges::count_if(fs::directory_iterator(journals.path()),
                                  [](const auto& entry) { return isJournal(entry.path()); }));
    }
    /// Until there are so many journals beside each other.
    void expectFiles(std::size_t count) {
        waitWhile([&] { return files() != count; });
        EXPECT_EQ(files(), count);
    }
    /// Goes on from what was left, in its journal.
    void takeOver() {
        goOn();
        expectFiles(1);
    }
    /// The session that can be gone on from.
    Session leftSession() {
        const std::vector<LeftWork> left = lookForLeftWork(journals.path());
        EXPECT_EQ(left.size(), 1U);
        return left.empty() ? Session{} : parseSession(left[0].kept.text(), {});
    }
    void goOn() {
        editor = newEditor();
        awaitQuestion();
        clickAndWait("question.0");
        settle(2);
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
    dragAndSettle(kTop + Vec2(-40, 0), kBottom + Vec2(-30, 0), 10);
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
    clickAndWait("question.0");
    EXPECT_EQ(panels().plots.history, &editor->scene()->readout().readings().history());
}

TEST_F(EditorJournalTest, UndoneAndFallingWorkComesBackToo) {
    cut();
    cutAcross();
    tap(Key::z, {.control = true});
    settle();
    playFor(12);
    frames(3);
    const std::string before = hash();
    crash();
    expectAllIsBack(before, "Kerf - ball - 2 pieces");
}

TEST_F(EditorJournalTest, AnAddedModelComesBackWithoutACut) {
    tap(Key::o, {.shift = true, .control = true}, 2);
    enter("box.obj");
    EXPECT_EQ(panels().model.models.size(), 2U);
    crash();
    goOn();
    EXPECT_EQ(panels().model.models.size(), 2U);
}

TEST_F(EditorJournalTest, WhatAPersonAddsToASessionComesBackWithIt) {
    writeText(folder / "slice.kerf.json", sliceSession(kLift));
    openAtStart(folder / "slice.kerf.json");
    editor->scene()->seek(20);
    settle();
    tap(Key::v, 2);
    editor->scene()->seek(60);
    settle(2);
    const std::string before = hash();
    crash();
    expectAllIsBack(before, "Kerf - slice - 2 pieces");
}

TEST_F(EditorJournalTest, WhatWasNotChangedOrIsSavedIsNotOffered) {
    for (const bool saved : {false, true}) {
        frames(5);
        if (saved) {
            cut();
            saveByKeys();
        }
        crash();
        editor = newEditor();
        EXPECT_FALSE(asksSoon()) << saved;
        expectFiles(1);
    }
}

TEST_F(EditorJournalTest, DiscardedWorkIsGoneAndPutOffWorkIsOfferedAgain) {
    cut();
    crash();
    editor = newEditor();
    awaitQuestion();
    tap(Key::escape, 3);
    EXPECT_TRUE(panels().question.text.empty());
    crash();
    editor = newEditor();
    awaitQuestion();
    click("question.1", 2);
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
    click("question.1", 2);
    EXPECT_FALSE(asksSoon());
}

TEST_F(EditorJournalTest, OneThatIsSwitchedOffKeepsNothing) {
    crash();
    fs::remove_all(journals.path());
    writeText(folder / "settings.json", R"({"keep_journal": false})");
    editor = newEditor();
    cut();
    frames(90);
    EXPECT_FALSE(fs::exists(journals.path()));
    fs::create_directories(journals.path());
}

TEST_F(EditorJournalTest, AModelThatHasChangedSinceIsSaidAndTheWorkStays) {
    cut();
    crash();
    writeText(folder / "ball.obj", objText(icosphereSoup(1)));
    goOn();
    EXPECT_TRUE(panels().toast.isError);
    EXPECT_THAT(panels().toast.text, HasSubstr("ball.obj"));
    EXPECT_THAT(panels().toast.text, HasSubstr("offered again"));
    crash();
    writeText(folder / "ball.obj", objText(icosphereSoup(2)));
    goOn();
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
}

TEST_F(EditorJournalTest, OnAFullDiskOneSentenceComesAndEditingGoesOn) {
    cut();
    const FileLimit limit(0);
    cutAcross();
    EXPECT_THAT(panels().toast.text, HasSubstr("Save often."));
    EXPECT_NE(editor->title(), "Kerf - ball - 2 pieces");
    EXPECT_EQ(std::ranges::count_if(panels().log,
                                    [](const ui::LogLine& line) {
                                        return line.text.find("Autosave") != std::string::npos;
                                    }),
              1);
}

// --- Questions before work goes ----------------------------------------------------------------

TEST_F(EditorJournalTest, LeavingAsksAndEscStays) {
    cut();
    tap(Key::q, {.control = true}, 2);
    EXPECT_THAT(panels().question.title, HasSubstr("Quit"));
    tap(Key::escape, 2);
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
    tap(Key::q, {.control = true}, 2);
    tap(Key::enter, 2);
    ASSERT_EQ(panels().files.purpose, ui::FilePurpose::saveSession);
    EXPECT_FALSE(editor->closing());
    enter("kept");
    EXPECT_TRUE(editor->closing());
    EXPECT_TRUE(fs::exists(folder / "kept.kerf.json"));
    expectFiles(0);
}

TEST_F(EditorJournalTest, LeavingWaitsForWhatIsBeingSaved) {
    cut();
    tap(Key::s, {.control = true}, 2);
    type("kept");
    editor->post(ui::KeyChange{Key::enter, true, {}});
    editor->post(ui::KeyChange{Key::enter, false, {}});
    editor->post(ui::KeyChange{Key::q, true, {.control = true}});
    editor->frame(1.0 / 60);
    EXPECT_TRUE(panels().question.text.empty());
    waitForWork();
    EXPECT_TRUE(editor->closing());
    EXPECT_TRUE(fs::exists(folder / "kept.kerf.json"));
}

TEST_F(EditorJournalTest, ADialogLeftWithoutANameStays) {
    cut();
    tap(Key::q, {.control = true}, 2);
    tap(Key::enter, 2);
    tap(Key::escape, 2);
    EXPECT_FALSE(editor->closing());
    saveByKeys();
    EXPECT_FALSE(editor->closing()) << "that was another wish";
}

TEST_F(EditorJournalTest, WhereSavingFailsTheWindowStaysAndSoDoesTheWork) {
    cut();
    const std::string before = hash();
    tap(Key::q, {.control = true}, 2);
    tap(Key::enter, 2);
    {
        const FileFault fault(1, ENOSPC, true);
        confirm();
    }
    EXPECT_FALSE(editor->closing());
    EXPECT_TRUE(panels().toast.isError);
    EXPECT_THAT(panels().toast.text, HasSubstr("free some space"));
    EXPECT_EQ(hash(), before);
    tap(Key::q, {.control = true}, 2);
    EXPECT_FALSE(panels().question.text.empty()) << "it is still in no file";
}

TEST_F(EditorJournalTest, OpeningAnotherFileAsks) {
    cut();
    editor->post(ui::FileDrop{{folder / "box.obj"}});
    frames(3);
    EXPECT_THAT(panels().question.title, HasSubstr("box.obj"));
    tap(Key::escape, 2);
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
    editor->post(ui::FileDrop{{folder / "box.obj"}});
    frames(3);
    clickAndWait("question.1");
    EXPECT_EQ(editor->title(), "Kerf - box - 1 piece");
    crash();
    editor = newEditor();
    EXPECT_FALSE(asksSoon()) << "it was not to be saved";
}

}  // namespace
}  // namespace kerf::app
