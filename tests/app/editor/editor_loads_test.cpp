// The list of supports and loads, and the selected piece, in the whole editor without a window.

#include "app/scene/readout/scene_readout.h"
#include "app/tools/view_frame.h"

namespace kerf::app {
namespace {

class EditorLoadsTest : public EditorTest {
  protected:
    EditorOptions options() override {
        EditorOptions options = EditorTest::options();
        options.width = 1280;
        options.height = 1000;
        return options;
    }
    EditorScene& scene() { return *editor->scene(); }
    Simulation& simulation() { return scene().simulation(); }
    void execute(const Command& command) {
        ASSERT_EQ(scene().execute(command), "");
        frames(1);
    }
    const std::vector<ui::LoadRow>& rows() const { return panels().body.loads.rows; }
    std::vector<std::string> kinds() const {
        std::vector<std::string> kinds;
        for (const ui::LoadRow& row : rows()) {
            kinds.emplace_back(row.kind);
        }
        return kinds;
    }
    Vec3 placeOf(int row) {
        const std::uint32_t v = scene().readout().loads().at(row).vertices.front();
        return simulation().mesh().position(static_cast<int>(v));
    }
    /// Selects with this button what is drawn at a place, by the camera of the document.
    int clickAt(const Vec3& place, Button button) {
        const ui::Rect view = ui::layoutPanels(1280, 1000, 1, {}, true).view;
        const auto at = ViewFrame{document().camera, 1280, 1000}.toPixel(place);
        moveTo(at->x + view.x + view.width / 2 - 640, at->y + view.y + view.height / 2 - 500, 2);
        press(true, button);
        press(false, button);
        settle();
        return panels().body.loads.selected;
    }
    void remove(int row) {
        click("load.remove." + std::to_string(row));
        settle();
    }
    /// A cap that moves, out of the middle of one that is fixed: boxes about the one hold the
    /// other.
    void pinRingAndMiddle() {
        const Vec3 corner = Vec3::Constant(0.29);
        execute(Pin{Ball{corner, 0.35}});
        execute(Pin{.region = Ball{corner, 0.2}, .velocity = Vec3(0, 0.5, 0), .seconds = 0.1});
    }
    void saveAndReplay() {
        saveByKeys();
        expectReplayed(readSession(onlyFile(folder.path())), sphereDocument().mesh);
    }
};

TEST_F(EditorLoadsTest, WhatHoldsOrPullsHasARowWithItsValue) {
    EXPECT_FALSE(editor->itemRects().contains("section.loads")) << "there is nothing to list";
    execute(Pin{Ball{{-0.5, 0, 0}, 0.2}});
    execute(Pin{Ball{{0.5, 0, 0}, 0.2}});
    execute(Pin{.region = Ball{{0, 0.5, 0}, 0.2}, .velocity = Vec3(0, 0.5, 0), .seconds = 0.1});
    execute(ApplyForce{Ball{{0, -0.5, 0}, 0.2}, Vec3(3, 0, 4)});
    execute(Grab{7, Vec3(0, 0, 0.5), 0.2});
    execute(Grab{50, Vec3(-0.2, 0, -0.5), 0.15});
    execute(Grab{51, Vec3(0.2, 0, -0.5), 0.15});
    playFor(30);
    EXPECT_THAT(kinds(), ElementsAre("Pin", "Pin", "Motion", "Force", "Hand", "Retractor"));
    EXPECT_EQ(rows()[0].vertices + rows()[1].vertices + rows()[2].vertices,
              simulation().pinnedVertices().size());
    EXPECT_EQ(rows()[0].value, "fixed");
    EXPECT_EQ(rows()[2].value, "5 cm");
    EXPECT_THAT(rows()[2].detail, HasSubstr("0, 0.5, 0 m/s"));
    EXPECT_EQ(rows()[3].value, "5 N");
    EXPECT_THAT(rows()[3].detail, HasSubstr("3, 0, 4 N"));
    EXPECT_THAT(rows()[4].detail, HasSubstr("0, 0, 0.5 m"));
    EXPECT_EQ(rows()[5].value, "40 cm");
    EXPECT_EQ(rows()[5].vertices,
              simulation().hands()[1].held.size() + simulation().hands()[2].held.size());
}

TEST_F(EditorLoadsTest, APinIsRemovedAloneFromAroundAMotion) {
    pinRingAndMiddle();
    const std::vector<std::uint32_t> moving = simulation().motions().at(0).held.vertices();
    const std::vector<std::uint32_t> all = simulation().pinnedVertices();
    playFor(5);
    ASSERT_THAT(kinds(), ElementsAre("Pin", "Motion"));
    remove(0);
    EXPECT_EQ(simulation().pinnedVertices(), moving);
    EXPECT_THAT(kinds(), ElementsAre("Motion"));
    undo();
    EXPECT_EQ(simulation().pinnedVertices(), all) << "one undo brings it back";
    remove(1);
    EXPECT_THAT(kinds(), ElementsAre("Pin"));
    EXPECT_EQ(simulation().pinnedVertices().size(), all.size() - moving.size());
    playFor(5);
    saveAndReplay();
}

TEST_F(EditorLoadsTest, ForcesOnTheSameVerticesAreOneRowAndGoTogether) {
    execute(ApplyForce{Ball{{0.5, 0, 0}, 0.2}, Vec3(1, 0, 0)});
    execute(ApplyForce{Ball{{-0.5, 0, 0}, 0.2}, Vec3(0, 2, 0)});
    execute(ApplyForce{Ball{{0.5, 0, 0}, 0.1}, Vec3(4, 0, 0)});
    ASSERT_EQ(rows().size(), 2U);
    EXPECT_EQ(rows()[1].value, "5 N");
    remove(1);
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_EQ(rows()[0].detail, "On all of its vertices together: 0, 2, 0 N");
    undo();
    EXPECT_EQ(simulation().forces().size(), 3U);
}

TEST_F(EditorLoadsTest, HandsLetGoAndARetractorGoesWithBothHooks) {
    execute(Grab{7, Vec3(0, 0, 0.5), 0.2});
    execute(Grab{50, Vec3(-0.2, 0, -0.5), 0.15});
    execute(Grab{51, Vec3(0.2, 0, -0.5), 0.15});
    playFor(3);
    ASSERT_THAT(kinds(), ElementsAre("Hand", "Retractor"));
    remove(1);
    EXPECT_THAT(kinds(), ElementsAre("Hand"));
    remove(0);
    EXPECT_TRUE(simulation().hands().empty());
    EXPECT_TRUE(rows().empty());
    saveAndReplay();
}

TEST_F(EditorLoadsTest, ARowIsHighlightedUnderThePointerAndOnceItIsClicked) {
    execute(Pin{Ball{{0, 0, 0.5}, 0.2}});
    frames(2);
    moveTo(kWidth / 2.0, 5, 2);
    const std::vector<std::uint8_t> plain = viewPixels(editor->readPicture());
    const ui::Rect item = editor->itemRects().at("load.0");
    moveTo(item.x + 20, item.y + item.height / 2, 3);
    EXPECT_EQ(panels().body.loads.hovered, 0);
    const std::vector<std::uint8_t> hovered = viewPixels(editor->readPicture());
    EXPECT_NE(hovered, plain);
    click("load.0");
    moveTo(kWidth / 2.0, 5, 3);
    EXPECT_EQ(panels().body.loads.hovered, -1);
    EXPECT_EQ(panels().body.loads.selected, 0);
    EXPECT_EQ(viewPixels(editor->readPicture()), hovered);
    click("load.0");
    moveTo(kWidth / 2.0, 5, 3);
    EXPECT_EQ(viewPixels(editor->readPicture()), plain) << "another click ends that";
    click("load.0");
    execute(Pin{Ball{{0, 0.5, 0}, 0.1}});
    frames(2);
    const int row = panels().body.loads.selected;
    ASSERT_GE(row, 0);
    EXPECT_NEAR(placeOf(row).z(), 0.5, 0.1) << "it stays on that pin";
    remove(1 - row);
    EXPECT_EQ(panels().body.loads.selected, 0);
    remove(0);
    EXPECT_EQ(panels().body.loads.selected, -1);
}

TEST_F(EditorLoadsTest, AClickOnAMarkSelectsItsRow) {
    execute(Pin{Ball{{-0.3, 0, 0.4}, 0.1}});
    execute(ApplyForce{Ball{{0.3, 0, 0.4}, 0.1}, Vec3(1, 0, 0)});
    execute(Grab{50, Vec3(0, 0.35, 0.35), 0.1});
    execute(Pin{.region = Ball{{0, -0.35, -0.35}, 0.1}, .velocity = Vec3(0, 0.1, 0)});
    ASSERT_THAT(kinds(), ElementsAre("Pin", "Motion", "Force", "Retractor"));
    const std::vector<std::uint8_t> plain = viewPixels(editor->readPicture());
    EXPECT_EQ(clickAt(placeOf(0), Button::right), 0);
    EXPECT_NE(viewPixels(editor->readPicture()), plain);
    EXPECT_EQ(clickAt(placeOf(2), Button::right), 2);
    EXPECT_EQ(clickAt({0, 0.35, 0.35}, Button::right), 3);
    EXPECT_EQ(clickAt(placeOf(1), Button::right), -1) << "the body is before it";
    tap(Key::u);
    EXPECT_EQ(clickAt(placeOf(0), Button::left), 0);
    EXPECT_EQ(clickAt({0, 0, 0.5}, Button::left), -1) << "there is none";
    EXPECT_EQ(clickAt(placeOf(2), Button::left), 2);
    tap(Key::del);
    settle();
    EXPECT_THAT(kinds(), ElementsAre("Pin", "Motion", "Retractor"));
    EXPECT_EQ(simulation().report().pieces, 1);
}

TEST_F(EditorLoadsTest, MarksAreMadeAnewOnlyWhenTheyChange) {
    execute(Pin{Ball{{-0.3, 0, 0.4}, 0.1}});
    execute(Pin{Ball{{0.3, 0, 0.4}, 0.1}});
    SceneReadout& readout = scene().readout();
    EXPECT_EQ(readout.marks(false, -1), nullptr);
    const auto first = readout.marks(false, 0);
    playFor(2);
    EXPECT_EQ(readout.marks(false, 0), first);
    EXPECT_NE(readout.marks(false, 1), first);
}

class EditorPieceTest : public EditorLoadsTest {
  protected:
    void SetUp() override {
        EditorLoadsTest::SetUp();
        frames(1);
        dragAndSettle({740, 20}, {740, 900}, 10);  // the right part is smaller
        ASSERT_EQ(simulation().report().pieces, 2);
    }
    std::vector<std::uint8_t> pixels() {
        moveTo(kWidth / 2.0, 5, 3);
        return viewPixels(editor->readPicture());
    }
};

TEST_F(EditorPieceTest, AClickSelectsAPieceAndAnotherEndsThat) {
    const std::vector<std::uint8_t> plain = pixels();
    click("piece.1");
    settle();
    EXPECT_EQ(panels().pieces.selected, 1);
    EXPECT_NE(pixels(), plain) << "a box is around it";
    click("piece.1");
    EXPECT_EQ(panels().pieces.selected, -1);
}

TEST_F(EditorPieceTest, ItIsDeletedRecordedUndoneAndRedone) {
    const std::string whole = simulation().stateHash();
    const int triangles = panels().pieces.rows[0].triangles;
    click("eye.0");
    click("piece.1");
    settle();
    tap(Key::del);
    settle();
    ASSERT_EQ(panels().pieces.rows.size(), 1U);
    EXPECT_EQ(panels().pieces.rows[0].triangles, triangles);
    EXPECT_TRUE(panels().pieces.rows[0].hidden);
    EXPECT_EQ(panels().pieces.selected, -1);
    EXPECT_EQ(panels().session.past.back().text, "Piece 2 deleted");
    const std::string left = simulation().stateHash();
    undo();
    EXPECT_EQ(simulation().stateHash(), whole);
    ASSERT_EQ(panels().pieces.rows.size(), 2U);
    EXPECT_TRUE(panels().pieces.rows[0].hidden);
    tap(Key::z, {.shift = true, .control = true});
    settle();
    EXPECT_EQ(simulation().stateHash(), left);
    playFor(3);
    saveAndReplay();
}

TEST_F(EditorPieceTest, WhatWasHiddenStaysSoWhenOneBeforeItGoes) {
    click("eye.1");
    click("piece.0");
    settle();
    click("piece.delete");
    settle();
    ASSERT_EQ(panels().pieces.rows.size(), 1U);
    EXPECT_TRUE(panels().pieces.rows[0].hidden);
    undo();
    ASSERT_EQ(panels().pieces.rows.size(), 2U);
    EXPECT_FALSE(panels().pieces.rows[0].hidden);
    EXPECT_TRUE(panels().pieces.rows[1].hidden);
    execute(RemovePiece{0});
    const std::size_t marks = panels().session.past.size();
    EXPECT_EQ(scene().execute(RemovePiece{0}), "This is the only piece; a scene keeps one.");
    frames(1);
    EXPECT_EQ(panels().session.past.size(), marks) << "a refusal is not recorded";
}

TEST_F(EditorPieceTest, AColourIsOfTheViewAlone) {
    const std::string before = simulation().stateHash();
    const std::size_t changes = panels().changes.done;
    click("piece.1");
    settle();
    const std::vector<std::uint8_t> plain = pixels();
    click("color.##piece");
    frames(3);
    ASSERT_TRUE(editor->itemRects().contains("color.##piece"));
    const ui::Rect swatch = editor->itemRects().at("color.##piece");
    moveTo(swatch.x + 60, swatch.y + 20);  // within the picker that has opened
    press(true, 2);
    press(false, 2);
    tap(Key::escape, 2);
    ASSERT_TRUE(panels().pieces.rows[1].color.has_value());
    EXPECT_FALSE(panels().pieces.rows[0].color.has_value());
    EXPECT_NE(pixels(), plain);
    EXPECT_EQ(simulation().stateHash(), before);
    EXPECT_EQ(panels().changes.done, changes);
}

TEST_F(EditorPieceTest, TheSelectedPieceIsExportedAlone) {
    for (const int piece : {0, 1}) {
        click("piece." + std::to_string(piece));
        settle();
        click("piece.export", 3);
        EXPECT_TRUE(panels().files.onePiece);
        EXPECT_FALSE(editor->itemRects().contains("file.per_piece"));
        const std::string name = "piece" + std::to_string(piece) + ".obj";
        enter(name);
        MeshReport report;
        loadModel(folder / name, &report);
        EXPECT_EQ(report.pieces, 1);
        EXPECT_EQ(report.triangles, panels().pieces.rows.at(piece).triangles);
    }
    EXPECT_NE(panels().pieces.rows[0].triangles, panels().pieces.rows[1].triangles);
}

}  // namespace
}  // namespace kerf::app
