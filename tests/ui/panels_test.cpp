#include "ui/panels/panels.h"

#include "sim/body/body_model.h"
#include "tests/support/shapes.h"
#include "ui/base/layout.h"
#include "ui/over_view.h"
#include "ui/plots/history.h"
#include "ui/state/action_table.h"
#include "ui/state/panel_model.h"
#include "ui/state/piece_row.h"

namespace kerf::ui {
namespace {

// So no key stands twice.
TEST(ActionTable, EveryRowIsFoundByItsKeys) {
    for (const ActionRow& row : actionTable()) {
        if (row.shortcut.key != Key::none) {
            EXPECT_EQ(findAction(row.shortcut.key, row.shortcut.modifiers), row.id) << row.label;
        }
        if (row.second.key != Key::none) {
            EXPECT_EQ(findAction(row.second.key, row.second.modifiers), row.id) << row.label;
        }
    }
}

TEST(ActionTable, EveryActionHasARowThatSaysWhatItDoes) {
    for (const ActionRow& row : actionTable()) {
        EXPECT_EQ(row.shortcut.text.empty(), row.shortcut.key == Key::none) << row.label;
        EXPECT_EQ(row.second.text.empty(), row.second.key == Key::none) << row.label;
        EXPECT_FALSE(row.label.empty());
        EXPECT_FALSE(row.group.empty());
    }
    for (int id = 0; id < static_cast<int>(ActionId::count); ++id) {
        EXPECT_EQ(static_cast<int>(rowOf(static_cast<ActionId>(id)).id), id);
    }
}

TEST(ActionTable, RowsOfAMenuStandTogether) {
    std::vector<std::string_view> groups;
    for (const ActionRow& row : actionTable()) {
        if (groups.empty() || groups.back() != row.group) {
            groups.push_back(row.group);
        }
    }
    EXPECT_EQ(groups,
              (std::vector<std::string_view>{"File", "Edit", "Tool", "Time", "View", "Help"}));
}

TEST(ActionTable, RowsFollowTheModel) {
    PanelModel model;
    for (const ActionId id : {ActionId::openFile, ActionId::screenshot, ActionId::togglePanels,
                              ActionId::help, ActionId::quit}) {
        EXPECT_TRUE(isAvailable(model, id)) << "with nothing open: " << rowOf(id).label;
    }
    EXPECT_FALSE(isAvailable(model, ActionId::playPause));
    model.name = "ball";
    std::vector<ActionId> unavailable;
    for (const ActionRow& row : actionTable()) {
        if (!isAvailable(model, row.id)) {
            unavailable.push_back(row.id);
        }
    }
    EXPECT_EQ(unavailable, (std::vector{ActionId::undo, ActionId::redo, ActionId::remeshCoarser,
                                        ActionId::partModel, ActionId::deleteSelected,
                                        ActionId::bringDown, ActionId::freePins,
                                        ActionId::finishTry, ActionId::loop, ActionId::showApart}));
    EXPECT_TRUE(isOn(model, actionOf(ToolKind::stroke)));
    EXPECT_FALSE(isOn(model, actionOf(ToolKind::pin)));
    EXPECT_FALSE(isOn(model, ActionId::quit)) << "it switches nothing";
    model.display.overlays.ispcs = true;
    EXPECT_TRUE(isOn(model, ActionId::showIspcs));
    EXPECT_FALSE(isOn(model, ActionId::showEdges));
}

TEST(ActionTable, OtherKeysAndModifiersAreFree) {
    EXPECT_EQ(findAction(Key::none, {}), std::nullopt);
    EXPECT_EQ(findAction(Key::space, {.control = true}), std::nullopt);
}

TEST(ActionTable, KeysOfTheUserReplaceAnActionsOwn) {
    EXPECT_EQ(shortcutOf("Ctrl+Shift+F12")->key, Key::f12);
    EXPECT_EQ(shortcutOf("7")->key, Key::digit7);
    for (const char* wrong : {"", "Ctrl+", "Shift+Ctrl+A", "F13", "a", "Space"}) {
        EXPECT_FALSE(shortcutOf(wrong)) << wrong;
    }
    takeKeys({{"Remesh", "Ctrl+S"}, {"Save", "F7"}, {"Wireframe", "T"}, {"Gone", "G"}});
    EXPECT_EQ(findAction(Key::s, {.control = true}), ActionId::remesh) << "which Save gave up";
    EXPECT_EQ(findAction(Key::f7, {}), ActionId::saveSession);
    EXPECT_EQ(findAction(Key::t, {}), ActionId::showCutLines) << "as it was";
    EXPECT_EQ(keysOf(ActionId::remesh), "Ctrl+S");
    takeKeys({});
    EXPECT_EQ(findAction(Key::s, {.control = true}), ActionId::saveSession);
}

TEST(ActionTable, TheDocsHaveTheSame) {
    EXPECT_NE(readBytes(KERF_SOURCE_DIR "/docs/editor.md").find(actionsAsMarkdown()),
              std::string::npos)
        << "docs/editor.md needs this table:\n"
        << actionsAsMarkdown();
}

TEST(ActionTable, TheKeysThatPeopleKnow) {
    EXPECT_EQ(findAction(Key::space, {}), ActionId::playPause);
    EXPECT_EQ(findAction(Key::period, {}), ActionId::stepOnce);
    EXPECT_EQ(findAction(Key::r, {}), ActionId::reset);
    EXPECT_EQ(findAction(Key::f1, {}), ActionId::help);
    EXPECT_EQ(findAction(Key::f12, {}), ActionId::screenshot);
    EXPECT_EQ(findAction(Key::f12, {.control = true}), ActionId::sceneScreenshot);
    EXPECT_EQ(describeAction(ActionId::playPause), "Play or pause (Space)");
}

PieceRow row(int triangles, double volume) {
    PieceRow piece;
    piece.triangles = triangles;
    piece.volume = volume;
    return piece;
}

TEST(SortedPieces, AreSortedByAColumnBothWaysAndKeepEqualOnesInOrder) {
    const std::vector<PieceRow> rows{row(10, 3), row(30, 1), row(10, 2)};
    EXPECT_THAT(sortedPieces(rows, PieceColumn::number, false), ElementsAre(0, 1, 2));
    EXPECT_THAT(sortedPieces(rows, PieceColumn::number, true), ElementsAre(2, 1, 0));
    EXPECT_THAT(sortedPieces(rows, PieceColumn::volume, false), ElementsAre(1, 2, 0));
    EXPECT_THAT(sortedPieces(rows, PieceColumn::volume, true), ElementsAre(0, 2, 1));
    EXPECT_THAT(sortedPieces(rows, PieceColumn::triangles, false), ElementsAre(0, 2, 1));
}

TEST(SortedPieces, PutThoseWithoutSumsFirst) {
    std::vector<PieceRow> rows{row(1, 1), row(1, 1)};
    rows[0].sums = PieceSums{2, 1, Vec3::Zero()};
    EXPECT_THAT(sortedPieces(rows, PieceColumn::area, false), ElementsAre(1, 0));
}

TEST(PiecesAsCsv, HaveARowEachAndLeaveWhatIsNotKnownEmpty) {
    std::vector<PieceRow> rows{row(12, 0.5), row(20, 0.25)};
    rows[0].share = 1;
    rows[0].shareOfAll = 2.0 / 3;
    rows[0].sums = PieceSums{3, 0.5, Vec3(1, 2, 3)};
    rows[0].bounds = {Vec3(0, 0, 0), Vec3(1, 1, 2)};
    EXPECT_EQ(piecesAsCsv(rows),
              "piece,triangles,volume_m3,share_of_rest,share_of_all,skin_area_m2,cut_area_m2,"
              "centre_x,centre_y,centre_z,low_x,low_y,low_z,high_x,high_y,high_z\n"
              "1,12,0.5,1,0.666666667,3,0.5,1,2,3,0,0,0,1,1,2\n"
              "2,20,0.25,0,0,,,,,,,,,,,\n");
}

std::string shown(std::string_view name, double value) {
    char text[64];
    std::snprintf(text, sizeof text, sliderFormat(*findParam(name)).c_str(), value);
    return text;
}

TEST(SliderFormat, ShowsTheUnitAndDecimalsThatSuitTheRange) {
    EXPECT_EQ(shown("time_step", 0.005), "0.0050 s");
    EXPECT_EQ(shown("ispc_stiffness", 0.5), "0.50");
    EXPECT_EQ(shown("gravity", -9.81), "-9.81 m/s\u00b2");
    EXPECT_EQ(shown("youngs_modulus", 1e5), "100000 Pa");
    EXPECT_EQ(sliderFormat(*findParam("iterations")), "%d");
}

TEST(SliderFormat, LosesNothingOfTheSmallestValue) {
    for (const ParamInfo& info : paramTable()) {
        if (info.type != ParamType::real || info.low <= 0) {
            continue;
        }
        // What a slider writes back is what it shows: the lower end has to survive that.
        EXPECT_NEAR(std::atof(shown(info.name, info.low).c_str()), info.low, 0.5 * info.low)
            << info.name;
        EXPECT_GT(std::atof(shown(info.name, info.low).c_str()), 0) << info.name;
    }
}

TEST(RemarkOn, WhatAStepIsMadeOf) {
    ParametersState parameters;
    const ParamInfo& iterations = *findParam("iterations");
    EXPECT_EQ(remarkOn(iterations, parameters), "") << "nothing is open";
    parameters.implicitSteps = 2;
    parameters.iterations = 6;
    EXPECT_EQ(remarkOn(iterations, parameters), "2 implicit steps of 2.5 ms, 6 iterations");
    EXPECT_EQ(remarkOn(*findParam("time_step"), parameters), "");
    parameters.implicitSteps = 1;
    EXPECT_EQ(partsOfStep(parameters), "1 implicit step of 5 ms, 6 iterations");
    parameters.residual = 0.0213;
    EXPECT_EQ(partsOfStep(parameters), "1 implicit step of 5 ms, 6 iterations (left: 2 %)");
    parameters.residual.reset();
    parameters.now.solver = SolverMode::pbd;
    EXPECT_EQ(partsOfStep(parameters), "6 iterations");
    EXPECT_EQ(remarkOn(iterations, parameters), "");
}

TEST(StatusText, CountsPiecesThatWereTakenBackWhereAnyWere) {
    History history;
    PanelModel model;
    model.plots.history = &history;
    EXPECT_EQ(statusText(model), "No file open");
    model.name = "sphere80";
    model.pieces.rows.resize(2);
    EXPECT_NE(statusText(model).find("2 pieces   |"), std::string::npos) << statusText(model);
    history[Reading::lostPieces].add(0.5, 3);
    EXPECT_NE(statusText(model).find("2 pieces, 3 reset   |"), std::string::npos)
        << statusText(model);
}

bool overlap(const Rect& a, const Rect& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
           b.y < a.y + a.height;
}

class LayoutTest : public ::testing::TestWithParam<std::array<float, 3>> {
  protected:
    float width() const { return GetParam()[0]; }
    float height() const { return GetParam()[1]; }
    Layout layout() const { return layoutPanels(width(), height(), GetParam()[2]); }
};

TEST_P(LayoutTest, PanelsDoNotOverlapAndTheFreeViewHasTheMiddleOfThePicture) {
    const Layout l = layout();
    EXPECT_FALSE(overlap(l.controls, l.plots));
    EXPECT_FALSE(overlap(l.controls, l.status));
    EXPECT_FALSE(overlap(l.plots, l.status));
    EXPECT_FALSE(overlap(l.view, l.controls));
    EXPECT_FALSE(overlap(l.view, l.plots));
    EXPECT_NEAR(l.view.x + l.view.width / 2, width() / 2, 1e-3);
    EXPECT_GE(l.view.width, width() / 4);
}

TEST_P(LayoutTest, APanelThatIsPutAwayLeavesItsPlaceToTheView) {
    Settings settings;
    settings.showControls = false;
    const Layout l = layoutPanels(width(), height(), GetParam()[2], settings);
    EXPECT_EQ(l.controls.width, 0);
    EXPECT_GT(l.view.width, layout().view.width);
    EXPECT_FALSE(overlap(l.view, l.plots));
}

TEST_P(LayoutTest, WidthsFollowTheSettings) {
    Settings settings;
    settings.readingsWidth = 250;
    const Layout l = layoutPanels(width(), height(), GetParam()[2], settings);
    EXPECT_LE(l.plots.width, 250 * GetParam()[2]);
    EXPECT_GE(l.view.width, width() / 4);
}

TEST(LargestScale, LeavesThePanelsTheirRoom) {
    EXPECT_EQ(largestScale(1280, 720), 2);
    EXPECT_EQ(largestScale(1500, 720), 2);
    EXPECT_EQ(largestScale(1000, 2000), 1.5F);
    EXPECT_EQ(largestScale(1, 1), kLeastScale);
}

INSTANTIATE_TEST_SUITE_P(Sizes, LayoutTest,
                         ::testing::Values(std::array{1280.0F, 720.0F, 1.0F},
                                           std::array{2560.0F, 1440.0F, 2.0F},
                                           std::array{640.0F, 360.0F, 1.0F},
                                           std::array{800.0F, 600.0F, 2.0F}));

}  // namespace
}  // namespace kerf::ui
