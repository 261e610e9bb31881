#include "app/editor/storage/settings_file.h"

#include <gmock/gmock.h>

#include "app/files/io/errors.h"
#include "tests/support/temporary_folder.h"

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
          std::pair{R"({"plots": "frames"})", "plots"}, std::pair{R"({"plots": [1]})", "plots"}}) {
        try {
            parseSettings(text);
            ADD_FAILURE() << text << " was taken";
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), ::testing::StartsWith(std::string(key) + ": ")) << text;
        }
    }
    EXPECT_THROW(parseSettings("[]"), InputError);
    EXPECT_THROW(parseSettings("{"), InputError);
}

TEST(SettingsFile, IsWrittenOnlyWhereSomethingChanged) {
    test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "new/kerf/settings.json";
    SettingsFile settings(file);
    EXPECT_EQ(settings.problem(), "");
    EXPECT_EQ(settings.save(), "");
    EXPECT_FALSE(std::filesystem::exists(file));
    settings.now = unusual();
    EXPECT_EQ(settings.save(), "");
    EXPECT_EQ(SettingsFile(file).now, unusual());
}

TEST(SettingsFile, ABrokenOneGivesOneSentenceAndTheDefaults) {
    test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "settings.json";
    test::writeText(file, "{\"theme\": ");
    SettingsFile settings(file);
    EXPECT_EQ(settings.now, ui::Settings{});
    EXPECT_THAT(settings.problem(), ::testing::HasSubstr(file.string()));
    EXPECT_EQ(settings.save(), "");
    EXPECT_EQ(test::readBytes(file), "{\"theme\": ") << "it stays until a setting is changed";
}

TEST(SettingsFile, WhereItCannotBeWrittenThatIsSaid) {
    test::TemporaryFolder folder;
    test::writeText(folder / "file", "");
    SettingsFile settings(folder / "file/settings.json");
    settings.now = unusual();
    EXPECT_THAT(settings.save(), ::testing::HasSubstr("could not be saved"));
}

TEST(SettingsFile, WithoutANameNothingIsWritten) {
    SettingsFile settings("");
    settings.now = unusual();
    EXPECT_EQ(settings.save(), "");
}

}  // namespace
}  // namespace kerf::app
