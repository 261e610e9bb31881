#include "app/editor/file_chooser.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using ui::FilePurpose;

class FileChooserTest : public ::testing::Test {
  protected:
    ui::FileDialogState dialog() const {
        ui::PanelModel model;
        chooser.describe(model);
        return model.files;
    }

    test::TemporaryFolder folder;
    FileChooser chooser{folder.path(), folder / "recent"};
};

TEST_F(FileChooserTest, ATestIsChosenUnderTheNameOfTheDocument) {
    chooser.browse(FilePurpose::saveTest, "ball", true);
    EXPECT_EQ(dialog().name, "ball.kerf.json");
    EXPECT_FALSE(chooser.take(ui::NameFile{"other.kerf.json"}));
    const std::optional<ChosenFile> chosen = chooser.take(ui::AcceptFile{});
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->purpose, FilePurpose::saveTest);
    EXPECT_EQ(chosen->file, folder / "other.kerf.json");
    EXPECT_TRUE(chosen->testGetsPicture);
    EXPECT_EQ(dialog().purpose, FilePurpose::none) << "it closes";
}

TEST_F(FileChooserTest, RemembersWhereItSavedAndWhereItOpenedApart) {
    std::filesystem::create_directory(folder / "results");
    test::writeText(folder / "ball.obj", "");
    chooser.browse(FilePurpose::exportMesh, "ball");
    chooser.take(ui::GoToFolder{folder / "results"});
    chooser.take(ui::CloseFileDialog{});
    chooser.browse(FilePurpose::open, "");
    EXPECT_EQ(dialog().folder, folder.path());
    chooser.browse(FilePurpose::saveSession, "ball");
    EXPECT_EQ(dialog().folder, folder / "results");
}

TEST_F(FileChooserTest, ARecentFileNeedsNoDialog) {
    const std::optional<ChosenFile> chosen = chooser.take(ui::OpenFile{folder / "ball.obj"});
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->purpose, FilePurpose::open);
    EXPECT_EQ(chosen->file, folder / "ball.obj");
    EXPECT_FALSE(chooser.take(ui::AcceptFile{})) << "no dialog is open";
}

}  // namespace
}  // namespace kerf::app
