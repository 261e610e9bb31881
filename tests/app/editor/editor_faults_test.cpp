// Models with faults in the editor's view, and even triangles as a step that is undone.

#include "tests/support/model_defects.h"
#include "tests/support/sheet_soup.h"
#include "ui/state/action_table.h"

namespace kerf::app {
namespace {

constexpr std::array<int, 3> kOpen{213, 94, 0};

class EditorFaultsTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        editor->resize(1280, 1100);
        frames(2);
    }
    void openBroken(const std::vector<std::string>& defects) {
        TriangleSoup soup = soundBall();
        for (const std::string& defect : defects) {
            modelDefects().at(defect)(soup);
        }
        writeText(folder / "broken.obj", objText(soup));
        open(folder / "broken.obj", 2);
    }
    /// Unfolds the section of the model, where it is folded.
    void unfoldModel() {
        if (!editor->itemRects().contains("model.remesh")) {
            click("section.model");
        }
    }
    void even() {
        unfoldModel();
        clickAndWait("model.remesh");
        frames(2);
    }
    std::string hash() { return editor->scene()->simulation().stateHash(); }
    int seenPixelsOf(const std::array<int, 3>& color) {
        return pixelsOf(color, viewPixels(editor->readPicture()));
    }
    void cut() { dragAndSettle(kTop + Vec2(160, 0), kBottom + Vec2(160, 500), 12); }
    void undo() { tap(Key::z, {.control = true}, 2); }
    void redo() { tap(Key::y, {.control = true}, 2); }
    template <class Row>
    static std::vector<std::string> textsOf(const std::vector<Row>& rows, std::string Row::*text) {
        std::vector<std::string> texts;
        std::ranges::transform(rows, std::back_inserter(texts), text);
        return texts;
    }
    std::vector<std::string> faultLabels() {
        return textsOf(panels().looks.faults, &ui::FaultRow::label);
    }
    std::vector<std::string> changes() {
        return textsOf(panels().changes.rows, &ui::ChangeRow::name);
    }
};

TEST_F(EditorFaultsTest, AModelWithFaultsStandsBehindTheQuestion) {
    const render::Camera before = editor->scene()->rest().homeView();
    openBroken({"large hole"});
    ASSERT_NE(panels().question.text, "");
    EXPECT_TRUE(panels().looks.showsFaulty);
    ASSERT_EQ(panels().looks.faults.size(), 1U);
    EXPECT_THAT(panels().looks.faults[0].label, HasSubstr("open edges"));
    EXPECT_GT(seenPixelsOf(kOpen), 200);
    tap(Key::escape, 2);
    EXPECT_FALSE(panels().looks.showsFaulty);
    EXPECT_THAT(panels().looks.faults, IsEmpty());
    EXPECT_EQ(seenPixelsOf(kOpen), 0);
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    EXPECT_EQ(editor->scene()->rest().homeView().eye, before.eye);
}

TEST_F(EditorFaultsTest, TheViewCanBeTurnedBesideTheQuestion) {
    openBroken({"large hole"});
    const render::Image before = editor->readPicture();
    const Vec2 middle(640, 300);
    drag(middle, middle + Vec2(150, 20), 5, Button::right);
    frames(3);
    EXPECT_NE(viewPixels(editor->readPicture()), viewPixels(before));
    EXPECT_NE(panels().question.text, "") << "it is still asked";
    tap(Key::escape, 2);
    const render::Image back = editor->readPicture();
    open(folder / "broken.obj");
    tap(Key::escape, 2);
    EXPECT_EQ(viewPixels(editor->readPicture()), viewPixels(back)) << "the camera is as it was";
}

TEST_F(EditorFaultsTest, WhatNothingMendsIsShownUntilOneGoesBack) {
    // A square with both of its sides, and nothing between.
    writeText(folder / "flat.obj",
              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 0\nv 0.4 0.4 0\n"
              "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 2 1 6\nf 3 2 6\nf 4 3 6\nf 1 4 6\n");
    open(folder / "flat.obj", 2);
    EXPECT_EQ(panels().question.text, "");
    EXPECT_TRUE(panels().toast.isError);
    EXPECT_TRUE(panels().looks.showsFaulty);
    EXPECT_THAT(panels().help.hint.text, HasSubstr("flat.obj can't be cut"));
    const std::string state = hash();
    tap(Key::escape, 2);
    EXPECT_FALSE(panels().looks.showsFaulty);
    EXPECT_EQ(hash(), state);
}

TEST_F(EditorFaultsTest, ARepairIsTakenBackAndDoneAgain) {
    openBroken({"large hole", "doubles"});
    const std::vector<std::string> shown = faultLabels();
    ASSERT_FALSE(shown.empty());
    confirm(2);
    EXPECT_EQ(editor->title(), "Kerf - broken - 1 piece");
    EXPECT_THAT(changes(), ElementsAre("Repair"));
    const std::string mended = hash();
    undo();
    EXPECT_EQ(panels().question.title, "Undone: Repair");
    EXPECT_TRUE(panels().looks.showsFaulty);
    EXPECT_EQ(faultLabels(), shown);
    tap(Key::enter, 2);
    EXPECT_EQ(hash(), mended);
    EXPECT_FALSE(panels().looks.showsFaulty);
    undo();
    tap(Key::escape, 2);
    EXPECT_EQ(editor->scene(), nullptr);
    EXPECT_EQ(editor->title(), "Kerf");
}

/// A bent cloth of 0.8 m.
TriangleSoup wavySheet() {
    TriangleSoup soup = sheetSoup(8, [](double x, double) { return 0.0375 * std::sin(8 * x); });
    for (Vec3& p : soup.positions) {
        p *= 0.8;
    }
    return soup;
}

TEST_F(EditorFaultsTest, ASheetIsOfferedAThicknessFirstAndASessionKeepsIt) {
    writeText(folder / "cloth.obj", objText(wavySheet()));
    open(folder / "cloth.obj", 2);
    EXPECT_THAT(panels().question.choices, ElementsAre("Thicken", "Fill 1 hole", "Cancel"));
    EXPECT_THAT(panels().question.text, HasSubstr("With a thickness it can be cut"));
    ASSERT_TRUE(panels().question.number);
    EXPECT_EQ(panels().question.number->unit, "mm");
    EXPECT_EQ(panels().question.number->value, 10) << "a round number, at most 23 mm";
    EXPECT_TRUE(panels().looks.showsFaulty);
    click("question.number");
    tap(Key::a, {.control = true});
    type("16");
    confirm(2);
    EXPECT_EQ(editor->title(), "Kerf - cloth - 1 piece");
    EXPECT_THAT(panels().toast.text, HasSubstr("gave 1 sheet a thickness of 0.016"));
    EXPECT_THAT(changes(), ElementsAre("Thicken"));
    const std::string mended = hash();
    undo();
    EXPECT_EQ(panels().question.title, "Undone: Thicken");
    EXPECT_TRUE(panels().looks.showsFaulty);
    tap(Key::enter, 2);
    EXPECT_EQ(hash(), mended);
    cut();
    tap(Key::s, {.control = true}, 2);
    enter("sheet");
    const Session session = readSession(folder / "sheet.kerf.json");
    EXPECT_EQ(session.model.thicken, 0.016);
    expectReplayed(session, loadSessionModel(session));
}

TEST_F(EditorFaultsTest, AnAssemblyIsPartedIntoModelsAsAStepThatIsUndone) {
    const TriangleSoup lower = boxSoup(Vec3::Ones(), 8);
    const TriangleSoup upper = boxSoup(Vec3::Constant(0.5), 8);
    std::string text = objText(joined(lower, upper, 0.75 * Vec3::UnitY()));
    std::size_t face = text.find("f ");
    for (std::size_t t = 0; t < lower.triangles.size(); ++t) {
        face = text.find('\n', face) + 1;
    }
    text.insert(face, "o upper\n");
    writeText(folder / "two.obj", text);
    open(folder / "two.obj", 2);
    const std::string whole = hash();
    EXPECT_THAT(panels().toast.text, HasSubstr("The file contains 2 objects"));
    tap(Key::o, {.shift = true});
    waitForWork(2);
    EXPECT_EQ(panels().model.models.size(), 2U);
    EXPECT_EQ(panels().model.objects, 0) << "there is nothing more to part";
    EXPECT_THAT(changes(), ElementsAre("Split into models"));
    EXPECT_THAT(panels().toast.text, HasSubstr("Split into models: 2"));
    undo();
    EXPECT_EQ(panels().model.models.size(), 1U);
    EXPECT_EQ(hash(), whole);
}

TEST_F(EditorFaultsTest, EvenTrianglesAreUndoneAndRedoneToTheBit) {
    const std::string before = hash();
    const int triangles = panels().body.triangles;
    const double proposed = panels().model.models[0].edge;
    even();
    const std::string evened = hash();
    EXPECT_NE(evened, before);
    EXPECT_THAT(panels().toast.text, HasSubstr("triangles instead of 768"));
    EXPECT_THAT(changes(), ElementsAre("Remesh"));
    EXPECT_EQ(panels().changes.done, 1U);
    EXPECT_NEAR(panels().model.models[0].edge, proposed, 0.1 * proposed);
    ASSERT_EQ(panels().session.past.size(), 1U) << "marked on the time line";
    EXPECT_EQ(panels().session.past[0].text, "Remesh");
    undo();
    EXPECT_THAT(panels().session.past, IsEmpty());
    EXPECT_EQ(hash(), before);
    EXPECT_EQ(panels().body.triangles, triangles);
    EXPECT_THAT(changes(), ElementsAre("Remesh"));
    EXPECT_EQ(panels().changes.done, 0U);
    redo();
    EXPECT_EQ(hash(), evened);
    EXPECT_EQ(panels().changes.done, 1U);
}

TEST_F(EditorFaultsTest, ACoarseModelIsOfferedRemeshed) {
    writeText(folder / "cube.obj", objText(boxSoup()));
    open(folder / "cube.obj", 2);
    EXPECT_EQ(panels().body.triangles, 12) << "nothing is refined unasked";
    EXPECT_THAT(panels().toast.text,
                HasSubstr("The mesh is coarse: 12 triangles, edges up to 1.41 m. "
                          "With edges of 6.93 cm it bends and cuts well."));
    ASSERT_TRUE(panels().toast.choice);
    EXPECT_EQ(panels().toast.choice->id, ui::ActionId::remesh);
    EXPECT_NEAR(panels().model.models[0].edge, std::sqrt(3) / 25, 1e-6);
    const ui::Rect offer = editor->itemRects().at("toast.Shift+R");
    moveTo(offer.x + offer.width / 2, offer.y - 8, 1);
    press(true, 1);
    EXPECT_TRUE(editor->scene()->stroke().drawing()) << "beside the button the view is pressed";
    press(false, 1);
    clickAndWait("toast.Shift+R");
    frames(2);
    EXPECT_GT(panels().body.triangles, 2000);
    EXPECT_THAT(panels().toast.text, HasSubstr(" instead of 12, 0 slivers left"));
    EXPECT_EQ(editor->scene()->document().session.model.edge, 0.0693);
    undo();
    EXPECT_EQ(panels().body.triangles, 12);
}

TEST_F(EditorFaultsTest, ALargeModelSaysHowSlowItIsAndIsOfferedCoarser) {
    writeText(folder / "fine.obj", objText(icosphereSoup(5)));  // 20,480 triangles
    EditorOptions told = options();
    told.slowStep = 0;
    start(told);
    open(folder / "fine.obj", 2);
    EXPECT_THAT(panels().toast.text, HasSubstr("Slow on this computer: a step of "));
    ASSERT_TRUE(panels().toast.choice);
    clickAndWait("toast.Ctrl+Shift+R");
    frames(2);
    EXPECT_NEAR(panels().body.triangles, ui::kFewTriangles, 0.2 * ui::kFewTriangles);
    EXPECT_THAT(panels().toast.text, HasSubstr("; the surface moved by up to "));
    EXPECT_NEAR(panels().model.models[0].size.x(), 1, 0.01);
}

TEST_F(EditorFaultsTest, TheEdgesOfARemeshedModelAreChosen) {
    unfoldModel();
    const double proposed = panels().model.models[0].edge;
    const ui::Rect field = editor->itemRects().at("model.edge");
    const Vec2 middle(field.x + field.width / 2, field.y + field.height / 2);
    drag(middle, middle + Vec2(60, 0), 6);
    frames(12);
    even();
    EXPECT_GT(editor->scene()->document().session.model.edge, 1.1 * proposed);
    EXPECT_LT(panels().body.triangles, 700);
}

TEST_F(EditorFaultsTest, AnotherChangeForgetsWhatWasUndone) {
    even();
    undo();
    cut();
    ASSERT_FALSE(panels().model.untouched);
    const std::string changed = hash();
    redo();
    EXPECT_EQ(hash(), changed);
    EXPECT_THAT(changes(), Not(Contains("Remesh")));
}

TEST_F(EditorFaultsTest, TheHistoryGoesFromSceneToScene) {
    cut();
    ASSERT_FALSE(panels().model.untouched);
    const std::string cutOnce = hash();
    const std::size_t own = changes().size();
    even();
    EXPECT_THAT(panels().question.title, HasSubstr("reset the cuts?"));
    confirm(2);
    EXPECT_TRUE(panels().model.untouched);
    EXPECT_EQ(changes().size(), own + 1);
    const std::string evened = hash();
    cut();
    const std::string both = hash();
    const std::size_t rows = changes().size();
    for (const std::string& state : {evened, cutOnce}) {
        undo();
        EXPECT_EQ(hash(), state);
    }
    editor->resize(1280, 1100);
    click("tab.History");
    while (panels().changes.done > 0) {
        undo();
    }
    EXPECT_NE(hash(), cutOnce);
    EXPECT_TRUE(panels().model.untouched);
    EXPECT_EQ(changes().size(), rows);
    for (const std::string& state : {cutOnce, evened, both}) {
        redo();
        EXPECT_EQ(hash(), state);
    }
}

TEST_F(EditorFaultsTest, CancelLeavesEverythingAsItWas) {
    const std::string before = hash();
    unfoldModel();
    click("model.remesh");
    tap(Key::escape);
    waitForWork();
    EXPECT_EQ(hash(), before);
    EXPECT_THAT(changes(), IsEmpty());
}

TEST_F(EditorFaultsTest, ASessionSavedAfterwardsReplaysToTheBit) {
    even();
    cut();
    ASSERT_FALSE(panels().model.untouched);
    tap(Key::s, {.control = true}, 2);
    enter("even");
    const Session session = readSession(folder / "even.kerf.json");
    EXPECT_TRUE(session.model.remesh);
    EXPECT_EQ(lastCheck(session).hash, hash());
    expectReplayed(session, loadSessionModel(session));
    EXPECT_NE(loadSessionModel(session).mesh.aliveTriangles(), 768);
}

TEST_F(EditorFaultsTest, FaultsOfTheOpenModelAreShownOnDemand) {
    writeText(folder / "bar.obj", objText(boxSoup(Vec3(1, 20, 1))));
    open(folder / "bar.obj", 2);
    EXPECT_EQ(panels().model.faultCount, 8);
    EXPECT_THAT(panels().looks.faults, IsEmpty());
    EXPECT_THAT(panels().model.models[0].triangles, HasSubstr("12 triangles, 8 slivers"));
    unfoldModel();
    constexpr std::array<int, 3> kNeedle{230, 159, 0};
    EXPECT_EQ(seenPixelsOf(kNeedle), 0);
    click("model.faults", 2);
    EXPECT_THAT(faultLabels(), ElementsAre("8 slivers"));
    EXPECT_GT(seenPixelsOf(kNeedle), 100);
    click("model.faults", 2);
    EXPECT_EQ(seenPixelsOf(kNeedle), 0);
    even();
    EXPECT_EQ(panels().model.faultCount, 0) << panels().toast.text;
}

TEST_F(EditorFaultsTest, PiecesThatCrossAreUnitedAsAStepThatIsUndone) {
    writeText(folder / "boxes.obj",
              objText(joined(boxSoup(Vec3::Ones(), 4), boxSoup(Vec3::Ones(), 4),
                             Vec3(0.53, 0.27, 0.11))));
    open(folder / "boxes.obj", 2);
    EXPECT_EQ(editor->scene()->simulation().report().pieces, 2);
    EXPECT_TRUE(panels().model.models[0].crosses);
    const std::string before = hash();
    unfoldModel();
    clickAndWait("model.unite");
    frames(2);
    EXPECT_EQ(editor->scene()->simulation().report().pieces, 1);
    EXPECT_FALSE(panels().model.models[0].crosses);
    EXPECT_THAT(changes(), ElementsAre("Unite pieces"));
    undo();
    EXPECT_EQ(hash(), before);
    EXPECT_EQ(editor->scene()->simulation().report().pieces, 2);
}

TEST_F(EditorFaultsTest, AModelOfTheCommandLineIsSearchedForPiecesThatCross) {
    writeText(folder / "boxes.obj", objText(joined(boxSoup(), boxSoup(), Vec3(0.5, 0, 0))));
    const Document document = openDocument(folder / "boxes.obj", editorReading(memoryMeans()));
    EXPECT_GT(document.faults.of(repair::FaultKind::crossingTriangle).count(), 0);
    EXPECT_THAT(document.note, HasSubstr("pass through others"));
}

}  // namespace
}  // namespace kerf::app
