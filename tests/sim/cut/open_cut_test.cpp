// The open cut: hollow while the blade moves, patched when the stroke ends.

#include "tests/support/open_manifold.h"

namespace kerf {
namespace {

CutSettings openSettings() {
    CutSettings settings = exactSettings();
    settings.offset = 1e-10;
    settings.tolerance = 1e-12;
    settings.openCut = true;
    return settings;
}

Stroke through(const Vec3& center, const Vec3& along, const Vec3& travel) {
    return straightStroke(center, along, travel, 3.0, 2.4, 40);
}

/// What a body is made of while its stroke is open.
void expectOpen(const SurfaceMesh& mesh, const BodyModel& model) {
    EXPECT_EQ(checkOpenManifold(mesh), "");
    const std::size_t absent = absentTriangles(mesh).size();
    EXPECT_EQ(model.triangles.size() + absent, static_cast<std::size_t>(mesh.aliveTriangles()));
    const std::size_t border = borderHalfEdges(mesh).size();
    EXPECT_GT(border, 0u);
    EXPECT_EQ(2 * model.edges.size(), 3 * model.triangles.size() + border);
    for (const BendConstraint& bend : model.bends) {
        const int h = mesh.findHalfEdge(static_cast<int>(bend.v0), static_cast<int>(bend.v1));
        EXPECT_TRUE(mesh.present(h / 3) && mesh.present(mesh.twin(h) / 3));
    }
    for (const int t : model.ispcMeshTriangle) {
        EXPECT_TRUE(mesh.present(t));
    }
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        EXPECT_TRUE(!hidden(mesh, v) || unitMass(model, v) == 0);
    }
}

/// The parts that a later step follows as a model built anew has them.
void expectSameModel(const BodyModel& followed, const BodyModel& fresh) {
    EXPECT_EQ(followed.triangles.size(), fresh.triangles.size());
    EXPECT_EQ(followed.edges.size(), fresh.edges.size());
    EXPECT_EQ(followed.bends.size(), fresh.bends.size());
    ASSERT_EQ(followed.pieces.size(), fresh.pieces.size());
    // Pieces that came off may have other numbers.
    for (std::size_t v = 0; v < fresh.pieceOfVertex.size(); ++v) {
        const int a = followed.pieceOfVertex[v];
        const int b = fresh.pieceOfVertex[v];
        ASSERT_EQ(a < 0, b < 0);
        if (a >= 0) {
            ASSERT_EQ(followed.pieces[a].vertexCount, fresh.pieces[b].vertexCount);
            ASSERT_EQ(followed.pieces[a].triangleCount, fresh.pieces[b].triangleCount);
            ASSERT_EQ(followed.pieces[a].open, fresh.pieces[b].open);
            ASSERT_EQ(followed.pieces[a].holdsVolume, fresh.pieces[b].holdsVolume);
        }
    }
}

double massOf(const BodyModel& model) {
    double sum = 0;
    for (const double mass : unitMasses(model)) {
        sum += mass;
    }
    return sum;
}

struct Outcome {
    int openSteps = 0;
    WoundClosing closing;
};

/// A stroke with its body; both are checked in every step.
Outcome runOpen(SurfaceMesh& mesh, const CutSettings& settings, const Stroke& stroke) {
    Outcome outcome;
    Cutter cutter(mesh, settings);
    BodyUpdater body(mesh);
    const double mass = massOf(body.model());
    cutter.begin(stroke.front());
    const auto follow = [&](const CutResult& result) {
        EXPECT_NE(result.outcome, CutOutcome::refused) << result.reason;
        EXPECT_EQ(checkClosedManifold(mesh), "");
        body.update(result.delta);
        EXPECT_NEAR(massOf(body.model()), mass, 1e-6 * mass);
    };
    for (std::size_t i = 1; i < stroke.size(); ++i) {
        follow(cutter.advance(stroke[i]));
        if (!absentTriangles(mesh).empty()) {
            ++outcome.openSteps;
            EXPECT_FALSE(borderHalfEdges(mesh).empty());
            bool anyOpen = false;
            for (const PieceModel& piece : body.model().pieces) {
                anyOpen = anyOpen || piece.open;
                EXPECT_FALSE(piece.open && piece.holdsVolume);
            }
            EXPECT_TRUE(anyOpen);
            if (outcome.openSteps % 8 == 1) {
                expectOpen(mesh, body.model());
                expectSameModel(body.model(), buildBodyModel(mesh));
            }
        }
    }
    const CutResult end = cutter.finish();
    follow(end);
    outcome.closing = end.statistics.closing;
    EXPECT_LT(mesh.openStroke(), 0);
    EXPECT_TRUE(absentTriangles(mesh).empty());
    EXPECT_EQ(checkMirroredWalls(mesh), "");
    const BodyModel fresh = buildBodyModel(mesh);
    expectSameModel(body.model(), fresh);
    EXPECT_EQ(body.model().ispcs.size(), fresh.ispcs.size());
    EXPECT_EQ(2 * fresh.edges.size(), 3 * fresh.triangles.size());
    return outcome;
}

void expectHalves(const SurfaceMesh& whole, const Stroke& stroke, const Vec3& point,
                  const Vec3& normal, int wounds) {
    const HalfSpaceVolumes expected = clipVolumes(whole, point, normal);
    for (const bool cleanUp : {false, true}) {
        SCOPED_TRACE(cleanUp ? "with clean-up" : "without clean-up");
        SurfaceMesh mesh = whole;
        CutSettings settings = openSettings();
        settings.cleanUp = cleanUp;
        const Outcome outcome = runOpen(mesh, settings, stroke);
        EXPECT_GT(outcome.openSteps, 10);
        EXPECT_EQ(outcome.closing.patches, wounds);
        EXPECT_EQ(outcome.closing.unpatched, 0) << outcome.closing.reason;
        EXPECT_EQ(outcome.closing.slits, 0);
        const PieceMap map = findPieces(mesh);
        ASSERT_EQ(map.pieces.size(), 2u);
        // In a planar loop a flat patch is the wall. Clean-up moves rims and keeps volume by the
        // wall's inner points, which a patch has not.
        const double tolerance = (cleanUp ? 5e-4 : 1e-9) * meshVolume(whole);
        for (int p = 0; p < 2; ++p) {
            const bool above = meanSide(mesh, map, p, point, normal) > 0;
            EXPECT_NEAR(map.pieces[p].volume, above ? expected.above : expected.below, tolerance);
        }
    }
}

TEST(OpenCut, SphereInTwo) {
    const Vec3 center(0.013, 0.021, 0.034);
    expectHalves(icosphere(3), through(center, Vec3::UnitX(), -Vec3::UnitY()), center,
                 Vec3::UnitZ(), 1);
}

TEST(OpenCut, CoarseSpheresInTwo) {
    const Vec3 center(0.013, 0.021, 0.034);
    for (const int subdivisions : {0, 1}) {
        expectHalves(icosphere(subdivisions), through(center, Vec3::UnitX(), -Vec3::UnitY()),
                     center, Vec3::UnitZ(), 1);
    }
}

TEST(OpenCut, BoxInTwoAlongItsEdgesAndBetweenThem) {
    for (const double z : {0.0, 0.07}) {
        const Vec3 center(0.003, 0.001, z);
        expectHalves(box(Vec3::Ones(), 4), through(center, Vec3::UnitX(), -Vec3::UnitY()), center,
                     Vec3::UnitZ(), 1);
    }
}

TEST(OpenCut, TorusAcrossHasALoopInEachArm) {
    const Vec3 center(0.003, 0.001, 0.007);
    expectHalves(torus(), through(center, Vec3::UnitX(), -Vec3::UnitY()), center, Vec3::UnitZ(), 2);
}

TEST(OpenCut, TorusInItsPlanePairsTheOuterLoopWithTheInner) {
    const Vec3 center(0.003, 0.0012, 0.007);
    SurfaceMesh mesh = torus();
    expectHalves(mesh, through(center, Vec3::UnitX(), Vec3::UnitZ()), center, Vec3::UnitY(), 1);
    // Each half is a ring still: V - E + F = 0.
    runOpen(mesh, openSettings(), through(center, Vec3::UnitX(), Vec3::UnitZ()));
    const PieceMap map = findPieces(mesh);
    for (const Piece& piece : map.pieces) {
        EXPECT_EQ(2 * piece.vertices, piece.triangles);
    }
}

TEST(OpenCut, AnIncisionEndsAsInTheClosedCourse) {
    const Stroke stroke =
        straightStroke(Vec3(0.02, 0.63, 0.013), Vec3::UnitY(), Vec3::UnitX(), 0.8, 0.5, 24);
    SurfaceMesh open = icosphere(3);
    const Outcome outcome = runOpen(open, openSettings(), stroke);
    EXPECT_EQ(outcome.closing.slits, 1);
    EXPECT_EQ(outcome.closing.patches, 0);
    SurfaceMesh closed = icosphere(3);
    CutSettings settings = openSettings();
    settings.openCut = false;
    runStroke(closed, settings, stroke);
    EXPECT_GT(open.aliveTriangles(), 1280);
    EXPECT_EQ(fingerprint(open), fingerprint(closed));
}

TEST(OpenCut, APatchMayBeCutAgain) {
    SurfaceMesh mesh = icosphere(3);
    const double whole = meshVolume(mesh);
    const Vec3 center(0.013, 0.021, 0.034);
    CutSettings settings = openSettings();
    runOpen(mesh, settings, through(center, Vec3::UnitX(), -Vec3::UnitY()));
    const Outcome second =
        runOpen(mesh, settings, through(center, Vec3(0.1, 0, 1).normalized(), -Vec3::UnitY()));
    EXPECT_EQ(second.closing.patches, 2);
    EXPECT_EQ(findPieces(mesh).pieces.size(), 4u);
    EXPECT_NEAR(meshVolume(mesh), whole, 1e-6 * whole);
}

TEST(OpenCut, CurvedStrokesCloseEitherWay) {
    constexpr unsigned kSeed = 20261;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> any(-1, 1);
    int patches = 0;
    for (int run = 0; run < 12; ++run) {
        SCOPED_TRACE("run " + std::to_string(run) + " of seed " + std::to_string(kSeed));
        SurfaceMesh mesh = run % 3 == 0 ? icosphere(2) : run % 3 == 1 ? torus(24, 12) : bentTube();
        const double whole = meshVolume(mesh);
        const double bend = 0.3 * any(random);
        const double twist = 0.4 * any(random);
        const double z = 0.1 * any(random);
        Stroke stroke;
        for (int i = 0; i <= 40; ++i) {
            const double s = i / 20.0 - 1;
            const Vec3 along(std::cos(twist * s), 0, std::sin(twist * s));
            const Vec3 middle(0.01, -1.1 * s, z + bend * s * s);
            stroke.push_back({middle - 1.5 * along, middle + 1.5 * along});
        }
        CutSettings settings;
        settings.openCut = true;
        const Outcome outcome = runOpen(mesh, settings, stroke);
        patches += outcome.closing.patches;
        EXPECT_NEAR(meshVolume(mesh), whole, 1e-6 * whole);
    }
    EXPECT_GE(patches, 8);
}

}  // namespace
}  // namespace kerf
