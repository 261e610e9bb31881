// What the panels ask for, in the whole editor without a window.
#include "app/editor/editor.h"
#include "app/editor/view/editor_toast.h"
#include "app/scene/readout/cut_quality.h"

namespace kerf::app {
namespace {

class EditorPanelsTest : public EditorTest {
  protected:
    Document document() override {
        return openDocument(gpu::dataPath("assets/sessions/sphere20.kerf.json"));
    }
    EditorOptions options() override {
        EditorOptions options = EditorTest::options();
        options.width = 1280;
        options.height = 720;
        options.drawsAll = true;
        options.settingsFile = settingsFile;
        return options;
    }
    void start() { EditorTest::start(options(), document()); }
    /// Folds a section first, so that there is room.
    void chooseLight() {
        clickOn("section.simulation");
        clickOn("section.window");
        clickOn("window.light");
    }
    void moveOnto(const std::string& item) {
        const ui::Rect place = editor->itemRects().at(item);
        moveTo(place.x + place.width / 2, place.y + place.height / 2);
    }
    void clickOn(const std::string& item) {
        moveOnto(item);
        press(true);
        press(false, 3);
    }
    std::vector<fs::path> files() const {
        const fs::directory_iterator found(folder.path());
        return {begin(found), end(found)};
    }

    fs::path settingsFile;
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
    playFor(10);
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
    playFor(10);
    clickOn("plots.csv");
    waitForWork();
    ASSERT_EQ(files().size(), 1U);
    EXPECT_THAT(panels().toast.text, HasSubstr(files()[0].string()));
    const std::string text = readBytes(files()[0]);
    EXPECT_THAT(text, StartsWith("plot,curve,time,mean,min,max,values\n"));
    EXPECT_THAT(text, HasSubstr("\nvolume,volume,"));
    fs::remove(files()[0]);
    clickOn("plots.png");
    waitForWork();
    ASSERT_EQ(files().size(), 1U);
    const render::Image picture = render::readPng(files()[0]);
    EXPECT_EQ(picture.width, 1200);
    EXPECT_EQ(picture.height, 600) << "two plots";
}

TEST_F(EditorPanelsTest, PlotsHoldAndFollow) {
    tap(Key::space, 6);
    tap(Key::h, 1);
    ASSERT_TRUE(panels().plots.view.end.has_value());
    const double held = *panels().plots.view.end;
    frames(5);
    EXPECT_EQ(panels().plots.view.end, held);
    EXPECT_GT(panels().transport.time, held);
    tap(Key::h, {.shift = true}, 1);
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
    tap(Key::period, 1);
    EXPECT_EQ(panels().transport.step, 1) << "it is simulated all the same";
    EXPECT_TRUE(panels().changes.rows.empty()) << "and there is nothing to undo";
    clickOn("pieces.show_all");
    EXPECT_FALSE(panels().pieces.rows[0].hidden);
}

TEST_F(EditorPanelsTest, TheLogKeepsWhatWasSaid) {
    open("/no/such/file.obj");
    ASSERT_FALSE(panels().log.empty());
    EXPECT_TRUE(panels().log.back().isError);
    EXPECT_THAT(panels().log.back().text, HasSubstr("/no/such/file.obj"));
}

TEST_F(EditorPanelsTest, SettingsAreKeptWhereAFileIsNamed) {
    chooseLight();
    EXPECT_EQ(panels().settings.theme, ui::Theme::light);
    EXPECT_TRUE(files().empty()) << "without a file nothing is written";
    settingsFile = folder / "settings.json";
    start();
    tap(Key::tab, 1);
    EXPECT_FALSE(panels().settings.showControls);
    tap(Key::tab, 1);
    chooseLight();
    EXPECT_EQ(SettingsFile(settingsFile).now.theme, ui::Theme::light);
    start();
    EXPECT_EQ(panels().settings.theme, ui::Theme::light);
    writeText(settingsFile, "{");
    start();
    EXPECT_EQ(panels().settings, ui::Settings{});
    EXPECT_THAT(panels().toast.text, HasSubstr(settingsFile.string()));
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
    settingsFile = folder / "settings.json";
    start();
    tap(Key::tab, 1);
    EXPECT_FALSE(panels().settings.showsPanels());
    ASSERT_TRUE(editor->itemRects().contains("panels.show")) << "which key brings them back";
    start();
    EXPECT_TRUE(panels().settings.showControls && panels().settings.showReadings);
    tap(Key::tab, 1);
    clickOn("panels.show");
    EXPECT_TRUE(panels().settings.showControls && panels().settings.showReadings);
    EXPECT_FALSE(editor->itemRects().contains("panels.show"));
    writeText(settingsFile, R"({"show_controls": false, "show_readings": false})");
    start();
    EXPECT_TRUE(panels().settings.showControls) << "a file of before";
}

TEST_F(EditorPanelsTest, APanelTakesClicksWhileTheOtherIsHidden) {
    writeText(settingsFile, R"({"show_readings": false})");
    start();
    clickOn("tool.Pin");
    EXPECT_EQ(panels().tools.tool, ui::ToolKind::pin);
}

TEST_F(EditorPanelsTest, EscapeClosesAMenu) {
    clickOn("plots.choose");
    ASSERT_TRUE(editor->itemRects().contains("plots.energy"));
    tap(Key::escape, 1);
    EXPECT_FALSE(editor->itemRects().contains("plots.energy"));
}

// The quality of cuts in the panel.

class EditorCuts : public EditorTest {
  protected:
    /// Frames until the figures are there.
    void waitForFigures() {
        settle();
        waitWhile([&] { return panels().cuts.note.starts_with("Measuring"); });
    }
    void cutAcross() {
        drag(kTop, kBottom, 10);
        waitForFigures();
    }
    /// Folds others first, so that there is room.
    void openSection() {
        for (const char* section : {"section.simulation", "section.tools", "section.cuts"}) {
            click(section);
        }
    }
    std::string figure(const std::string& quantity) {
        for (const ui::CutRow& row : panels().cuts.rows) {
            if (row.quantity == quantity) {
                return row.all;
            }
        }
        return "none";
    }
};

TEST_F(EditorCuts, AreMeasuredWhereTheirSectionIsOpen) {
    cutAcross();
    ASSERT_GT(panels().body.triangles, 768) << "it was cut";
    EXPECT_TRUE(panels().cuts.rows.empty()) << "the section is folded";
    openSection();
    waitForFigures();
    EXPECT_EQ(figure("Self-intersections"), "0");
    EXPECT_GT(std::stoi(figure("Triangles")), 100);
    EXPECT_GT(std::stoi(figure("Cutting steps")), 3);
    EXPECT_EQ(panels().cuts.note, "");
    EXPECT_TRUE(editor->itemRects().contains("cuts.Triangles"));
}

TEST_F(EditorCuts, FollowUndo) {
    openSection();
    EXPECT_EQ(panels().cuts.note, "No cuts yet.");
    cutAcross();
    const std::string made = figure("Triangles");
    EXPECT_GT(std::stoi(made), 100);
    tap(Key::z, {.control = true});
    waitForFigures();
    EXPECT_EQ(figure("Triangles"), "none");
    EXPECT_EQ(panels().cuts.note, "No cuts yet.");
    tap(Key::z, {.shift = true, .control = true});
    waitForFigures();
    EXPECT_EQ(figure("Triangles"), made);
}

bool offers(const EditorToast& toast) {
    ui::PanelModel model;
    toast.describe(model);
    return model.toast.choice.has_value();
}

TEST(EditorToast, OffersAScreenshotOnceItIsSaved) {
    EditorToast toast;
    toast.offerOnceSaved({.step = 7}, 2);
    toast.show(SavingQueue::Outcome{1, "Saved plots.csv", false});
    EXPECT_FALSE(offers(toast)) << "another file";
    toast.show(SavingQueue::Outcome{2, "Saved kerf.png", false});
    ASSERT_TRUE(offers(toast));
    const std::optional<LogPosition> place = toast.takeOffer();
    ASSERT_TRUE(place);
    EXPECT_EQ(place->step, 7);
    EXPECT_FALSE(toast.takeOffer()) << "once only";
}

TEST(EditorToast, OffersNothingThatFailedOrHasFaded) {
    EditorToast toast;
    toast.offerOnceSaved({}, 1);
    toast.show(SavingQueue::Outcome{1, "The disk is full", true});
    EXPECT_FALSE(offers(toast));
    toast.offerOnceSaved({}, 2);
    toast.show(SavingQueue::Outcome{2, "Saved kerf.png", false});
    toast.elapse(60);
    EXPECT_FALSE(toast.takeOffer());
}

TEST_F(EditorPanelsTest, AnActionIsFoundByWordsAndEscLeavesAllAsItWas) {
    const ui::Settings before = panels().settings;
    tap(Key::p, {.control = true}, 2);
    type("outlines cut");
    tap(Key::escape, 2);
    EXPECT_TRUE(panels().display.cutLines);
    EXPECT_EQ(panels().tools.tool, ui::kFirstTool) << "letters are no keys meanwhile";
    EXPECT_EQ(panels().help.samples, nullptr);
    EXPECT_EQ(panels().settings, before);
    EXPECT_TRUE(panels().changes.rows.empty());
    tap(Key::p, {.control = true}, 2);
    type("outlines cut");
    tap(Key::enter, 2);
    EXPECT_FALSE(panels().display.cutLines);
    EXPECT_EQ(panels().help.samples, nullptr);
}

}  // namespace
}  // namespace kerf::app
