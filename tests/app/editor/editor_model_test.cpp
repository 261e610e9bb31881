// The model's unit, axis, turn and scale in the editor.
#include <gmock/gmock.h>

#include "app/files/io/file_io.h"
#include "app/scene/document/rest_of_body.h"
#include "app/scene/editor_scene.h"
#include "app/scene/timeline/scene_recorder.h"
#include "sim/repair/soup_inspection.h"
#include "sim/run/simulation.h"
#include "tests/app/editor/editor_fixture.h"
#include "tests/app/session/replayed_session.h"

namespace kerf::app {
namespace {

using ::testing::HasSubstr;

/// A box that stands on the ground of its own file, 9.66 high.
class EditorModelTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        TriangleSoup soup = test::boxSoup(Vec3(3, 9.66, 3), 9);  // not coarse
        for (Vec3& p : soup.positions) {
            p += Vec3(100, 4.83, 0);
        }
        test::writeText(folder / "figure.obj", test::objText(soup));
        editor->resize(1280, 1200);
        editor->open(folder / "figure.obj");
        waitForWork();
        frames(2);
    }
    const ui::ModelState& model() { return panels().model.models[0]; }
    Simulation& simulation() { return editor->scene()->simulation(); }
    /// Where the middle of the body is in the picture, and how large it looks.
    Vec3 appearance() {
        const render::Camera camera = editor->scene()->rest().homeView();
        const Bounds& bounds = editor->scene()->rest().bounds();
        return (camera.eye - bounds.center()) / bounds.diagonal();
    }
    Bounds exportedBounds(const std::string& name, bool inScene) {
        tap(Key::e, {.control = true});
        frames(2);
        type(name);
        if (inScene) {
            click("file.in_scene");
        }
        tap(Key::enter);
        waitForWork();
        MeshReport report;
        loadModel(folder / name, &report);
        return report.bounds;
    }
};

TEST_F(EditorModelTest, OpensAsItIsAndSaysWhatWasTaken) {
    EXPECT_THAT(panels().toast.text, HasSubstr("assumed centimetres"));
    EXPECT_EQ(model().placement.scale, 1);
    EXPECT_EQ(model().placement.unit, LengthUnit::centimetre);
    EXPECT_NEAR(model().size.y(), 0.0966, 1e-6);
    EXPECT_THAT(model().physics, HasSubstr("At a height of 9.66 cm this body weighs 93 g."));
    EXPECT_TRUE(panels().model.untouched);
    EXPECT_TRUE(editor->itemRects().contains("model.unit.m"));  // unfolded
}

TEST_F(EditorModelTest, AClickTakesAnotherUnitAndTheViewComesAlong) {
    const Vec3 before = appearance();
    click("model.unit.m");
    EXPECT_EQ(model().placement.unit, LengthUnit::metre);
    EXPECT_NEAR(model().size.y(), 9.66, 1e-4);
    EXPECT_THAT(model().physics, HasSubstr("It will collapse under its own weight"));
    EXPECT_TRUE(appearance().isApprox(before, 1e-4));
    EXPECT_NEAR(panels().tools.longest, 2 * editor->scene()->rest().bounds().diagonal(), 1e-6);
    tap(Key::z, {.control = true});
    EXPECT_EQ(model().placement.unit, LengthUnit::centimetre);
    EXPECT_TRUE(appearance().isApprox(before, 1e-4));
}

TEST_F(EditorModelTest, AnotherAxisLaysItDownOnTheFloor) {
    click("model.up.z");
    EXPECT_NEAR(model().size.z(), 0.0966, 1e-6);
    EXPECT_NEAR(model().size.y(), 0.03, 1e-6);
    const Bounds& bounds = editor->scene()->rest().bounds();
    EXPECT_NEAR(bounds.low.y(), 0.02 * bounds.diagonal(), 1e-6);
}

TEST_F(EditorModelTest, ExportsTheCoordinatesOfItsFileUnlessToldOtherwise) {
    const Bounds own = exportedBounds("own.obj", false);
    EXPECT_EQ(own.low.cast<float>(), Vec3(98.5, 0, -1.5).cast<float>());
    EXPECT_EQ(own.high.cast<float>(), Vec3(101.5, 9.66, 1.5).cast<float>());
    const Bounds scene = exportedBounds("scene.obj", true);
    EXPECT_NEAR(scene.high.y() - scene.low.y(), 0.0966, 1e-6);
    click("model.unit.in");
    editor->scene()->step();
    const Bounds moved = exportedBounds("inches.ply", false);
    EXPECT_NEAR(moved.high.y(), 9.66, 0.06);  // It fell for a step.
    EXPECT_NEAR(moved.high.x(), 101.5, 1e-3);
}

TEST_F(EditorModelTest, APlacementAfterACutStartsAnewAndIsReplayed) {
    const Document opened = openDocument(folder / "figure.obj");
    editor->resize(320, 240);
    drag({160, 5}, {160, 235}, 6);
    settle();
    ASSERT_EQ(editor->scene()->simulation().report().pieces, 2);
    EXPECT_FALSE(panels().model.untouched);
    const std::string cut = simulation().stateHash();
    Placement feet = model().placement;
    feet.unit = LengthUnit::foot;
    EXPECT_EQ(editor->scene()->place(feet, false), "");
    frames(2);
    EXPECT_EQ(editor->scene()->simulation().report().pieces, 1);
    tap(Key::z, {.control = true});
    EXPECT_EQ(editor->scene()->simulation().report().pieces, 2);
    EXPECT_EQ(simulation().stateHash(), cut);
    tap(Key::z, {.shift = true, .control = true});
    EXPECT_EQ(model().placement.unit, LengthUnit::foot);
    drag({160, 5}, {160, 235}, 6);
    settle();
    editor->scene()->recorder().addExport();
    const Session session =
        editor->scene()->recorder().savedSession(editor->scene()->rest().homeView(), {}).session;
    const Session again = parseSession(formatSession(session, folder.path()), folder.path());
    EXPECT_EQ(again.placement, opened.session.placement);
    ModelMesh model(opened.mesh, opened.looks);
    model.placed = opened.placed;
    expectReplayed(again, model);
}

TEST_F(EditorModelTest, ARecordingKeepsThePlacement) {
    click("model.unit.mm");
    const std::string hash = simulation().stateHash();
    editor->scene()->startRecording();
    frames(2);
    EXPECT_EQ(model().placement.unit, LengthUnit::millimetre);
    EXPECT_EQ(simulation().stateHash(), hash);
}

TEST_F(EditorModelTest, AnotherModelStandsBesideAndGoesAgain) {
    const TriangleSoup soup = test::boxSoup(Vec3(4, 2, 2), 2);
    test::writeText(folder / "stool.obj", test::objText(soup));
    const Bounds before = editor->scene()->rest().bounds();
    tap(Key::o, {.shift = true, .control = true});
    frames(2);
    type("stool.obj");
    tap(Key::enter);
    waitForWork();
    frames(2);
    ASSERT_EQ(panels().model.models.size(), 2u);
    EXPECT_EQ(panels().model.models[1].name, "stool");
    EXPECT_EQ(editor->scene()->simulation().report().pieces, 2);
    const std::vector<ModelFigures>& models = editor->scene()->rest().models();
    EXPECT_GT(models[1].bounds.low.x(), before.high.x());
    EXPECT_GT(models[1].bounds.low.y(), -1e-9);  // on the floor
    EXPECT_NEAR(models[1].volume, 16, 1e-9);
    click("model.1");
    click("model.unit.in");
    EXPECT_EQ(simulation().placement(1).unit, LengthUnit::inch);
    EXPECT_EQ(simulation().placement(0).unit, LengthUnit::centimetre);
    editor->scene()->step();
    editor->scene()->recorder().addExport();
    const Session session =
        editor->scene()->recorder().savedSession(editor->scene()->rest().homeView(), {}).session;
    expectReplayed(session, loadSessionModel(session));
    click("model.remove.1");
    frames(2);
    click("question.1");
    waitForWork();
    frames(2);
    EXPECT_EQ(panels().model.models.size(), 1u);
    EXPECT_EQ(editor->scene()->simulation().report().pieces, 1);
    EXPECT_EQ(simulation().placement(0).unit, LengthUnit::centimetre);
}

TEST_F(EditorModelTest, AddsNoSession) {
    test::writeText(folder / "other.kerf.json", "{}");
    tap(Key::o, {.shift = true, .control = true});
    frames(2);
    type("other.kerf.json");
    tap(Key::enter);
    waitForWork();
    EXPECT_THAT(panels().toast.text, HasSubstr("a session can't be added to a scene"));
    EXPECT_EQ(panels().model.models.size(), 1u);
}

}  // namespace
}  // namespace kerf::app
