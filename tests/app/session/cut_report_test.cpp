#include "app/session/cut_report.h"

namespace kerf::app {
namespace {

constexpr double kEdge = 1;  // of the cube [m]

/// A body with the strokes that have cut it, as a simulation keeps them.
class CutBody {
  public:
    explicit CutBody(SurfaceMesh whole) : uncut_(std::move(whole)), mesh_(uncut_) {}

    void cut(const Stroke& way) {
        cutter_.begin(way.front());
        strokes_.emplace_back();
        strokes_.back().number = cutter_.strokeNumber();
        strokes_.back().firstTriangle = mesh_.triangleSlots();
        for (std::size_t i = 1; i < way.size(); ++i) {
            strokes_.back().add(cutter_.advance(way[i]));
        }
        strokes_.back().add(cutter_.finish());
    }
    SurfaceMesh& mesh() { return mesh_; }
    std::optional<CutReport> report() const { return reportOn({mesh_, uncut_, strokes_}); }

  private:
    SurfaceMesh uncut_;
    SurfaceMesh mesh_;
    Cutter cutter_{mesh_, CutSettings{}};
    std::vector<StrokeRecord> strokes_;
};

/// Downwards through the cube in the plane z = 0.013, to `depth` below its top [m].
Stroke downTo(double depth) {
    const double above = 0.2;
    const Vec3 middle(0.01, kEdge / 2 + above - (above + depth) / 2, 0.013);
    return straightStroke(middle, Vec3::UnitX(), -Vec3::UnitY(), 2 * kEdge, above + depth,
                          static_cast<int>(60 * (above + depth)));
}

TEST(CutReport, SkinThatPassesThroughItselfIsCountedWhereItLies) {
    const SurfaceMesh uncut = box({1, 0.02, 1}, 2);
    SurfaceMesh mesh = uncut;
    EXPECT_EQ(countSkinCrossings(mesh, uncut), 0);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.position(v).y() > 0 && mesh.position(v).x() > -0.1) {
            mesh.setPosition(v, mesh.position(v) - Vec3(0, 0.05, 0));
        }
    }
    EXPECT_GT(countSkinCrossings(mesh, uncut), 0);
    mesh.exchangeShapes();
    EXPECT_EQ(countSkinCrossings(mesh, uncut), 0);
}

TEST(CutReport, APlaneThroughACubeLeavesTwiceItsSectionAndNothingElse) {
    CutBody body(box(Vec3::Constant(kEdge), 6));
    body.cut(downTo(1.5));
    const CutReport report = body.report().value();
    const CutFigures& all = report.all;
    EXPECT_NEAR(all.woundArea, 2 * kEdge * kEdge, 0.01 * 2);
    EXPECT_NEAR(all.steps.swept.atRest, kEdge * kEdge, 0.01);
    EXPECT_NEAR(all.steps.swept.asItLay, all.steps.swept.atRest, 1e-9);
    EXPECT_NEAR(all.woundToSwept().value(), 1, 1e-3);
    EXPECT_NEAR(report.volumeError, 0, 1e-6);
    EXPECT_EQ(report.crossings.all, 0);
    EXPECT_EQ(all.slitEdges, 0);
    EXPECT_EQ(all.slitLength, 0);
    EXPECT_EQ(all.steps.refusedSteps, 0);
    EXPECT_GT(all.steps.cutSteps, 5);
    EXPECT_GT(all.walls.triangles, 2 * 36);
    EXPECT_EQ(all.walls.triangles % 2, 0) << "both sides have the same triangles";
    EXPECT_GT(all.skin.triangles, 24) << "skin was divided all around";
    EXPECT_EQ(all.triangles().bareSlivers, 0);
    EXPECT_GT(all.triangles().worstAngle, 0.1);
    EXPECT_LT(all.triangles().worstAngle, all.triangles().meanAngle());
    EXPECT_LT(all.triangles().meanAngle(), 60);
    EXPECT_EQ(report.strokes.size(), 1U);
}

TEST(CutReport, AnIncisionEndsInsideAlongItsLength) {
    CutBody body(box(Vec3::Constant(kEdge), 6));
    body.cut(downTo(0.5));
    const CutReport report = body.report().value();
    EXPECT_NEAR(report.all.woundArea, 2 * 0.5 * kEdge, 0.01 * 2);
    EXPECT_NEAR(report.all.woundToSwept().value(), 1, 1e-3);
    EXPECT_NEAR(report.all.slitLength, kEdge, 0.02);
    EXPECT_GT(report.all.slitEdges, 5);
    EXPECT_NEAR(report.volumeError, 0, 1e-6);
    EXPECT_EQ(report.crossings.all, 0);
}

TEST(CutReport, EachStrokeHasItsOwnFiguresAndTheyAddUp) {
    CutBody body(box(Vec3::Constant(kEdge), 6));
    body.cut(downTo(0.5));
    body.cut(straightStroke({0.1, 0, 0}, Vec3::UnitZ(), Vec3::UnitY(), 2, 2, 60));
    const CutReport report = body.report().value();
    ASSERT_EQ(report.strokes.size(), 2U);
    const CutFigures& first = report.strokes[0];
    const CutFigures& second = report.strokes[1];
    EXPECT_NEAR(first.woundArea, kEdge, 0.02);
    EXPECT_NEAR(second.woundArea, 2 * kEdge, 0.02);
    EXPECT_GT(first.slitEdges, 0);
    EXPECT_EQ(second.slitEdges, 0);
    EXPECT_GT(first.skin.triangles, 0);
    EXPECT_GT(second.skin.triangles, first.skin.triangles);
    EXPECT_EQ(report.all.walls.triangles, first.walls.triangles + second.walls.triangles);
    EXPECT_EQ(report.all.steps.cutSteps, first.steps.cutSteps + second.steps.cutSteps);
    EXPECT_DOUBLE_EQ(report.all.woundArea, first.woundArea + second.woundArea);
}

TEST(CutReport, AStretchedBodyIsMeasuredAtRest) {
    CutBody body(box(Vec3::Constant(kEdge), 6));
    for (int v = 0; v < body.mesh().vertexCount(); ++v) {
        body.mesh().setPosition(v, body.mesh().position(v).cwiseProduct(Vec3(1.5, 1, 1)));
    }
    body.cut(downTo(1.5));
    const CutReport report = body.report().value();
    EXPECT_NEAR(report.all.woundArea, 2 * kEdge * kEdge, 0.01 * 2);
    EXPECT_NEAR(report.all.steps.swept.atRest, kEdge * kEdge, 0.01);
    EXPECT_NEAR(report.all.steps.swept.asItLay, 1.5 * kEdge * kEdge, 0.015);
}

TEST(CutReport, StrokesThroughTheAirLeaveNoReport) {
    CutBody body(box());
    EXPECT_FALSE(body.report()) << "no stroke";
    body.cut(straightStroke({0, 3, 0}, Vec3::UnitX(), Vec3::UnitZ(), 2, 2, 20));
    EXPECT_FALSE(body.report());
}

TEST(CutReport, WhatTheModelCrossesByItselfIsNotOfTheCuts) {
    const TriangleSoup cube = boxSoup(Vec3::Ones(), 6);
    CutBody body(meshOf(joined(cube, cube, Vec3::Constant(0.9))));
    body.cut(straightStroke({0, 0, -0.3}, Vec3::UnitX(), Vec3::UnitY(), 2, 2, 60));
    const CutReport report = body.report().value();
    EXPECT_GT(report.crossings.all, 0);
    EXPECT_EQ(report.crossings.ofCuts, 0);
}

// The halves have moved along a bent wall, whose sides the second stroke divides along other lines.
TEST(CutReport, SidesOfAWallThatAreDividedDifferentlyDoNotCross) {
    CutBody body(icosphere(3));
    Stroke bent;
    for (int i = 0; i <= 40; ++i) {
        const double y = 1.2 - 2.4 * i / 40;
        bent.push_back({{-1.5, y, 0.1 * y * y}, {1.5, y, 0.1 * y * y}});
    }
    body.cut(bent);
    SurfaceMesh& mesh = body.mesh();
    const auto pieces = findPieces(mesh);
    ASSERT_EQ(pieces.pieces.size(), 2U);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.outgoing(v) >= 0 && pieces.ofVertex[v] == 1) {
            mesh.setPosition(v, mesh.position(v) + Vec3(0.05, 0, 0));
        }
    }
    body.cut(straightStroke({0.01, 0, 0.02}, Vec3::UnitZ(), -Vec3::UnitY(), 3, 2.4, 40));
    const CutReport report = body.report().value();
    EXPECT_EQ(report.all.steps.refusedSteps, 0);
    EXPECT_EQ(report.crossings.all, 0);
}

/// A vertex that has no skin around it.
int vertexOfWalls(const SurfaceMesh& mesh) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        bool inside = mesh.outgoing(v) >= 0;
        mesh.forEachOutgoing(v, [&](int h) {
            inside = inside && mesh.kind(SurfaceMesh::triangleOf(h)) == SurfaceKind::wall;
        });
        if (inside) {
            return v;
        }
    }
    return -1;
}

TEST(CutReport, AWallPulledOutThroughTheSkinCrossesItAndChangesTheVolume) {
    CutBody body(box(Vec3::Constant(kEdge), 6));
    body.cut(downTo(1.5));
    const int v = vertexOfWalls(body.mesh());
    ASSERT_GE(v, 0);
    body.mesh().setRestPosition(v, body.mesh().restPosition(v) + Vec3(0.01, 0.02, 2));
    const CutReport pulled = body.report().value();
    EXPECT_GT(pulled.crossings.ofCuts, 0);
    EXPECT_GT(std::abs(pulled.volumeError), 1e-3);
    EXPECT_GT(pulled.all.woundToSwept().value(), 1.01);
    EXPECT_LT(pulled.all.walls.worstAngle, 20);
}

TEST(ShapeFigures, TellAnglesAndSlivers) {
    const double height = std::sqrt(3) / 2;
    EXPECT_NEAR(smallestAngle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, height, 0)}), 60, 1e-12);
    EXPECT_NEAR(smallestAngle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)}), 45, 1e-12);
    EXPECT_EQ(smallestAngle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0, 0)}), 0);
    ShapeFigures shapes;
    for (const double apex : {0.5, 0.021, 0.019, 0.0011, 0.0009}) {
        shapes.add({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, apex, 0)});
    }
    EXPECT_EQ(shapes.triangles, 5);
    EXPECT_EQ(shapes.slivers, 3);
    EXPECT_EQ(shapes.bareSlivers, 1);
    EXPECT_NEAR(shapes.worstAngle, std::atan2(0.0009, 0.5) * 180 / 3.14159265358979, 1e-9);
}

class CutReportOfARun : public GlTest {
  protected:
    /// `keys`: further ones, each with its comma.
    static std::string sessionText(const std::string& events, const std::string& keys = "") {
        return R"({"format": "kerf-session", "version": 1, "steps": 40, )" + keys +
               R"("model": {"builtin": "sphere80"},
                  "params": {"iterations": 2, "gravity": [0, 0, 0], "floor": null}, "events": [)" +
               events + "]}";
    }
    Json replayed(const std::string& events) {
        const test::TemporaryFolder folder;
        writeText(folder / "a.kerf.json", sessionText(events));
        const Session session = readSession(folder / "a.kerf.json");
        const ReplayResult result =
            replaySession(session, loadSessionModel(session), folder / "out", {});
        EXPECT_THAT(result.summary.failures, IsEmpty());
        return Json::parse(readBytes(folder / "out/summary.json")).at("cut_report");
    }

    const std::string stroke_ = R"(
        {"step": 0, "type": "blade", "a": [-0.8, 0.7, 0.02], "b": [0.8, 0.7, 0.02]},
        {"step": 30, "type": "blade", "a": [-0.8, -0.7, 0.02], "b": [0.8, -0.7, 0.02]},
        {"step": 31, "type": "lift"})";
};

TEST_F(CutReportOfARun, StandsInTheSummary) {
    const Json report = replayed(stroke_);
    EXPECT_EQ(report.at("strokes").size(), 1U);
    EXPECT_GT(report.at("steps").at("cut"), 5);
    EXPECT_EQ(report.at("steps").at("refused"), 0);
    EXPECT_GT(report.at("triangles").at("walls"), 10);
    EXPECT_GT(report.at("smallest_angle").at("worst"), 0);
    EXPECT_NEAR(report.at("area").at("wound_to_swept"), 1, 0.01);
    EXPECT_LE(report.at("slivers").at("below_0_001"), report.at("slivers").at("below_0_02"));
    EXPECT_NEAR(report.at("volume_error"), 0, 1e-6);
    EXPECT_EQ(report.at("self_intersections").at("pairs"), 0);
    EXPECT_EQ(report.at("slit_ends").at("edges"), 0);
    EXPECT_EQ(report.at("strokes").at(0).at("area"), report.at("area"));
}

TEST_F(CutReportOfARun, FractureEnergyIsToughnessTimesTheAreaThatIsSwept) {
    const auto sumsWith = [&](const std::string& material) {
        const test::TemporaryFolder folder;
        writeText(folder / "a.kerf.json", sessionText(stroke_, material));
        const Session session = readSession(folder / "a.kerf.json");
        double area = 0;
        double energy = 0;
        const auto addRow = [&](const MetricsRow& row) {
            EXPECT_EQ(row.namesToughness, !material.empty());
            area += row.report.swept.atRest;
            energy += row.report.fractureEnergy;
        };
        replaySession(session, loadSessionModel(session), folder / "out", {{}, addRow});
        return std::pair(area, energy);
    };
    const auto [area, energy] = sumsWith(R"("material": "liver", )");
    EXPECT_GT(area, 0.5);
    EXPECT_NEAR(energy, 164 * area, 1e-9);
    sumsWith("");
}

TEST(Metrics, TellWhetherSomebodyNamedTheToughness) {
    Session session;
    const Params plain;
    EXPECT_FALSE(namesToughness(session, plain));
    Params other;
    other.toughness = 99;
    EXPECT_TRUE(namesToughness(session, other));
    Params feels;
    feels.bladeFeels = 1;
    EXPECT_TRUE(namesToughness(session, feels)) << "there it counts";
    Params tears;
    tears.tearing = 1;
    EXPECT_TRUE(namesToughness(session, tears)) << "so it does there";
    session.material = "sausage";
    EXPECT_TRUE(namesToughness(session, plain)) << "which has the default's";
    session.material.clear();
    session.events.push_back({3, SetParam{"density", 900.0}});
    EXPECT_FALSE(namesToughness(session, plain));
    session.events.push_back({3, SetParam{"toughness", plain.toughness}});
    EXPECT_TRUE(namesToughness(session, plain));
}

TEST_F(CutReportOfARun, IsNullWithoutACut) {
    EXPECT_TRUE(replayed("").is_null());
    EXPECT_TRUE(replayed(stroke_ + R"(, {"step": 35, "type": "restart"})").is_null());
}

TEST_F(CutReportOfARun, LeavesOutWhatWasUndone) {
    const Json once = replayed(stroke_);
    EXPECT_TRUE(replayed(stroke_ + R"(, {"step": 35, "type": "undo"})").is_null());
    EXPECT_EQ(replayed(stroke_ + R"(, {"step": 34, "type": "undo"}, {"step": 35, "type": "redo"})"),
              once);
}

}  // namespace
}  // namespace kerf::app
