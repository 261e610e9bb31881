// Distances, angles, areas and volumes by clicks; their points stick to the material.

#include "app/scene/readout/surface_anchor.h"

namespace kerf::app {
namespace {

/// A cube with sides of 1 m before the camera, without perspective, straight from the front.
class EditorMeasureTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        open(cubeDocument());
    }
    static Document cubeDocument() {
        Document document = sphereDocument();
        document.mesh = box(Vec3::Ones(), 4);
        document.restBounds = meshBounds(document.mesh);
        document.camera.eye = Vec3(0, 0, 3);
        return document;
    }
    void open(Document document) {
        start(options(), std::move(document));
        tap(Key::digit5);
        tap(Key::m);
        settle();
    }
    /// At so many metres from the middle of the picture.
    Vec2 pixelOf(double x, double y) const {
        const double perPixel = 2 * 3 * std::tan(17.5 * std::numbers::pi / 180) / kHeight;
        return {kWidth / 2.0 + x / perPixel, kHeight / 2.0 - y / perPixel};
    }
    void clickAt(double x, double y) {
        const Vec2 at = pixelOf(x, y);
        moveTo(at);
        press(true);
        press(false, 2);
    }
    const std::vector<ui::MeasureRow>& rows() const { return panels().view.measures; }
    double value(std::size_t row, std::size_t figure = 0) const {
        return rows().at(row).figures.at(figure).value;
    }
};

TEST_F(EditorMeasureTest, TwoClicksTellADistance) {
    clickAt(-0.3, -0.2);
    EXPECT_TRUE(rows().empty()) << "one point is no distance";
    clickAt(0.3, 0.25);
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_NEAR(value(0), std::hypot(0.6, 0.45), 0.004);
    EXPECT_EQ(rows()[0].figures[0].unit, "m");
    EXPECT_EQ(panels().view.overlay.dots.size(), 2U);
    ASSERT_EQ(panels().view.overlay.labels.size(), 1U);
    EXPECT_EQ(panels().view.overlay.labels[0].text, rows()[0].figures[0].text);
    EXPECT_EQ(panels().transport.step, 0) << "and nothing is cut";
}

TEST_F(EditorMeasureTest, ThreeClicksTellTheAngleAtTheSecond) {
    click("measure.Angle");
    clickAt(0.3, 0);
    clickAt(0, 0);
    clickAt(-0.2, 0.2);
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_NEAR(value(0), 135, 0.7);
    EXPECT_EQ(rows()[0].figures[0].unit, "deg");
}

TEST_F(EditorMeasureTest, AClickOnAPieceTellsItsAreaAndVolume) {
    click("measure.Piece");
    clickAt(0.1, 0.1);
    ASSERT_EQ(rows().size(), 1U);
    ASSERT_EQ(rows()[0].figures.size(), 2U);
    EXPECT_NEAR(value(0, 0), 6, 1e-5);
    EXPECT_NEAR(value(0, 1), 1, 1e-5);
}

TEST_F(EditorMeasureTest, AModelInMillimetresIsToldInMillimetresToo) {
    Document document = cubeDocument();
    document.session.placement.unit = LengthUnit::millimetre;
    document.placed = {{document.session.placement, 0}};
    open(std::move(document));
    clickAt(-0.25, 0);
    clickAt(0.25, 0);
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_NEAR(rows()[0].figures[0].ownValue, 500, 4);
    EXPECT_EQ(rows()[0].figures[0].ownUnit, "mm");
    EXPECT_THAT(rows()[0].figures[0].text, HasSubstr("mm in its file"));
}

TEST_F(EditorMeasureTest, PointsMoveWithTheBody) {
    clickAt(-0.3, 0.3);
    clickAt(0.3, 0.3);
    const ui::PlotPoint before = panels().view.overlay.dots.at(0);
    tap(Key::v);
    playFor(12);
    settle();
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_GT(panels().view.overlay.dots.at(0).y, before.y + 2) << "it fell";
    EXPECT_NEAR(value(0), 0.6, 0.05);
}

TEST_F(EditorMeasureTest, MeasuresGoOnThroughACutAndItsUndo) {
    clickAt(-0.3, 0.3);
    clickAt(-0.3, -0.3);
    click("measure.Piece");
    clickAt(-0.3, 0);
    ASSERT_EQ(rows().size(), 2U);
    tap(Key::c);
    dragAndSettle(kTop, kBottom, 30);
    frames(4);
    ASSERT_EQ(editor->title(), "Kerf - ball - 2 pieces");
    ASSERT_EQ(rows().size(), 2U);
    EXPECT_NEAR(value(0), 0.6, 0.02);
    EXPECT_EQ(rows()[1].figures.size(), 3U) << "it has a face of the cut now";
    EXPECT_NEAR(rows()[1].figures.back().value, 0.5, 0.03);
    tap(Key::z, {.control = true});
    settle(4);
    ASSERT_EQ(rows().size(), 2U);
    EXPECT_NEAR(rows()[1].figures.back().value, 1, 1e-3);
}

TEST_F(EditorMeasureTest, EscForgetsThePointsAndThenEndsMeasuring) {
    clickAt(0, 0);
    EXPECT_EQ(panels().view.overlay.dots.size(), 1U);
    tap(Key::escape, 2);
    EXPECT_EQ(panels().view.overlay.dots.size(), 0U);
    EXPECT_EQ(panels().tools.tool, ui::ToolKind::measure);
    tap(Key::escape, 2);
    EXPECT_EQ(panels().tools.tool, ui::ToolKind::stroke);
}

TEST_F(EditorMeasureTest, TheListIsSavedAndEmptied) {
    clickAt(-0.3, 0);
    clickAt(0.3, 0);
    clickAt(0, -0.3);
    clickAt(0, 0.3);
    clickAndWait("measure.csv");
    const std::string text = readBytes(onlyFile(folder.path()));
    EXPECT_THAT(text, StartsWith("id,measure,quantity,value,unit,value_in_file,unit_in_file\n"
                                 "1,distance,distance,0."));
    EXPECT_THAT(text, HasSubstr("\n2,distance,distance,"));
    click("measure.remove.1");
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_EQ(rows()[0].id, 2);
    click("measure.clear");
    EXPECT_TRUE(rows().empty());
}

TEST_F(EditorMeasureTest, TheTableOfPiecesHasAllColumnsOnDemandAndSavesThem) {
    EXPECT_FALSE(panels().pieces.rows.at(0).sums);
    click("pieces.details", 2);
    ASSERT_TRUE(panels().pieces.rows.at(0).sums);
    EXPECT_NEAR(panels().pieces.rows[0].sums->skinArea, 6, 1e-5);
    EXPECT_EQ(panels().pieces.rows[0].sums->cutArea, 0);
    EXPECT_NEAR(panels().pieces.rows[0].sums->centroid.norm(), 0, 1e-6);
    EXPECT_NEAR(panels().pieces.rows[0].shareOfAll, 1, 1e-9);
    tap(Key::c);
    dragAndSettle(kTop, kBottom, 30);
    frames(4);
    ASSERT_EQ(panels().pieces.rows.size(), 2U);
    for (const ui::PieceRow& piece : panels().pieces.rows) {
        ASSERT_TRUE(piece.sums);
        EXPECT_NEAR(piece.sums->cutArea, 1, 0.02);
        EXPECT_NEAR(std::abs(piece.sums->centroid.x()), 0.25, 0.02);
        EXPECT_TRUE(piece.bounds.center().isApprox(piece.sums->centroid, 0.1));
    }
    clickAndWait("pieces.csv");
    const std::string text = readBytes(onlyFile(folder.path()));
    EXPECT_THAT(text, StartsWith("piece,triangles,volume_m3,"));
    EXPECT_THAT(text, HasSubstr("\n2,"));
}

TEST(SurfaceAnchor, EndsWhereItsMaterialIsGone) {
    const SurfaceMesh whole =
        meshOf(joined(boxSoup(Vec3::Ones(), 1), boxSoup(Vec3::Ones(), 1), Vec3(5, 0, 0)));
    SurfaceAnchor anchor(whole, {12, whole.position(whole.triangle(12)[0]), Vec3::UnitX()});
    EXPECT_TRUE(anchor.follow(whole));
    SurfaceMesh rest = whole;
    for (int t = 12; t < 24; ++t) {
        rest.removeTriangle(t);
    }
    EXPECT_FALSE(anchor.follow(rest));
    EXPECT_TRUE(anchor.follow(whole)) << "nothing had changed";
}

double lastOf(const ui::PanelModel& model, ui::Reading reading) {
    return (*model.plots.history)[reading].last();
}

TEST_F(EditorMeasureTest, APointIsPlottedOverTime) {
    click("measure.Plot");
    clickAt(0.2, 0.1);
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_TRUE(editor->itemRects().contains("plot.point_strain"));
    EXPECT_NEAR(lastOf(panels(), ui::Reading::pointStrain), 0, 1e-6);
    tap(Key::v);
    playFor(20);
    settle();
    const auto buckets = (*panels().plots.history)[ui::Reading::pointSpeed].buckets();
    EXPECT_EQ(buckets.size(), 1U + panels().transport.step) << "a value per step";
    const double time = panels().transport.time;
    const double falling = 9.81 * (1 - std::exp(-time));  // with the air drag of 1/s
    EXPECT_NEAR(lastOf(panels(), ui::Reading::pointSpeed), falling, 0.01 * falling);
    EXPECT_GT(lastOf(panels(), ui::Reading::pointWay), 0);
    clickAt(-0.2, 0.1);
    EXPECT_EQ(rows().size(), 1U) << "one at a time";
    editor->resize(kWidth, 2 * kHeight);  // so that the button is in view
    frames(2);
    click("measure.clear", 2);
    EXPECT_TRUE(rows().empty());
    EXPECT_FALSE(editor->itemRects().contains("plot.point_strain"));
}

TEST_F(EditorMeasureTest, APlottedPointFollowsItsMaterialThroughACut) {
    click("measure.Plot");
    clickAt(0.2, 0.1);
    tap(Key::c);
    dragAndSettle(pixelOf(0.21, 0.7), pixelOf(0.19, -0.7), 30);
    ASSERT_EQ(panels().pieces.rows.size(), 2U);
    ASSERT_EQ(rows().size(), 1U);
    const std::size_t before = (*panels().plots.history)[ui::Reading::pointStrain].buckets().size();
    tap(Key::period, 2);
    EXPECT_GT((*panels().plots.history)[ui::Reading::pointStrain].buckets().size(), before);
}

// It could not be removed, since the list was empty.
TEST_F(EditorMeasureTest, ASceneThatAnUndoBringsBackPlotsNoPoint) {
    start(options());
    tap(Key::m);
    settle();
    click("measure.Plot");
    clickAt(0, 0);
    ASSERT_EQ(rows().size(), 1U);
    tap(Key::r, {.shift = true});
    waitForWork();
    settle();
    tap(Key::z, {.control = true});
    waitForWork();
    settle();
    EXPECT_EQ(panels().toast.text, "Undone: Remesh");
    EXPECT_TRUE(rows().empty());
    EXPECT_FALSE(editor->itemRects().contains("plot.point_strain"));
}

}  // namespace
}  // namespace kerf::app
