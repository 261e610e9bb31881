// Files on their way into the editor and out of it.

#include <sys/types.h>

#include <csignal>

#include "app/editor/storage/file_work.h"
#include "tests/support/file_limit.h"
#include "tests/support/model_defects.h"

namespace kerf::app {
namespace {

/// While one lives, models are read by a program that never answers.
class SlowReader {
  public:
    /// Writes the program into `folder`.
    explicit SlowReader(const fs::path& folder)
        : pidFile_(folder / "slow-reader.pid"),
          program_("KERF_IMPORT", (folder / "slow-reader.sh").string()) {
        const fs::path program = folder / "slow-reader.sh";
        writeText(program, "#!/bin/sh\necho $$ > '" + pidFile_.string() + "'\nexec sleep 100\n");
        fs::permissions(program, fs::perms::owner_all);
    }
    /// The process that was started last; 0 for none yet.
    pid_t process() const {
        pid_t pid = 0;
        std::ifstream(pidFile_) >> pid;
        return pid;
    }
    /// Waits up to ten seconds for that process to end. False where it goes on.
    bool hasEnded() const {
        const pid_t pid = process();
        for (int i = 0; i < 2000; ++i) {
            if (pid > 0 && ::kill(pid, 0) != 0) {
                return true;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return false;
    }

  private:
    fs::path pidFile_;
    Variable program_;
};

class EditorFilesTest : public EditorTest {
  protected:
    /// A model whose reading never ends, until its progress is told.
    void openSlowModel() {
        writeText(folder / "slow.obj", objText(boxSoup()));
        editor->post(ui::FileDrop{{folder / "slow.obj"}});
        waitWhile([&] { return panels().work.title.empty(); });
        frames(2);
    }
};

TEST_F(EditorFilesTest, AModelOpensBehindWhatIsOpen) {
    writeText(folder / "box.obj", objText(boxSoup(Vec3::Ones(), 4)));
    editor->open(folder / "box.obj");
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    waitForWork();
    EXPECT_EQ(editor->title(), "Kerf - box - 1 piece");
    EXPECT_EQ(panels().body.triangles, 192);
    EXPECT_THAT(panels().toast.text, HasSubstr("OBJ has no unit: assumed metres"));
}

TEST_F(EditorFilesTest, WhatIsOpenCanBeCutWhileAModelIsRead) {
    const SlowReader reader(folder.path());
    openSlowModel();
    EXPECT_EQ(panels().work.title, "Opening slow.obj");
    EXPECT_EQ(panels().work.stage, "Reading the file");
    EXPECT_GE(panels().work.seconds, 0.3);
    dragAndSettle(kTop, kBottom, 10);
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
}

TEST_F(EditorFilesTest, CancelEndsTheReaderAndLeavesEverythingAsItWas) {
    const SlowReader reader(folder.path());
    openSlowModel();
    const std::vector<std::uint8_t> before = editor->readPicture().pixels;
    click("work.cancel");
    EXPECT_FALSE(editor->working());
    EXPECT_EQ(panels().work.title, "");
    EXPECT_FALSE(panels().toast.isError);
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    EXPECT_TRUE(reader.hasEnded());
    EXPECT_NE(editor->readPicture().pixels, before) << "the progress is gone";
}

TEST_F(EditorFilesTest, AReaderThatIsKilledLeavesEverythingAsItWas) {
    const SlowReader reader(folder.path());
    openSlowModel();
    waitWhile([&] { return reader.process() == 0; });
    ::kill(reader.process(), SIGKILL);
    waitForWork();
    EXPECT_TRUE(panels().toast.isError);
    EXPECT_THAT(panels().toast.text, HasSubstr("slow.obj: the program that reads it was ended"));
    dragAndSettle(kTop, kBottom, 10);
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
}

TEST_F(EditorFilesTest, SeveralDroppedModelsAreOpenedBesideEachOther) {
    writeText(folder / "box.obj", objText(boxSoup(Vec3::Ones(), 4)));
    writeText(folder / "box.mtl", "newmtl red\n");
    fs::create_directory(folder / "more");
    writeText(folder / "more/tip.obj", objText(soundBall()));
    writeText(folder / "more/tip.png", "no model");
    editor->post(ui::FileDrop{{folder / "box.mtl", folder / "box.obj", folder / "more"}});
    frames(1);
    waitForWork();
    EXPECT_EQ(editor->title(), "Kerf - box - 2 pieces");
    const Session& session = editor->scene()->document().session;
    ASSERT_EQ(session.moreModels.size(), 1U);
    EXPECT_EQ(session.moreModels.front().model.path, folder / "more/tip.obj");
}

TEST(SortDropped, TakesWhatPeopleMean) {
    const test::TemporaryFolder folder;
    for (const char* name : {"b.obj", "a.obj", "scene.gltf", "scene.bin"}) {
        writeText(folder / name, "x");
    }
    const auto of = [](const std::vector<fs::path>& dropped) { return sortDropped(dropped).files; };
    using Files = std::vector<fs::path>;
    EXPECT_EQ(of({folder.path()}),
              (Files{folder / "a.obj", folder / "b.obj", folder / "scene.gltf"}));
    EXPECT_EQ(of({folder / "scene.bin", folder / "scene.gltf"}), Files{folder / "scene.gltf"});
    EXPECT_EQ(of({"x.obj", "y.kerf.json"}), Files{"y.kerf.json"});
    EXPECT_EQ(of({"steel.material.json", "x.obj"}), Files{"x.obj"});
    EXPECT_EQ(of({"notes.txt", "more.txt"}), Files{"notes.txt"});
    const DroppedFiles many = sortDropped(Files(kMostModels + 2, "x.obj"));
    EXPECT_EQ(many.files.size(), std::size_t(kMostModels));
    EXPECT_THAT(many.remark, HasSubstr("2 were left out"));
}

TEST_F(EditorFilesTest, EscapeCancelsTheLoadingToo) {
    const SlowReader reader(folder.path());
    openSlowModel();
    tap(Key::escape);
    EXPECT_FALSE(editor->working());
    EXPECT_TRUE(reader.hasEnded());
}

TEST_F(EditorFilesTest, AnotherFileTakesThePlaceOfTheOneThatIsRead) {
    {
        const SlowReader reader(folder.path());
        openSlowModel();
    }
    writeText(folder / "box.obj", objText(boxSoup()));
    open(folder / "box.obj");
    EXPECT_EQ(editor->title(), "Kerf - box - 1 piece");
}

TEST_F(EditorFilesTest, LeavingWhileAModelIsReadEndsTheReader) {
    const SlowReader reader(folder.path());
    openSlowModel();
    editor.reset();
    EXPECT_TRUE(reader.hasEnded());
}

TEST_F(EditorFilesTest, AModelIsFoundByTypingAndOpenedByEnter) {
    fs::create_directory(folder / "models");
    writeText(folder / "models" / "box.obj", objText(boxSoup()));
    writeText(folder / "models" / "notes.txt", "no model");
    tap(Key::o, {.control = true}, 2);
    ASSERT_EQ(panels().files.purpose, ui::FilePurpose::open);
    type("mod");
    tap(Key::enter, 2);
    ASSERT_EQ(panels().files.folder, folder / "models");
    EXPECT_EQ(panels().files.rows.size(), 1U) << "only what can be opened";
    type("bo");
    EXPECT_EQ(panels().files.selected, 0);
    waitWhile([&] { return panels().files.preview.empty(); });
    EXPECT_THAT(panels().files.preview, Contains(HasSubstr("12 triangles")));
    confirm();
    EXPECT_EQ(panels().files.purpose, ui::FilePurpose::none);
    EXPECT_EQ(editor->title(), "Kerf - box - 1 piece");
    EXPECT_EQ(panels().files.recent.size(), 1U);
}

TEST_F(EditorFilesTest, OfManyFilesOnlyThoseInViewAreDrawn) {
    fs::create_directory(folder / "many");
    for (int i = 0; i < 2000; ++i) {
        writeText(folder / ("many/m" + std::to_string(i) + ".obj"), "");
    }
    writeText(folder / "many/zz##last.obj", "");
    tap(Key::o, {.control = true}, 2);
    type("many");
    tap(Key::enter, 2);
    ASSERT_EQ(panels().files.rows.size(), 2001U);
    type("zz", 2);
    EXPECT_EQ(panels().files.selected, 2000);
    EXPECT_TRUE(editor->itemRects().contains("file.row.zz##last.obj")) << "it is scrolled to";
    EXPECT_LT(editor->itemRects().size(), 500U);
}

TEST_F(EditorFilesTest, APipeIsNeverReplacedByAFile) {
    const fs::path pipe = folder / "pipe.obj";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(writeOutputFile(pipe, "text"), OutputError);
    EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(EditorFilesTest, KeysMeanNothingElseWhileADialogIsOpen) {
    tap(Key::o, {.control = true}, 2);
    type("w v");
    tap(Key::w);
    tap(Key::v);
    tap(Key::space);
    EXPECT_FALSE(panels().display.wireframe);
    EXPECT_EQ(panels().parameters.now.gravity, Vec3(Vec3::Zero()));
    EXPECT_FALSE(panels().transport.playing);
    EXPECT_EQ(panels().files.name, "w v");
    dragAndSettle(kTop, kBottom, 5);
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    tap(Key::escape, 2);
    EXPECT_EQ(panels().files.purpose, ui::FilePurpose::none);
    dragAndSettle(kTop, kBottom, 5);
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces") << "and afterwards all is as before";
}

TEST_F(EditorFilesTest, QuittingIsHeardInADialogAndInAQuestion) {
    dragAndSettle(kTop, kBottom, 5);
    tap(Key::s, {.control = true}, 2);
    tap(Key::q, {.control = true}, 2);
    EXPECT_EQ(panels().files.purpose, ui::FilePurpose::none);
    EXPECT_THAT(panels().question.title, HasSubstr("Quit"));
    tap(Key::q, {.control = true}, 2);
    EXPECT_THAT(panels().question.title, HasSubstr("Quit"));
    click("question.1");
    EXPECT_TRUE(editor->closing());
}

TEST_F(EditorFilesTest, ANameStaysTypedUntilItsFileIsWritten) {
    dragAndSettle(kTop, kBottom, 5);
    tap(Key::s, {.control = true}, 2);
    tap(Key::a, {.control = true});
    {
        const test::FileLimit limit(0);
        enter("mine.kerf.json");
        frames(2);
    }
    EXPECT_TRUE(panels().toast.isError);
    ASSERT_EQ(panels().files.purpose, ui::FilePurpose::saveSession);
    EXPECT_EQ(panels().files.name, "mine.kerf.json");
    confirm();
    EXPECT_TRUE(fs::exists(folder / "mine.kerf.json"));
}

// Dear ImGui kept what it could undo when the name was changed elsewhere, and aborted.
TEST_F(EditorFilesTest, WhatWasTypedIsNotUndoneInAnotherName) {
    tap(Key::s, {.control = true}, 2);
    type("a-name-that-is-longer-than-the-next-one");
    tap(Key::backspace);
    tap(Key::escape, 2);
    tap(Key::o, {.control = true}, 2);
    for (int i = 0; i < 5; ++i) {
        tap(Key::z, {.control = true});
        tap(Key::y, {.control = true});
    }
    EXPECT_EQ(panels().files.purpose, ui::FilePurpose::open);
    EXPECT_EQ(panels().files.name, "");
}

TEST_F(EditorFilesTest, ArrowsChooseAndBackspaceGoesUp) {
    fs::create_directory(folder / "a");
    writeText(folder / "b2.obj", "");
    writeText(folder / "b10.obj", "");
    tap(Key::o, {.control = true}, 2);
    tap(Key::down);
    tap(Key::down, 1);
    EXPECT_EQ(panels().files.name, "b2.obj");
    tap(Key::down, 1);
    EXPECT_EQ(panels().files.name, "b10.obj") << "numbers count by their value";
    tap(Key::up);
    tap(Key::up);
    tap(Key::enter, 2);
    EXPECT_EQ(panels().files.folder, folder / "a");
    tap(Key::backspace, 2);
    EXPECT_EQ(panels().files.folder, folder.path());
}

TEST_F(EditorFilesTest, AKeyRightAfterTheOneThatClosesTheDialogIsHeard) {
    tap(Key::s, {.control = true}, 2);
    for (const Key key : {Key::enter, Key::space}) {
        editor->post(ui::KeyChange{key, true, {}});
        editor->post(ui::KeyChange{key, false, {}});
    }
    waitForWork();
    EXPECT_TRUE(panels().transport.playing);
}

TEST_F(EditorFilesTest, ASessionIsSavedUnderTheNameThatIsTypedAndNothingIsReplacedUnasked) {
    dragAndSettle(kTop, kBottom, 10);
    tap(Key::s, {.control = true}, 2);
    enter("mine");
    const fs::path file = folder / "mine.kerf.json";
    EXPECT_FALSE(readSession(file).events.empty());
    writeText(file, "precious");
    for (const bool replace : {false, true}) {
        tap(Key::s, {.shift = true, .control = true}, 2);
        type("mine");
        tap(Key::enter, 2);
        ASSERT_TRUE(panels().files.asksToOverwrite);
        click(replace ? "file.accept" : "file.cancel");
        if (!replace) {
            EXPECT_FALSE(panels().files.asksToOverwrite);
            tap(Key::escape);
        }
        waitForWork();
        EXPECT_EQ(readBytes(file) == "precious", !replace);
    }
}

TEST_F(EditorFilesTest, SavingAgainWritesTheSameFileWithoutADialog) {
    dragAndSettle(kTop, kBottom, 10);
    saveByKeys();
    const fs::path file = folder / "ball-cut.kerf.json";
    const std::size_t events = readSession(file).events.size();
    tap(Key::v);
    tap(Key::s, {.control = true});
    EXPECT_EQ(panels().files.purpose, ui::FilePurpose::none);
    waitForWork();
    EXPECT_GT(readSession(file).events.size(), events);
    EXPECT_EQ(onlyFile(folder.path()), file);
}

TEST_F(EditorFilesTest, AFileThatSomeoneElseChangedIsNotReplacedUnasked) {
    saveByKeys();
    const fs::path file = folder / "ball-cut.kerf.json";
    writeText(file, "precious");
    for (const Key answer : {Key::escape, Key::enter}) {
        tap(Key::s, {.control = true}, 1);
        EXPECT_EQ(panels().question.title, "Replace ball-cut.kerf.json?");
        EXPECT_THAT(panels().question.text, HasSubstr("changed by another program"));
        tap(answer);
        waitForWork();
        EXPECT_EQ(readBytes(file) == "precious", answer == Key::escape);
    }
}

TEST_F(EditorFilesTest, AnOpenedSessionIsSavedWithoutAQuestion) {
    saveByKeys();
    const fs::path file = folder / "ball-cut.kerf.json";
    const std::size_t events = readSession(file).events.size();
    open(file);
    dragAndSettle(kTop, kBottom, 10);
    tap(Key::s, {.control = true}, 1);
    EXPECT_EQ(panels().question.text, "");
    waitForWork();
    EXPECT_GT(readSession(file).events.size(), events);
}

/// The body, without what lies over the view.
std::vector<std::uint8_t> middleOf(const render::Image& image) {
    std::vector<std::uint8_t> pixels;
    for (int y = 190; y < 420; ++y) {
        const auto row = image.pixels.begin() + 4 * (y * image.width + 350);
        pixels.insert(pixels.end(), row, row + 4 * 260);
    }
    return pixels;
}

// Theme and window are of the person who opens it.
TEST_F(EditorFilesTest, ASessionShowsWhatWasShown) {
    writeText(folder / "ball.obj", objText(icosphereSoup(2)));
    open(folder / "ball.obj");
    drag({480, 150}, {500, 445}, 10);
    settle();
    tap(Key::digit3, 60);
    tap(Key::w);
    tap(Key::n);
    tap(Key::d, 2);
    const ui::DisplaySettings shown = panels().display;
    ASSERT_TRUE(shown.section && shown.wireframe);
    moveTo(5, 5, 2);
    const std::vector<std::uint8_t> before = middleOf(editor->readPicture());
    saveByKeys();
    start(options());
    open(folder / "ball-cut.kerf.json", 2);
    moveTo(5, 5, 2);
    EXPECT_EQ(panels().tools.tool, ui::ToolKind::grab);
    EXPECT_EQ(panels().display.section, shown.section);
    EXPECT_TRUE(panels().display.wireframe);
    EXPECT_TRUE(middleOf(editor->readPicture()) == before);
}

TEST_F(EditorFilesTest, TheEndOfARecordingAsksForAFile) {
    tap(Key::r, {.control = true});
    dragAndSettle(kTop, kBottom, 10);
    tap(Key::r, {.control = true}, 2);
    EXPECT_EQ(panels().files.purpose, ui::FilePurpose::saveSession);
    EXPECT_FALSE(panels().transport.recording);
    tap(Key::escape);
    waitForWork();
    EXPECT_TRUE(fs::is_empty(folder.path()));
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
}

TEST_F(EditorFilesTest, ARecordingDoesNotBeginOverUnsavedCutsUnasked) {
    dragAndSettle(kTop, kBottom, 10);
    tap(Key::r, {.control = true}, 1);
    EXPECT_EQ(panels().question.title, "Start recording without saving?");
    tap(Key::escape, 1);
    EXPECT_FALSE(panels().transport.recording);
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
}

TEST_F(EditorFilesTest, TheNameIsThatOfTheSavedFileAndUnsavedWorkIsMarked) {
    EXPECT_FALSE(panels().session.unsaved);
    dragAndSettle(kTop, kBottom, 10);
    EXPECT_TRUE(panels().session.unsaved);
    tap(Key::s, {.shift = true, .control = true}, 2);
    enter("halves");
    EXPECT_FALSE(panels().session.unsaved);
    EXPECT_EQ(editor->title(), "Kerf - halves - 2 pieces");
    EXPECT_EQ(panels().name, "halves");
}

TEST_F(EditorFilesTest, TheManualOpensAsTheDesktopHasIt) {
    const fs::path program = folder / "xdg-open";
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", (folder.path().string() + ":" + path).c_str(), 1);
    writeText(program, "#!/bin/sh\necho \"$1\" >\"$(dirname \"$0\")/shown\"\n");
    fs::permissions(program, fs::perms::owner_all);
    EXPECT_EQ(openOutside(manualPage()), "Opened " + manualPage().string());
    EXPECT_EQ(readBytes(folder / "shown"), manualPage().string() + "\n");
    writeText(program, "#!/bin/sh\nexit 3\n");
    EXPECT_THROW(openOutside(manualPage()), OutputError) << "no browser";
    ::setenv("PATH", folder.path().c_str(), 1);
    fs::remove(program);
    EXPECT_THROW(openOutside(manualPage()), OutputError) << "no xdg-open";
    EXPECT_THROW(openOutside(folder / "gone.html"), OutputError);
    ::setenv("PATH", path.c_str(), 1);
}

TEST_F(EditorFilesTest, PiecesAreExportedEachIntoAFile) {
    dragAndSettle(kTop, kBottom, 10);
    tap(Key::e, {.control = true}, 2);
    EXPECT_EQ(panels().files.name, "ball-cut.obj");
    type("half.glb");
    click("file.per_piece");
    EXPECT_TRUE(panels().files.filePerPiece);
    confirm();
    EXPECT_THAT(panels().toast.text, HasSubstr("half-1.glb and 1 more file"));
    MeshReport report;
    loadModel(folder / "half-1.glb", &report);
    EXPECT_EQ(report.pieces, 1);
    EXPECT_TRUE(fs::exists(folder / "half-2.glb"));
    EXPECT_FALSE(fs::exists(folder / "half.glb"));
}

/// A box without its lid.
std::string openBox() {
    TriangleSoup soup = boxSoup(Vec3::Ones(), 3);
    std::erase_if(soup.triangles, [&](const Triangle& t) {
        return soup.positions[t[0]].y() > 0.4 && soup.positions[t[1]].y() > 0.4 &&
               soup.positions[t[2]].y() > 0.4;
    });
    return objText(soup);
}

TEST_F(EditorFilesTest, AHoleIsFilledWhereThePersonWantsItAndASessionKeepsIt) {
    writeText(folder / "open.obj", openBox());
    open(folder / "open.obj");
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    EXPECT_THAT(panels().question.text, HasSubstr("12 open edges"));
    EXPECT_THAT(panels().question.choices, ElementsAre("Fill 1 hole", "Thicken", "Cancel"));
    frames(3);
    click("question.2");
    EXPECT_EQ(panels().question.text, "");
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");

    open(folder / "open.obj");
    confirm();
    EXPECT_EQ(editor->title(), "Kerf - open - 1 piece");
    EXPECT_THAT(panels().toast.text, HasSubstr("filled 1 hole"));
    tap(Key::s, {.control = true}, 2);
    enter("filled");
    const Session session = readSession(folder / "filled.kerf.json");
    EXPECT_NEAR(meshVolume(loadSessionModel(session).mesh), std::pow(session.placement.scale, 3),
                1e-5);
}

TEST_F(EditorFilesTest, ARepairIsOfferedWhereFillingIsNoHelpAndASessionKeepsIt) {
    // A side stands twice.
    writeText(folder / "odd.obj",
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
              "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nf 2 3 4\n");
    open(folder / "odd.obj");
    EXPECT_THAT(panels().question.text, HasSubstr("dropped 1 double of a triangle"));
    ASSERT_EQ(panels().question.choices.size(), 2U);
    EXPECT_EQ(panels().question.choices[0], "Repair");
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    confirm();
    EXPECT_EQ(editor->title(), "Kerf - odd - 1 piece");
    EXPECT_THAT(panels().toast.text, HasSubstr("dropped 1 double of a triangle"));
    tap(Key::s, {.control = true}, 2);
    enter("mended");
    const Session session = readSession(folder / "mended.kerf.json");
    EXPECT_TRUE(session.model.repair);
    EXPECT_NEAR(meshVolume(loadSessionModel(session).mesh),
                std::pow(session.placement.scale, 3) / 6, 1e-5);
}

}  // namespace
}  // namespace kerf::app
