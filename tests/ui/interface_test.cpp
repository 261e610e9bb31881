// The panels without a window: events in, actions out.
#include "ui/interface.h"

#include "ui/base/layout.h"
#include "ui/base/widgets.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;

class InterfaceTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        interface.emplace(Theme::dark, 1.0F);
        model.name = "ball";
        model.plots.history = &history;
        model.pieces.rows = {{768, 4.18, 1.0}};
        settle();
    }
    void TearDown() override {
        interface.reset();
        GlTest::TearDown();
    }

    /// One update; SetParam commands are applied, as the editor would.
    std::vector<Action> update(const std::vector<InputEvent>& events) {
        std::vector<Action> actions = interface->update(events, model, kWidth, kHeight, 1.0 / 60);
        for (const Action& action : actions) {
            if (const auto* set = std::get_if<SetParam>(&action)) {
                EXPECT_EQ(setParam(model.parameters.now, set->name, set->value), "");
                changed.insert(set->name);
            } else if (const auto* wanted = std::get_if<SetSettings>(&action)) {
                model.settings = wanted->settings;
            } else if (const auto* view = std::get_if<SetPlotView>(&action)) {
                model.plots.view = view->view;
            } else if (const auto* id = std::get_if<ActionId>(&action)) {
                asked.push_back(*id);
            } else {
                if (const auto* hover = std::get_if<HoverPiece>(&action)) {
                    model.pieces.hovered = hover->piece;
                } else if (const auto* load = std::get_if<HoverLoad>(&action)) {
                    model.body.loads.hovered = load->load;
                }
                others.push_back(action);
            }
        }
        return actions;
    }
    void moveTo(double x, double y) { update({PointerMove{x, y, {}}}); }
    void press(bool down) { update({ButtonChange{Button::left, down, {}}}); }
    void click(double x, double y) {
        moveTo(x, y);
        press(true);
        press(false);
    }

    void tap(Key key) {
        update({KeyChange{key, true, {}}});
        update({KeyChange{key, false, {}}});
        update({});
    }
    /// What takes two pictures to find its place.
    void settle() {
        update({});
        update({});
    }
    void type(const std::string& text) {
        for (const char letter : text) {
            update({Character{static_cast<unsigned char>(letter)}});
        }
    }
    void typeInto(const std::string& item, const std::string& text) {
        clickOn(item);
        type(text);
        tap(Key::enter);
    }
    /// Opens a number where the pointer stands over it.
    void controlClickOn(const std::string& item) {
        const Rect place = interface->itemRects().at(item);
        update({PointerMove{
            place.x + place.width / 2, place.y + place.height / 2, {.control = true}}});
        update({ButtonChange{Button::left, true, {.control = true}}});
        update({ButtonChange{Button::left, false, {}}});
    }
    void clickOn(const std::string& item) {
        const Rect place = interface->itemRects().at(item);
        click(place.x + place.width / 2, place.y + place.height / 2);
    }

    std::optional<Interface> interface;
    PanelModel model;
    History history;
    std::set<std::string> changed;
    std::vector<ActionId> asked;
    std::vector<Action> others;
};

/// Values against time over `seconds`, a hundred a second.
Series wave(double seconds, double middle) {
    Series series;
    for (int i = 0; i <= static_cast<int>(100 * seconds); ++i) {
        series.add(0.01 * i, middle + std::sin(0.05 * i));
    }
    return series;
}

TEST_F(InterfaceTest, PanelsOwnThePointerOnlyOverThemselves) {
    const Layout layout = layoutPanels(kWidth, kHeight, 1);
    for (const Rect& rect : {layout.controls, layout.plots, layout.status}) {
        moveTo(rect.x + rect.width / 2, rect.y + rect.height - 4);
        EXPECT_TRUE(interface->ownsPointer());
    }
    model.help.hint.text = "Drag across the model to cut it.";
    model.toast.text = "Saved.";
    for (const double y : {2.0, 60.0, 360.0, 640.0}) {
        moveTo(kWidth / 2.0, y);
        EXPECT_FALSE(interface->ownsPointer()) << y;
    }
}

TEST_F(InterfaceTest, ALongMessageWithAButtonBeginsBelowTheUpperEdge) {
    for (int line = 0; line < 10; ++line) {
        model.toast.text += "The skin is coarse.\n";
    }
    model.toast.choice = {ActionId::remesh, "Remesh"};
    update({});
    const Rect button = interface->itemRects().at("toast.Shift+R");
    EXPECT_GT(button.y, 10 * button.height / 2);  // a button is less than two lines high
}

TEST_F(InterfaceTest, DraggingSlidersAnswersWithCommands) {
    const Params before = model.parameters.now;
    for (const char* name : {"time_step", "iterations", "ispc_stiffness", "gravity"}) {
        update({});
        const Rect row = interface->itemRects().at(std::string("param.") + name);
        moveTo(row.x + 0.1 * row.width, row.y + row.height / 2);
        press(true);
        moveTo(row.x + 0.9 * row.width, row.y + row.height / 2);
        press(false);
    }
    EXPECT_THAT(changed,
                ::testing::IsSupersetOf({"time_step", "iterations", "ispc_stiffness", "gravity"}));
    EXPECT_GT(model.parameters.now.timeStep, before.timeStep);
    EXPECT_GT(model.parameters.now.iterations, before.iterations);
    EXPECT_GT(model.parameters.now.ispcStiffness, before.ispcStiffness);
}

TEST_F(InterfaceTest, TheResetMarkBringsAValueBack) {
    model.parameters.now.iterations = 35;
    update({});
    clickOn("reset.iterations");
    EXPECT_EQ(model.parameters.now.iterations, model.parameters.start.iterations);
}

TEST_F(InterfaceTest, TransportButtonsAsk) {
    for (const char* name : {"Play or pause", "Next step", "Restart"}) {
        update({});
        clickOn(std::string("button.") + name);
    }
    EXPECT_THAT(asked, ElementsAre(ActionId::playPause, ActionId::stepOnce, ActionId::reset));
}

TEST_F(InterfaceTest, DrawsTheSamePictureTwice) {
    history[Reading::framesPerSecond] = wave(2, 60);
    history[Reading::volumePercent] = wave(2, 99);
    history.marks = {{1, "cut"}};
    const auto draw = [&] {
        update({});
        const gpu::Framebuffer picture(GL_RGBA8, GL_DEPTH_COMPONENT24, kWidth, kHeight);
        picture.bind();
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        interface->draw(picture);
        return picture.readColor();
    };
    const std::vector<std::uint8_t> first = draw();
    EXPECT_EQ(first, draw());
    const std::set<std::uint8_t> values(first.begin(), first.end());
    EXPECT_GT(values.size(), 50U) << "panels and text leave many shades";
}

TEST_F(InterfaceTest, WheelDragAndDoubleClickMoveAlongThePlots) {
    history[Reading::framesPerSecond] = wave(10, 60);
    model.transport.time = 10;
    update({});
    const Rect plot = interface->itemRects().at("plot.frames");
    const double x = plot.x + 0.6 * plot.width;
    const double y = plot.y + 0.4 * plot.height;
    moveTo(x, y);
    update({Wheel{0, 5}});
    ASSERT_GT(model.plots.view.span, 0);
    ASSERT_LT(model.plots.view.span, 5);
    const PlotView zoomedIn = model.plots.view;
    press(true);
    moveTo(x + 30, y);
    press(false);
    EXPECT_LT(rangeOf(model.plots.view, 10).low, rangeOf(zoomedIn, 10).low) << "the hand pulls it";
    EXPECT_NEAR(model.plots.view.span, zoomedIn.span, 1e-9);
    for (int i = 0; i < 2; ++i) {
        press(true);
        press(false);
    }
    EXPECT_EQ(model.plots.view, PlotView{});
}

TEST_F(InterfaceTest, PlotsAreChosenAndExported) {
    clickOn("plots.choose");
    update({});
    clickOn("plots.energy");
    EXPECT_THAT(model.settings.plots, ElementsAre("frames", "volume", "energy"));
    update({});
    clickOn("plots.frames");
    EXPECT_THAT(model.settings.plots, ElementsAre("volume", "energy"));
    click(kWidth / 2.0, kHeight / 2.0);  // away from the list, which closes it
    update({});
    clickOn("plots.csv");
    clickOn("plots.png");
    ASSERT_EQ(others.size(), 2U);
    EXPECT_FALSE(std::get<ExportPlots>(others[0]).asPicture);
    EXPECT_TRUE(std::get<ExportPlots>(others[1]).asPicture);
    clickOn("plots.hold");
    clickOn("plots.fit");
    EXPECT_THAT(asked, ElementsAre(ActionId::holdPlots, ActionId::fitPlots));
}

TEST_F(InterfaceTest, StrengthsHaveRowsWhileTheBodyTears) {
    clickOn("parameters.more");
    const auto rows = [&] {
        settle();
        std::set<std::string> shown;
        for (const char* name :
             {"tearing", "tensile_strength", "skin_toughness", "skin_tensile_strength"}) {
            if (interface->itemRects().contains(std::string("param.") + name)) {
                shown.insert(name);
            }
        }
        return shown;
    };
    using Rows = std::set<std::string>;
    EXPECT_EQ(rows(), Rows{"tearing"});
    model.parameters.now.skinThickness = 0.002;
    EXPECT_EQ(rows(), Rows{"tearing"});
    model.parameters.now.tearing = 1;
    EXPECT_EQ(rows(),
              (Rows{"tearing", "tensile_strength", "skin_toughness", "skin_tensile_strength"}));
    model.parameters.now.skinThickness = 0;
    EXPECT_EQ(rows(), (Rows{"tearing", "tensile_strength"}));
}

TEST_F(InterfaceTest, AnEdgeIsDraggedAndPutsItsPanelAway) {
    const auto dragEdge = [&](const std::string& name, double to) {
        const Rect edge = interface->itemRects().at(name);
        moveTo(edge.x + edge.width / 2, 300);
        press(true);
        moveTo(to, 300);
        update({});
        press(false);
        update({});
    };
    const double before = interface->itemRects().at("plot.frames").width;
    dragEdge("edge.readings", kWidth - 400.0);
    EXPECT_NEAR(model.settings.readingsWidth, 388, 1);
    EXPECT_GT(interface->itemRects().at("plot.frames").width, before + 50);
    dragEdge("edge.controls", 20);
    EXPECT_FALSE(model.settings.showControls);
    EXPECT_FALSE(interface->itemRects().contains("param.iterations"));
    clickOn("edge.controls.open");
    update({});
    EXPECT_TRUE(model.settings.showControls);
    EXPECT_TRUE(interface->itemRects().contains("param.iterations"));
}

TEST_F(InterfaceTest, BarsDivideThePanels) {
    model.pieces.rows.resize(20, model.pieces.rows[0]);
    settle();
    for (const char* name : {"splitter.pieces", "splitter.plots"}) {
        const Rect bar = interface->itemRects().at(name);
        moveTo(bar.x + bar.width / 2, bar.y + bar.height / 2);
        press(true);
        moveTo(bar.x + bar.width / 2, bar.y - 60);
        press(false);
    }
    EXPECT_GT(model.settings.piecesShare, Settings{}.piecesShare + 0.05);
    EXPECT_LT(model.settings.plotsShare, Settings{}.plotsShare - 0.05);
}

TEST_F(InterfaceTest, AShortListOfPiecesLeavesItsRoomToTheSections) {
    const double one = interface->itemRects().at("splitter.pieces").y;
    model.pieces.rows.resize(20, model.pieces.rows[0]);
    settle();
    EXPECT_LT(interface->itemRects().at("splitter.pieces").y, one - 40);
}

TEST_F(InterfaceTest, NoButtonIsCutOffInASmallWindow) {
    constexpr int kSmallWidth = 800;
    constexpr int kSmallHeight = 600;
    model.help.hint = {"2 pieces now. What next?",
                       {{ActionId::letFall, "Let them fall"},
                        {ActionId::showApart, "Show apart"},
                        {actionOf(ToolKind::grab), "Pull one"}}};
    for (int i = 0; i < 2; ++i) {
        interface->update({}, model, kSmallWidth, kSmallHeight, 1.0 / 60);
    }
    const Layout layout = layoutPanels(kSmallWidth, kSmallHeight, 1, model.settings, true);
    std::size_t buttons = 0;
    for (const auto& [name, rect] : interface->itemRects()) {
        if (name.starts_with("hint.")) {
            ++buttons;
            EXPECT_LE(rect.x + rect.width, layout.view.x + layout.view.width) << name;
            EXPECT_LE(rect.y + rect.height, layout.view.y + layout.view.height) << name;
        } else if (name.starts_with("plots.")) {
            EXPECT_LE(rect.x + rect.width, kSmallWidth - 8) << name;
        }
    }
    EXPECT_EQ(buttons, 3U);
}

// Labels lay over the boxes beside them, and "Light" was cut off.
TEST_F(InterfaceTest, NoSwitchCoversAnotherInANarrowPanel) {
    constexpr float kBar = 20;  // the room of padding and scroll bar
    for (const auto& [width, height] : {std::pair{800, 600}, {kWidth, kHeight}}) {
        model.settings.folded = {"experiments", "model", "tools", "simulation", "cuts"};
        for (int i = 0; i < 3; ++i) {
            interface->update({}, model, width, height, 1.0 / 60);
        }
        const Layout layout = layoutPanels(static_cast<float>(width), static_cast<float>(height), 1,
                                           model.settings, true);
        std::vector<Rect> switches;
        for (const auto& [name, rect] : interface->itemRects()) {
            if (name.starts_with("display.") || name == "window.light") {
                EXPECT_LE(rect.x + rect.width, layout.controls.x + layout.controls.width - kBar)
                    << name;
            }
            if (name.starts_with("display.")) {
                switches.push_back(rect);
            }
        }
        const auto topOf = [&](const char* label) { return interface->itemRects().at(label).y; };
        EXPECT_EQ(topOf("display.Wireframe") == topOf("display.Edge springs"), width == kWidth);
        for (const Rect& a : switches) {
            EXPECT_EQ(std::ranges::count_if(switches,
                                            [&](const Rect& b) {
                                                return a.x < b.x + b.width && b.x < a.x + a.width &&
                                                       a.y < b.y + b.height && b.y < a.y + a.height;
                                            }),
                      1)
                << "itself";
        }
    }
}

// The field showed the unit of the file, beside edge lengths in the scene.
TEST_F(InterfaceTest, TheEdgeOfARemeshIsThatInTheScene) {
    ModelState scaled;
    scaled.placement.scale = 0.2;
    scaled.edge = 0.015;
    model.model.models = {scaled};
    model.settings.folded = {"experiments", "tools", "simulation", "display", "cuts", "window"};
    settle();
    controlClickOn("model.edge");
    type("0.004");
    tap(Key::enter);
    clickOn("model.remesh");
    ASSERT_FALSE(others.empty());
    const auto* remesh = std::get_if<Remesh>(&others.back());
    ASSERT_NE(remesh, nullptr);
    EXPECT_NEAR(remesh->edge, 0.02, 1e-6);
}

TEST_F(InterfaceTest, SectionsFoldAndStayFolded) {
    ASSERT_TRUE(interface->itemRects().contains("param.iterations"));
    clickOn("section.simulation");
    update({});
    EXPECT_FALSE(interface->itemRects().contains("param.iterations"));
    EXPECT_THAT(model.settings.folded, Contains("simulation"));
    clickOn("section.simulation");
    update({});
    EXPECT_TRUE(interface->itemRects().contains("param.iterations"));
}

TEST_F(InterfaceTest, ACardOpensItsExperiment) {
    model.experiments.resize(2);
    model.experiments[0].name = "sphere20";
    model.experiments[1].name = "banana";
    model.experiments[1].ours = RunFigures{60.5, 99.9};
    model.settings.folded = {"model", "tools", "simulation", "display", "cuts"};
    settle();
    clickOn("experiment.banana");
    ASSERT_EQ(others.size(), 1U);
    EXPECT_EQ(std::get<OpenExperiment>(others[0]).name, "banana");
}

TEST_F(InterfaceTest, ThePieceListHighlightsFramesAndHides) {
    model.pieces.rows = {{768, 0.21, 1.0}, {770, 0.20, 0.99}};
    update({});
    const Rect row = interface->itemRects().at("piece.1");
    moveTo(row.x + 0.7 * row.width, row.y + row.height / 2);
    ASSERT_EQ(others.size(), 1U);
    EXPECT_EQ(std::get<HoverPiece>(others[0]).piece, 1);
    press(true);
    press(false);
    ASSERT_EQ(others.size(), 3U);
    EXPECT_EQ(std::get<SelectPiece>(others[1]).piece, 1);
    EXPECT_EQ(std::get<FramePiece>(others[2]).piece, 1);
    EXPECT_FALSE(interface->itemRects().contains("piece.export")) << "none is selected";
    model.pieces.selected = 1;
    update({});
    clickOn("piece.export");
    EXPECT_TRUE(std::holds_alternative<ExportSelectedPiece>(others.back()));
    moveTo(row.x + 0.7 * row.width, row.y + row.height / 2);
    press(true);
    press(false);
    EXPECT_EQ(std::get<SelectPiece>(others.back()).piece, -1) << "a second click ends that";
    others.clear();
    clickOn("eye.0");
    ASSERT_EQ(others.size(), 2U);
    EXPECT_EQ(std::get<HoverPiece>(others[0]).piece, 0);
    EXPECT_EQ(std::get<ShowPiece>(others[1]).piece, 0);
    EXPECT_FALSE(std::get<ShowPiece>(others[1]).visible);
    model.pieces.rows[0].hidden = true;
    update({});
    others.clear();
    clickOn("pieces.show_all");
    EXPECT_TRUE(std::holds_alternative<ShowPiece>(others.back()));
}

TEST_F(InterfaceTest, TheListOfLoadsHighlightsSelectsAndRemoves) {
    EXPECT_FALSE(interface->itemRects().contains("section.loads"));
    model.body.loads.rows = {{"Pin", "fixed", "", 12}, {"Force", "1.5 N", "1.5, 0, 0 N", 8}};
    settle();
    clickOn("load.1");
    ASSERT_EQ(others.size(), 2U);
    EXPECT_EQ(std::get<HoverLoad>(others[0]).load, 1);
    EXPECT_EQ(std::get<SelectLoad>(others[1]).load, 1);
    model.body.loads.selected = 1;
    clickOn("load.1");
    EXPECT_EQ(std::get<SelectLoad>(others.back()).load, -1) << "a second click ends that";
    clickOn("load.remove.0");
    EXPECT_EQ(std::get<RemoveLoad>(others.back()).load, 0);
}

TEST_F(InterfaceTest, AQuestionAsideLeavesTheViewOpenAndTheLegendFree) {
    model.looks.showsFaulty = true;
    model.looks.faults = {{"12 open edges", {213, 94, 0}}, {"3 needles", {230, 159, 0}}};
    model.question = {.title = "This model can't be cut as it is",
                      .text = "broken.obj: 12 open edges. Filling 1 hole would close it.",
                      .choices = {"Fill 1 hole", "Cancel"},
                      .aside = true};
    settle();
    const Rect view = interface->freeView();
    const ItemRects& items = interface->itemRects();
    const Rect choice = items.at("question.0");
    const Rect legend = items.at("fault.1");
    EXPECT_GT(choice.y, view.y + 0.7 * view.height);
    EXPECT_LT(legend.y + legend.height, choice.y);
    EXPECT_LE(legend.x + legend.width, view.x + view.width);
    moveTo(view.x + view.width / 2, view.y + view.height / 3);
    EXPECT_TRUE(interface->pointsBesideQuestion());
    moveTo(choice.x + 3, choice.y + 3);
    EXPECT_FALSE(interface->pointsBesideQuestion());
    moveTo(20, 200);
    EXPECT_FALSE(interface->pointsBesideQuestion()) << "a panel";
    clickOn("question.0");
    ASSERT_EQ(others.size(), 1U);
    EXPECT_EQ(std::get<AnswerQuestion>(others[0]).choice, 0);
    model.question.aside = false;
    settle();
    moveTo(view.x + view.width / 2, view.y + view.height / 8);
    EXPECT_FALSE(interface->pointsBesideQuestion()) << "in the middle it is modal";
}

TEST_F(InterfaceTest, ThemeAndSizeAreChosen) {
    clickOn("section.simulation");  // folded, so that all of the last section is seen
    update({});
    clickOn("section.window");
    update({});
    clickOn("window.light");
    EXPECT_EQ(model.settings.theme, Theme::light);
    clickOn("window.light");
    EXPECT_EQ(model.settings.theme, Theme::dark);
}

TEST_F(InterfaceTest, AnotherScaleMakesEverythingLarger) {
    const double before = interface->itemRects().at("param.iterations").height;
    interface->restyle(Theme::light, 1.5F);
    settle();
    EXPECT_NEAR(interface->itemRects().at("param.iterations").height, 1.5 * before, 2);
}

// The knob stood on the number.
TEST_F(InterfaceTest, TheNumberOfASliderStandsBesideItAtTheRightEnd) {
    update({});
    const ItemRects& items = interface->itemRects();
    double right = 0;
    for (const std::string name : {"param.time_step", "param.iterations", "param.ispc_stiffness"}) {
        const Rect& track = items.at(name);
        const Rect& number = items.at(name + ".number");
        EXPECT_LE(number.y + number.height, track.y + 2) << name;
        right = right == 0 ? number.x + number.width : right;
        EXPECT_NEAR(number.x + number.width, right, 1) << name;
        const Rect& other = items.at("param.gravity.z");
        EXPECT_NEAR(track.x + track.width, other.x + other.width, 2) << name;
    }
}

TEST_F(InterfaceTest, ANumberIsDraggedAndTyped) {
    update({});
    const Rect number = interface->itemRects().at("param.iterations.number");
    const Vec2 middle(number.x + number.width / 2, number.y + number.height / 2);
    const int before = model.parameters.now.iterations;
    moveTo(middle.x(), middle.y());
    press(true);
    moveTo(middle.x() + 20, middle.y());
    press(false);
    EXPECT_GT(model.parameters.now.iterations, before);
    controlClickOn("param.iterations.number");
    type("7");
    tap(Key::enter);
    EXPECT_EQ(model.parameters.now.iterations, 7);
}

// A click did nothing; Ctrl+click alone opened the number, which nobody guesses.
TEST_F(InterfaceTest, ANumberIsTypedAfterOneClickAndChangesOnceItIsAccepted) {
    model.parameters.now.iterations = 35;
    update({});
    clickOn("param.iterations.number");
    type("12");
    EXPECT_EQ(model.parameters.now.iterations, 35);  // what was there is selected, and typed over
    tap(Key::enter);
    EXPECT_EQ(model.parameters.now.iterations, 12);
    clickOn("param.iterations.number");
    type("9");
    tap(Key::escape);
    EXPECT_EQ(model.parameters.now.iterations, 12);
    clickOn("param.iterations.number");
    tap(Key::enter);
    EXPECT_EQ(model.parameters.now.iterations, 12);
}

TEST_F(InterfaceTest, ATypedNumberBeyondItsRangeBecomesTheNearestOne) {
    typeInto("param.iterations.number", "999999");
    EXPECT_EQ(model.parameters.now.iterations, findParam("iterations")->high);
}

TEST_F(InterfaceTest, ACommaIsThePointOfATypedNumber) {
    for (const auto& [text, number] :
         std::map<std::string, double>{{"0,25", 0.25}, {"0", 0}, {"1e-2", 0.01}}) {
        typeInto("param.ispc_stiffness.number", text);
        EXPECT_EQ(model.parameters.now.ispcStiffness, number);
    }
}

TEST_F(InterfaceTest, AUnitIsTypedWithANumberAndOneThatDoesNotFitIsRefused) {
    struct Typed {
        const char* text;
        double time;
        bool refused;
    };
    for (const Typed& typed : {Typed{"3 ms", 0.003, false}, Typed{"3 mm", 0.003, true},
                               Typed{"0.002", 0.002, false}, Typed{"", 0.002, false}}) {
        clickOn("param.time_step.number");
        type(typed.text);
        update({KeyChange{Key::enter, true, {}}});
        update({KeyChange{Key::enter, false, {}}});
        EXPECT_EQ(model.parameters.now.timeStep, typed.time) << typed.text;
        EXPECT_EQ(interface->itemRects().contains("refused.Type a time, such as 0.3 s"),
                  typed.refused)
            << typed.text;
    }
}

TEST_F(InterfaceTest, AQuestionStaysOpenWhereItsNumberIsRefused) {
    model.question = {.title = "Thicken", .text = "How thick?", .choices = {"Thicken", "Cancel"}};
    model.question.number = AskedNumber{"Thickness", "mm", 10, 1, 23};
    settle();
    typeInto("question.number", "5 kg");
    EXPECT_TRUE(others.empty());
    typeInto("question.number", "0.5 cm");
    ASSERT_FALSE(others.empty());
    EXPECT_EQ(std::get<AnswerQuestion>(others[0]).number, 5);
}

TEST_F(InterfaceTest, TabGoesOnToTheNextNumber) {
    clickOn("param.gravity.number");
    type("1");
    tap(Key::tab);
    update({});
    type("2");
    tap(Key::enter);
    EXPECT_EQ(model.parameters.now.gravity.x(), 1);
    EXPECT_EQ(model.parameters.now.gravity.y(), 2);
}

TEST_F(InterfaceTest, ANumberOfABoxIsTypedAfterOneClick) {
    model.body.boxes = {{}};
    update({});
    clickOn("tab.Boxes");
    update({});
    clickOn("box.0");
    update({});
    clickOn("box.0.Rotate");
    type("45");
    others.clear();
    tap(Key::enter);
    ASSERT_EQ(others.size(), 1U);
    EXPECT_EQ(std::get<ChangeBox>(others[0]).box.rotate, Vec3(0, 45, 0));
}

TEST_F(InterfaceTest, TheTimeLineTakesTheWholeWidthBelowTheView) {
    model.session.playback.step = 10;
    model.session.playback.steps = 100;
    model.session.past = {{1, 20, SessionMark::Kind::stroke, "Stroke"}};
    settle();
    const Rect bar = interface->itemRects().at("scrubber");
    EXPECT_GT(bar.width, 0.8 * kWidth);
    EXPECT_LT(interface->freeView().y + interface->freeView().height, bar.y);
    const Rect strip = interface->itemRects().at("timeline.marks");
    EXPECT_NEAR(strip.x, bar.x, 1);
    EXPECT_NEAR(strip.width, bar.width, 1);
    EXPECT_LE(strip.y + strip.height, bar.y + 1);
}

TEST_F(InterfaceTest, WorkIsGivenUpOnlyWhereItMayEnd) {
    model.work = {.title = "Opening ball.ply", .stage = "Reading", .seconds = 1};
    update({});
    clickOn("work.cancel");
    EXPECT_TRUE(std::ranges::any_of(
        others, [](const Action& a) { return std::holds_alternative<CancelWork>(a); }));
    model.work.mayEnd = false;
    update({});
    EXPECT_FALSE(interface->itemRects().contains("work.cancel"));
}

/// A stroke may begin under the box.
TEST_F(InterfaceTest, TheBoxOfWorkTakesPressesOnItsButtonAlone) {
    model.work = {.title = "Cutting", .stage = "Step 3 of 60", .done = 3, .all = 60};
    settle();
    const Rect button = interface->itemRects().at("work.cancel");
    moveTo(button.x + button.width / 2, button.y + button.height / 2);
    EXPECT_TRUE(interface->ownsPointer());
    for (const double beside : {20.0, 100.0, 200.0}) {
        moveTo(button.x - beside, button.y + button.height / 2);
        EXPECT_FALSE(interface->ownsPointer()) << beside;
        moveTo(button.x - beside, button.y - 10);
        EXPECT_FALSE(interface->ownsPointer()) << beside;
    }
}

// Dear ImGui's own lines end behind each dot: "1.41 cm to 2." and "65 cm".
TEST_F(InterfaceTest, LinesEndInNoNumberAndNotBeforeItsUnit) {
    update({});
    const std::string text = "edge length 1.41 cm to 2.65 cm, mean 0.000519 mg";
    for (float width = 100; width < 400; width += 7) {
        const std::string lines = wrapped(text, width);
        std::string whole = lines;
        std::erase(whole, '\n');
        EXPECT_EQ(whole, text);
        for (const char* kept : {"1.41 cm", "2.65 cm", "0.000519 mg"}) {
            EXPECT_THAT(lines, HasSubstr(kept)) << width;
        }
    }
    const std::string path = "/home/someone/a-folder-with-a-very-long-name/file.kerf.json";
    EXPECT_GT(std::ranges::count(wrapped(path, 100), '\n'), 2) << "no word is wider than the line";
}

TEST_F(InterfaceTest, APopupOpensBelowItsButton) {
    clickOn("plots.choose");
    settle();
    const Rect button = interface->itemRects().at("plots.choose");
    EXPECT_GE(interface->itemRects().at("plots.frames").y, button.y + button.height);
}

TEST_F(InterfaceTest, AClickOnATitleOfThePiecesSortsThem) {
    model.pieces.rows = {{100, 1, 1.0}, {300, 3, 1.0}, {200, 2, 1.0}};
    model.settings.piecesShare = 0.6;  // room for all three
    settle();
    const auto top = [this](int piece) {
        return interface->itemRects().at("piece." + std::to_string(piece)).y;
    };
    EXPECT_LT(top(0), top(1));
    clickOn("pieces.by.volume");
    update({});
    EXPECT_LT(top(0), top(2));
    EXPECT_LT(top(2), top(1));
    clickOn("pieces.by.volume");
    update({});
    EXPECT_LT(top(1), top(2));
    EXPECT_LT(top(2), top(0));
}

TEST_F(InterfaceTest, ThePointerOverAPlotShowsItsTimeInTheOthers) {
    for (int step = 0; step < 50; ++step) {
        for (int r = 0; r < int(Reading::pointStrain); ++r) {  // no point is plotted
            history[static_cast<Reading>(r)].add(0.01 * step, 1 + step % 7);
        }
    }
    model.transport.time = 0.5;
    update({});
    const gpu::Framebuffer picture(GL_RGBA8, GL_DEPTH_COMPONENT24, kWidth, kHeight);
    const auto drawn = [&] {
        picture.bind();
        glClear(GL_COLOR_BUFFER_BIT);
        interface->draw(picture);
        return picture.readColor();
    };
    std::vector<Rect> plots;
    for (const auto& [name, rect] : interface->itemRects()) {
        if (name.starts_with("plot.")) {
            plots.push_back(rect);
        }
    }
    ASSERT_GE(plots.size(), 2U);
    moveTo(2, kHeight - 200);
    update({});
    const std::vector<std::uint8_t> before = drawn();
    moveTo(plots[0].x + 0.6 * plots[0].width, plots[0].y + 0.4 * plots[0].height);
    update({});
    const std::vector<std::uint8_t> after = drawn();
    const Rect& other = plots[1];
    const int row = static_cast<int>(other.y + 0.5 * other.height);
    long moved = 0;
    for (int x = static_cast<int>(other.x); x < static_cast<int>(other.x + other.width); ++x) {
        const std::size_t at = 4 * (std::size_t(row) * kWidth + std::size_t(x));
        moved += before[at] != after[at] ? 1 : 0;
    }
    EXPECT_GT(moved, 0) << "its line is there";
    EXPECT_LT(moved, other.width / 2) << "and the rest as before";
}

class CommandBoxTest : public InterfaceTest {
  protected:
    void SetUp() override {
        InterfaceTest::SetUp();
        model.settings.folded.emplace_back("simulation");
        model.help.samples = std::make_shared<const std::vector<StartCard>>(
            std::vector<StartCard>{{"liver", "Liver", "Incise it."}, {"egg", "Hollow egg", ""}});
        settle();
        asked.clear();
    }
    bool finds(const std::string& name) const {
        return interface->itemRects().contains("command." + name);
    }
    void close() {
        model.help.samples = nullptr;
        for (int n = 0; n < 5; ++n) {
            update({});
        }
    }
};

TEST_F(CommandBoxTest, WordsInAnyOrderFindAnActionAndEnterDoesIt) {
    EXPECT_TRUE(interface->ownsKeyboard());
    EXPECT_TRUE(finds("Wireframe"));
    type("FRAME wire");
    EXPECT_TRUE(finds("Wireframe"));
    EXPECT_FALSE(finds("Frame model"));
    update({KeyChange{Key::enter, true, {}}});
    EXPECT_EQ(asked, (std::vector{ActionId::findCommand, ActionId::wireframe}));
    close();
    EXPECT_FALSE(interface->ownsKeyboard());
}

TEST_F(CommandBoxTest, ArrowsAndClicksChooseAndEscDoesNothingElse) {
    type("view");
    tap(Key::down);
    tap(Key::enter);
    ASSERT_EQ(asked.size(), 2U);
    const ActionId second = asked[1];
    tap(Key::up);
    tap(Key::enter);
    ASSERT_EQ(asked.size(), 4U);
    EXPECT_LT(asked[3], second);
    clickOn("command.Left view");
    EXPECT_EQ(asked.back(), ActionId::viewLeft);
    asked.clear();
    tap(Key::escape);
    EXPECT_EQ(asked, std::vector{ActionId::findCommand});
    EXPECT_TRUE(others.empty() && changed.empty());
}

TEST_F(CommandBoxTest, WhatCanNotBeDoneIsShownAndDoesNothing) {
    type("undo");
    EXPECT_TRUE(finds("Undo"));
    tap(Key::enter);
    clickOn("command.Undo");
    EXPECT_TRUE(asked.empty());
    model.changes.recallable = true;
    tap(Key::enter);
    EXPECT_EQ(asked, (std::vector{ActionId::findCommand, ActionId::undo}));
}

TEST_F(CommandBoxTest, AParameterIsUnfoldedAndItsNumberTyped) {
    EXPECT_FALSE(interface->itemRects().contains("param.youngs_modulus"));
    type("modulus young");
    tap(Key::enter);
    close();
    EXPECT_TRUE(interface->itemRects().contains("param.youngs_modulus"));
    type("2 kPa");
    tap(Key::enter);
    EXPECT_EQ(model.parameters.now.youngsModulus, 2000);
}

TEST_F(CommandBoxTest, AnActionIsGivenOtherKeysThatNoneHas) {
    const auto press = [&](Key key, Modifiers with) {
        update({KeyChange{key, true, with}});
        update({KeyChange{key, false, with}});
    };
    type("remesh to");
    press(Key::f2, {});
    press(Key::s, {.control = true});
    EXPECT_TRUE(model.settings.keys.empty()) << "Save has it";
    press(Key::m, {.shift = true, .control = true});
    EXPECT_EQ(model.settings.keys["Remesh to about 5,000 triangles"], "Ctrl+Shift+M");
    press(Key::f2, {});
    tap(Key::backspace);
    EXPECT_TRUE(model.settings.keys.empty());
}

TEST_F(CommandBoxTest, ASampleIsOpened) {
    type("egg");
    tap(Key::enter);
    ASSERT_EQ(others.size(), 1U);
    EXPECT_EQ(std::get<OpenStartScene>(others[0]).card, 1U);
}

}  // namespace
}  // namespace kerf::ui
