#include "app/editor/storage/file_chooser.h"

namespace kerf::app {
namespace {

ui::Settings unusual() {
    ui::Settings settings;
    settings.theme = ui::Theme::light;
    settings.mouse = ui::MouseScheme::blender;
    settings.uiScale = 1.25;
    settings.showReadings = false;
    settings.keepsJournal = false;
    settings.softwareRenderer = true;
    settings.controlsWidth = 333.5;
    settings.piecesShare = 0.1;
    settings.plots = {"energy"};
    settings.folded = {};
    settings.place = {-1200, 40, 1500, 900, true};
    settings.folders = {{"exports", "/tmp/results"}};
    settings.keys = {{"Remesh", "Ctrl+M"}};
    return settings;
}

TEST(Settings, ComeBackFromTheirText) {
    EXPECT_EQ(parseSettings(formatSettings(unusual())), unusual());
    EXPECT_EQ(parseSettings("{}"), ui::Settings{});
    EXPECT_EQ(parseSettings(R"({"of_a_later_version": [1, 2]})"), ui::Settings{});
}

TEST(Settings, WhatIsWrongIsNamed) {
    for (const auto& [text, key] :
         {std::pair{R"({"theme": "pink"})", "theme"}, std::pair{R"({"theme": 3})", "theme"},
          std::pair{R"({"mouse": "maya"})", "mouse"}, std::pair{R"({"mouse": 1})", "mouse"},
          std::pair{R"({"ui_scale": 99})", "ui_scale"},
          std::pair{R"({"window": [1, 2, 3]})", "window"},
          std::pair{R"({"window": [1, 2, 3, 1000000, 0]})", "window"},
          std::pair{R"({"ui_scale": "1"})", "ui_scale"},
          std::pair{R"({"show_controls": 1})", "show_controls"},
          std::pair{R"({"folders": ["/tmp"]})", "folders"},
          std::pair{R"({"keys": {"Remesh": "Strg+M"}})", "keys"},
          std::pair{R"({"plots": "frames"})", "plots"}, std::pair{R"({"plots": [1]})", "plots"}}) {
        EXPECT_THAT(inputErrorOf([&text = text] { parseSettings(text); }),
                    StartsWith(std::string(key) + ": "))
            << text;
    }
    EXPECT_THROW(parseSettings("[]"), InputError);
    EXPECT_THROW(parseSettings("{"), InputError);
}

TEST(SettingsFile, IsWrittenOnlyWhereSomethingChanged) {
    test::TemporaryFolder folder;
    const fs::path file = folder / "new/kerf/settings.json";
    SettingsFile settings(file);
    EXPECT_EQ(settings.problem(), "");
    EXPECT_EQ(settings.save(), "");
    EXPECT_FALSE(fs::exists(file));
    settings.now = unusual();
    EXPECT_EQ(settings.save(), "");
    EXPECT_EQ(SettingsFile(file).now, unusual());
}

TEST(SettingsFile, ABrokenOneGivesOneSentenceAndTheDefaults) {
    test::TemporaryFolder folder;
    const fs::path file = folder / "settings.json";
    writeText(file, "{\"theme\": ");
    SettingsFile settings(file);
    EXPECT_EQ(settings.now, ui::Settings{});
    EXPECT_THAT(settings.problem(), HasSubstr(file.string()));
    EXPECT_EQ(settings.save(), "");
    EXPECT_EQ(readBytes(file), "{\"theme\": ") << "it stays until a setting is changed";
}

TEST(SettingsFile, WhereItCannotBeWrittenThatIsSaid) {
    test::TemporaryFolder folder;
    writeText(folder / "file", "");
    SettingsFile settings(folder / "file/settings.json");
    settings.now = unusual();
    EXPECT_THAT(settings.save(), HasSubstr("could not be saved"));
}

TEST(SettingsFile, WithoutANameNothingIsWritten) {
    SettingsFile settings("");
    settings.now = unusual();
    EXPECT_EQ(settings.save(), "");
}

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
    writeText(folder / "CMakePresets.json", R"({"version": 3})");
    writeText(folder / "cut.json", R"({"format": "kerf-session", "version": 1})");
    chooser.browse(FilePurpose::open, "");
    ASSERT_EQ(dialog().rows.size(), 1U);
    EXPECT_EQ(dialog().rows[0].name, "cut.json");
}

TEST_F(FileChooserTest, AFilmEndsAsItsKindDoes) {
    chooser.browse(FilePurpose::makeFilm, "ball");
    EXPECT_EQ(dialog().name, "ball-cut.mp4");
    ASSERT_EQ(dialog().kinds.size(), 5U);
    chooser.take(ui::ChooseFileKind{3});
    EXPECT_EQ(dialog().name, "ball-cut.abc");
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
    fs::create_directory(folder / "results");
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
    writeText(folder / "ball.obj", "");
    chooser.browse(FilePurpose::exportMesh, "ball");
    EXPECT_EQ(dialog().name, "ball-cut.obj");
    writeText(folder / "ball-cut.obj", "");
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
        fs::create_directories(folder / place / "models");
        writeText(folder / place / "models" / "ball.obj", "");
        chooser.addRecent(folder / place / "models" / "ball.obj");
    }
    writeText(folder / "here.obj", "");
    chooser.addRecent(folder / "here.obj");
    chooser.browse(FilePurpose::open, "");
    std::vector<std::string> labels;
    std::vector<fs::path> places;
    for (const ui::FolderLink& link : dialog().bookmarks) {
        labels.push_back(link.label);
        places.push_back(link.folder);
    }
    EXPECT_EQ(std::ranges::count(labels, "a/models"), 1);
    EXPECT_EQ(std::ranges::count(labels, "b/models"), 1);
    EXPECT_EQ(std::ranges::count(places, folder.path()), 1) << "it is the current folder already";
}

TEST_F(FileChooserTest, AModelIsExportedBesideItUntilAnotherFolderIsChosen) {
    fs::create_directory(folder / "models");
    fs::create_directory(folder / "results");
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
