// Files on their way into the editor and out of it.
#include <gmock/gmock.h>

#include "tests/app/editor_fixture.h"
#include "tests/support/slow_reader.h"

namespace kerf::app {
namespace {

using ::testing::HasSubstr;

class EditorFilesTest : public EditorTest {
  protected:
    /// A model whose reading never ends, until its progress is told.
    void openSlowModel() {
        test::writeText(folder / "slow.obj", test::objText(test::boxSoup()));
        editor->post(ui::FileDrop{{folder / "slow.obj"}});
        for (int i = 0; i < 2000 && panels().work.title.empty(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            frames(1);
        }
        frames(2);
    }
};

TEST_F(EditorFilesTest, AModelOpensBehindWhatIsOpen) {
    test::writeText(folder / "box.obj", test::objText(test::boxSoup(Vec3::Ones(), 4)));
    editor->open(folder / "box.obj");
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    waitForWork();
    EXPECT_EQ(editor->title(), "Kerf - box - 1 piece");
    EXPECT_EQ(panels().triangles, 192);
    EXPECT_THAT(panels().toast, HasSubstr("Scaled by"));
}

TEST_F(EditorFilesTest, WhatIsOpenCanBeCutWhileAModelIsRead) {
    const test::SlowReader reader(folder.path());
    openSlowModel();
    EXPECT_EQ(panels().work.title, "Opening slow.obj");
    EXPECT_EQ(panels().work.stage, "Reading the file");
    EXPECT_GE(panels().work.seconds, 0.3);
    drag(kTop, kBottom, 10);
    settle();
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
}

TEST_F(EditorFilesTest, CancelEndsTheReaderAndLeavesEverythingAsItWas) {
    const test::SlowReader reader(folder.path());
    openSlowModel();
    const std::vector<std::uint8_t> before = editor->readPicture().pixels;
    click("work.cancel");
    EXPECT_FALSE(editor->working());
    EXPECT_EQ(panels().work.title, "");
    EXPECT_FALSE(panels().toastIsError);
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    EXPECT_TRUE(reader.hasEnded());
    EXPECT_NE(editor->readPicture().pixels, before) << "the progress is gone";
}

TEST_F(EditorFilesTest, EscapeCancelsTheLoadingToo) {
    const test::SlowReader reader(folder.path());
    openSlowModel();
    tap(Key::escape);
    EXPECT_FALSE(editor->working());
    EXPECT_TRUE(reader.hasEnded());
}

TEST_F(EditorFilesTest, AnotherFileTakesThePlaceOfTheOneThatIsRead) {
    {
        const test::SlowReader reader(folder.path());
        openSlowModel();
    }
    test::writeText(folder / "box.obj", test::objText(test::boxSoup()));
    editor->open(folder / "box.obj");
    waitForWork();
    EXPECT_EQ(editor->title(), "Kerf - box - 1 piece");
}

TEST_F(EditorFilesTest, LeavingWhileAModelIsReadEndsTheReader) {
    const test::SlowReader reader(folder.path());
    openSlowModel();
    editor.reset();
    EXPECT_TRUE(reader.hasEnded());
}

}  // namespace
}  // namespace kerf::app
