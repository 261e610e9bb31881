// What the panels ask for, in the whole editor without a window.
#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "app/editor/editor.h"
#include "app/editor/storage/settings_file.h"
#include "gpu/data_path.h"
#include "render/scene/picture_comparison.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using ui::Button;
using ui::Key;

class EditorPanelsTest : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        options.width = 1280;
        options.height = 720;
        options.quality = render::Quality::light;
        options.byTheClock = false;
        options.screenshotFolder = folder.path();
        start();
    }
    void TearDown() override {
        editor.reset();
        GlTest::TearDown();
    }

    void start() {
        editor = std::make_unique<Editor>(
            options, openDocument(gpu::dataPath("assets/sessions/sphere20.kerf.json")));
        frames(2);
    }
    /// Folds a section first, so that there is room.
    void chooseLight() {
        clickOn("section.simulation");
        clickOn("section.window");
        clickOn("window.light");
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            editor->frame(1.0 / 60);
        }
    }
    /// Pictures until what was asked for is open, or has failed.
    void waitForWork() {
        frames(1);
        while (editor->working()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            frames(1);
        }
        frames(2);
    }
    void tap(Key key, const ui::Modifiers& modifiers = {}) {
        editor->post(ui::KeyChange{key, true, modifiers});
        editor->post(ui::KeyChange{key, false, modifiers});
        frames(2);
    }
    void moveOnto(const std::string& item) {
        const ui::Rect place = editor->itemRects().at(item);
        editor->post(ui::PointerMove{place.x + place.width / 2, place.y + place.height / 2, {}});
    }
    void clickOn(const std::string& item) {
        moveOnto(item);
        editor->post(ui::ButtonChange{Button::left, true, {}});
        editor->post(ui::ButtonChange{Button::left, false, {}});
        frames(3);
    }
    const ui::PanelModel& panels() const { return editor->panels(); }
    std::vector<std::filesystem::path> files() const {
        std::vector<std::filesystem::path> found;
        for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
            found.push_back(entry.path());
        }
        return found;
    }

    test::TemporaryFolder folder;
    EditorOptions options;
    std::unique_ptr<Editor> editor;
};

TEST_F(EditorPanelsTest, AnExperimentShowsThePapersFiguresBesideItsOwn) {
    ASSERT_EQ(panels().experiments.size(), 5U);
    const auto cardOf = [&](const std::string& name) {
        return *std::ranges::find(panels().experiments, name, &ui::ExperimentCard::name);
    };
    EXPECT_TRUE(cardOf("sphere20").open);
    EXPECT_FALSE(cardOf("sphere20").ours.has_value()) << "nothing is shown that was not measured";
    ASSERT_TRUE(panels().plots.paper.has_value());
    EXPECT_EQ(panels().plots.paper->fps, 172.1);
    tap(Key::space);
    frames(10);
    tap(Key::space);
    ASSERT_TRUE(cardOf("sphere20").ours.has_value());
    EXPECT_NEAR(cardOf("sphere20").ours->fps, 60, 1);
    EXPECT_NEAR(cardOf("sphere20").ours->volume, 100, 2);
    editor->resize(1280, 1400);
    frames(2);
    clickOn("section.experiments");
    clickOn("experiment.sphere80");
    waitForWork();
    EXPECT_EQ(editor->title(), "Kerf - sphere80 - 1 piece");
    EXPECT_TRUE(cardOf("sphere80").open);
    EXPECT_FALSE(cardOf("sphere80").ours.has_value());
    EXPECT_TRUE(cardOf("sphere20").ours.has_value()) << "of the last run";
}

TEST_F(EditorPanelsTest, PlotsAreSavedAsTheyAreShown) {
    tap(Key::space);
    frames(10);
    tap(Key::space);
    clickOn("plots.csv");
    waitForWork();
    ASSERT_EQ(files().size(), 1U);
    EXPECT_THAT(panels().toast.text, ::testing::HasSubstr(files()[0].string()));
    const std::string text = test::readBytes(files()[0]);
    EXPECT_THAT(text, ::testing::StartsWith("plot,curve,time,mean,min,max,values\n"));
    EXPECT_THAT(text, ::testing::HasSubstr("\nvolume,volume,"));
    std::filesystem::remove(files()[0]);
    clickOn("plots.png");
    waitForWork();
    ASSERT_EQ(files().size(), 1U);
    const render::Image picture = render::readPng(files()[0]);
    EXPECT_EQ(picture.width, 1200);
    EXPECT_EQ(picture.height, 600) << "two plots";
}

TEST_F(EditorPanelsTest, PlotsHoldAndFollow) {
    tap(Key::space);
    frames(5);
    tap(Key::h);
    ASSERT_TRUE(panels().plots.view.end.has_value());
    const double held = *panels().plots.view.end;
    frames(5);
    EXPECT_EQ(panels().plots.view.end, held);
    EXPECT_GT(panels().transport.time, held);
    tap(Key::h, {.shift = true});
    EXPECT_EQ(panels().plots.view, ui::PlotView{});
}

TEST_F(EditorPanelsTest, HiddenAndHoveredPiecesChangeThePictureAlone) {
    const render::Image before = editor->readPicture();
    moveOnto("piece.0");
    frames(2);
    EXPECT_EQ(panels().pieces.hovered, 0);
    const render::Image tinted = editor->readPicture();
    EXPECT_GT(render::channelDifference(before, tinted).pixels, 2000);
    clickOn("eye.0");
    EXPECT_TRUE(panels().pieces.rows[0].hidden);
    EXPECT_GT(render::channelDifference(tinted, editor->readPicture()).pixels, 2000);
    tap(Key::period);
    EXPECT_EQ(panels().transport.step, 1) << "it is simulated all the same";
    EXPECT_TRUE(panels().changes.rows.empty()) << "and there is nothing to undo";
    clickOn("pieces.show_all");
    EXPECT_FALSE(panels().pieces.rows[0].hidden);
}

TEST_F(EditorPanelsTest, TheLogKeepsWhatWasSaid) {
    editor->open("/no/such/file.obj");
    waitForWork();
    ASSERT_FALSE(panels().log.empty());
    EXPECT_TRUE(panels().log.back().isError);
    EXPECT_THAT(panels().log.back().text, ::testing::HasSubstr("/no/such/file.obj"));
}

TEST_F(EditorPanelsTest, SettingsAreKeptWhereAFileIsNamed) {
    chooseLight();
    EXPECT_EQ(panels().settings.theme, ui::Theme::light);
    EXPECT_TRUE(files().empty()) << "without a file nothing is written";
    options.settingsFile = folder / "settings.json";
    start();
    tap(Key::tab);
    EXPECT_FALSE(panels().settings.showControls);
    tap(Key::tab);
    chooseLight();
    EXPECT_EQ(SettingsFile(options.settingsFile).now.theme, ui::Theme::light);
    start();
    EXPECT_EQ(panels().settings.theme, ui::Theme::light);
    test::writeText(options.settingsFile, "{");
    start();
    EXPECT_EQ(panels().settings, ui::Settings{});
    EXPECT_THAT(panels().toast.text, ::testing::HasSubstr(options.settingsFile.string()));
}

TEST_F(EditorPanelsTest, AnotherDisplayMakesThePanelsLarger) {
    const double before = editor->itemRects().at("param.iterations").height;
    editor->setScale(1.5F);
    EXPECT_EQ(editor->idleSeconds(), 0);
    frames(2);
    EXPECT_NEAR(editor->itemRects().at("param.iterations").height, 1.5 * before, 2);
}

// They had stayed away at the next start, the menu with them.
TEST_F(EditorPanelsTest, PanelsThatTabHidesAreBackAtTheNextStart) {
    options.settingsFile = folder / "settings.json";
    start();
    tap(Key::tab);
    EXPECT_FALSE(panels().settings.showsPanels());
    ASSERT_TRUE(editor->itemRects().contains("panels.show")) << "which key brings them back";
    start();
    EXPECT_TRUE(panels().settings.showControls && panels().settings.showReadings);
    tap(Key::tab);
    clickOn("panels.show");
    EXPECT_TRUE(panels().settings.showControls && panels().settings.showReadings);
    EXPECT_FALSE(editor->itemRects().contains("panels.show"));
    test::writeText(options.settingsFile, R"({"show_controls": false, "show_readings": false})");
    start();
    EXPECT_TRUE(panels().settings.showControls) << "a file of before";
}

TEST_F(EditorPanelsTest, APanelTakesClicksWhileTheOtherIsHidden) {
    test::writeText(options.settingsFile, R"({"show_readings": false})");
    start();
    clickOn("tool.Pin");
    EXPECT_EQ(panels().tools.tool, ui::Tool::pin);
}

TEST_F(EditorPanelsTest, EscapeClosesAMenu) {
    clickOn("plots.choose");
    ASSERT_TRUE(editor->itemRects().contains("plots.energy"));
    tap(Key::escape);
    EXPECT_FALSE(editor->itemRects().contains("plots.energy"));
}

}  // namespace
}  // namespace kerf::app
