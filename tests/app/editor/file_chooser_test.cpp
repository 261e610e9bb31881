#include "app/editor/storage/file_chooser.h"

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
    std::map<std::string, std::string> folders;
    FileChooser chooser{folder.path(), folder / "recent", folders};
};

TEST_F(FileChooserTest, ATestIsChosenUnderTheNameOfTheDocument) {
    chooser.browse(FilePurpose::saveTest, "ball", BrowseFor::testWithPicture);
    EXPECT_EQ(dialog().name, "ball.kerf.json");
    EXPECT_FALSE(chooser.take(ui::NameFile{"other.kerf.json"}));
    const std::optional<ChosenFile> chosen = chooser.take(ui::AcceptFile{});
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->purpose, FilePurpose::saveTest);
    EXPECT_EQ(chosen->file, folder / "other.kerf.json");
    EXPECT_EQ(chosen->what, BrowseFor::testWithPicture);
    EXPECT_EQ(dialog().purpose, FilePurpose::none) << "it closes";
}

TEST_F(FileChooserTest, OtherJsonIsNotListedAmongSessions) {
    test::writeText(folder / "CMakePresets.json", R"({"version": 3})");
    test::writeText(folder / "cut.json", R"({"format": "kerf-session", "version": 1})");
    chooser.browse(FilePurpose::open, "");
    ASSERT_EQ(dialog().rows.size(), 1U);
    EXPECT_EQ(dialog().rows[0].name, "cut.json");
}

TEST_F(FileChooserTest, AFilmEndsAsItsKindDoes) {
    chooser.browse(FilePurpose::makeFilm, "ball");
    EXPECT_EQ(dialog().name, "ball-cut.mp4");
    ASSERT_EQ(dialog().kinds.size(), 3U);
    chooser.take(ui::ChooseFileKind{2});
    EXPECT_EQ(dialog().name, "ball-cut.gif");
    chooser.take(ui::SetFilmLook{{.speed = 0.5, .captions = false, .turntable = true}});
    chooser.take(ui::NameFile{"ball.avi"});
    const std::optional<ChosenFile> chosen = chooser.take(ui::AcceptFile{});
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->purpose, FilePurpose::makeFilm);
    EXPECT_EQ(chosen->file, folder / "ball.avi.gif");
    EXPECT_EQ(chosen->film.speed, 0.5);
    EXPECT_FALSE(chosen->film.captions);
    EXPECT_TRUE(chosen->film.turntable);
}

TEST_F(FileChooserTest, RemembersTheFolderOfEachKind) {
    std::filesystem::create_directory(folder / "results");
    chooser.browse(FilePurpose::exportMesh, "ball");
    chooser.take(ui::GoToFolder{folder / "results"});
    ASSERT_TRUE(chooser.take(ui::AcceptFile{}));
    for (const FilePurpose other :
         {FilePurpose::open, FilePurpose::saveSession, FilePurpose::makeFilm}) {
        chooser.browse(other, "ball");
        EXPECT_EQ(dialog().folder, folder.path());
    }
    FileChooser next{folder.path(), {}, folders};
    next.browse(FilePurpose::exportMesh, "ball");
    ui::PanelModel model;
    next.describe(model);
    EXPECT_EQ(model.files.folder, folder / "results") << "at the next start";
}

TEST_F(FileChooserTest, AFolderThatIsGoneIsNotGoneTo) {
    folders["exports"] = folder / "gone";
    chooser.browse(FilePurpose::exportMesh, "ball");
    EXPECT_EQ(dialog().folder, folder.path());
}

TEST_F(FileChooserTest, ProposesNeitherTheSourceNorATakenName) {
    test::writeText(folder / "ball.obj", "");
    chooser.browse(FilePurpose::exportMesh, "ball");
    EXPECT_EQ(dialog().name, "ball-cut.obj");
    test::writeText(folder / "ball-cut.obj", "");
    for (const char* document : {"ball", "ball-cut", "ball-cut-7"}) {
        chooser.browse(FilePurpose::exportMesh, document);
        EXPECT_EQ(dialog().name, "ball-cut-2.obj");
    }
    chooser.browse(FilePurpose::saveSession, "ball");
    EXPECT_EQ(dialog().name, "ball-cut.kerf.json");
}

TEST_F(FileChooserTest, ARecentFileNeedsNoDialog) {
    const std::optional<ChosenFile> chosen = chooser.take(ui::OpenFile{folder / "ball.obj"});
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->purpose, FilePurpose::open);
    EXPECT_EQ(chosen->file, folder / "ball.obj");
    EXPECT_FALSE(chooser.take(ui::AcceptFile{})) << "no dialog is open";
}

TEST_F(FileChooserTest, BookmarksOfOneNameAreToldApart) {
    for (const char* place : {"a", "b"}) {
        std::filesystem::create_directories(folder / place / "models");
        test::writeText(folder / place / "models" / "ball.obj", "");
        chooser.addRecent(folder / place / "models" / "ball.obj");
    }
    test::writeText(folder / "here.obj", "");
    chooser.addRecent(folder / "here.obj");
    chooser.browse(FilePurpose::open, "");
    std::vector<std::string> labels;
    std::vector<std::filesystem::path> places;
    for (const ui::FolderLink& link : dialog().bookmarks) {
        labels.push_back(link.label);
        places.push_back(link.folder);
    }
    EXPECT_EQ(std::ranges::count(labels, "a/models"), 1);
    EXPECT_EQ(std::ranges::count(labels, "b/models"), 1);
    EXPECT_EQ(std::ranges::count(places, folder.path()), 1) << "it is the current folder already";
}

TEST_F(FileChooserTest, AModelIsExportedBesideItUntilAnotherFolderIsChosen) {
    std::filesystem::create_directory(folder / "models");
    std::filesystem::create_directory(folder / "results");
    chooser.setSource(folder / "models" / "ball.obj");
    chooser.browse(FilePurpose::exportMesh, "ball");
    EXPECT_EQ(dialog().folder, folder / "models");
    chooser.take(ui::GoToFolder{folder / "results"});
    chooser.take(ui::AcceptFile{});
    chooser.browse(FilePurpose::exportMesh, "ball");
    EXPECT_EQ(dialog().folder, folder / "results");
}

}  // namespace
}  // namespace kerf::app
