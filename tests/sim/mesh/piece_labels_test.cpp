#include "sim/mesh/piece_labels.h"

#include "tests/sim/body/hand_cut.h"

namespace kerf {
namespace {

/// Labels followed through a cut must name the same pieces as labels made anew.
void expectSamePieces(const PieceLabels& followed, const SurfaceMesh& mesh,
                      PieceLabels::Measures measures = PieceLabels::Measures::volumesAndAreas) {
    const PieceLabels fresh(mesh, measures);
    ASSERT_EQ(followed.pieces().size(), fresh.pieces().size());
    ASSERT_EQ(followed.ofVertex().size(), fresh.ofVertex().size());
    std::vector<int> partner(fresh.pieces().size(), -1);
    for (std::size_t v = 0; v < fresh.ofVertex().size(); ++v) {
        const int label = fresh.ofVertex()[v];
        if (label < 0) {
            ASSERT_LT(followed.ofVertex()[v], 0) << v;
            continue;
        }
        if (partner[label] < 0) {
            partner[label] = followed.ofVertex()[v];
        }
        ASSERT_EQ(followed.ofVertex()[v], partner[label]) << v;
    }
    for (std::size_t p = 0; p < partner.size(); ++p) {
        const PieceContent& a = followed.pieces()[partner[p]];
        const PieceContent& b = fresh.pieces()[p];
        EXPECT_EQ(a.triangles, b.triangles);
        EXPECT_EQ(a.vertices, b.vertices);
        EXPECT_NEAR(a.restVolume, b.restVolume, 1e-12);
        EXPECT_NEAR(a.restArea, b.restArea, 1e-12);
    }
}

TEST(PieceLabels, GoInTheOrderOfTheLowestVertices) {
    const SurfaceMesh mesh =
        meshOf(joined(icosphereSoup(2), boxSoup({0.2, 0.3, 0.4}, 3), {2, 0, 0}));
    const PieceLabels labels(mesh);
    ASSERT_EQ(labels.pieces().size(), 2u);
    EXPECT_EQ(labels.ofVertex().front(), 0);
    EXPECT_EQ(labels.ofVertex().back(), 1);
    EXPECT_EQ(labels.pieces()[0].triangles, 320);
    EXPECT_NEAR(labels.pieces()[1].restVolume, 0.2 * 0.3 * 0.4, 1e-12);
}

TEST(PieceLabels, MeasureVolumesOnceThatIsAskedForAndFollowFromThenOn) {
    SurfaceMesh mesh = box(Vec3::Ones(), 8);
    PieceLabels early(mesh, PieceLabels::Measures::none);
    PieceLabels late = early;
    EXPECT_EQ(early.pieces()[0].restVolume, 0);
    early.measureVolumes(mesh);
    expectSamePieces(early, mesh, PieceLabels::Measures::volumes);
    const CutDelta delta = HandCut(mesh).delta();
    for (PieceLabels* labels : {&early, &late}) {
        labels->update(mesh, changedTriangles(delta));
        labels->measureVolumes(mesh);
        expectSamePieces(*labels, mesh, PieceLabels::Measures::volumes);
    }
}

TEST(PieceLabels, APartThatComesOffGetsALabelOfItsOwn) {
    SurfaceMesh mesh = box(Vec3::Ones(), 8);
    PieceLabels labels(mesh);
    const std::size_t before = labels.ofVertex().size();
    const CutDelta delta = HandCut(mesh).delta();
    const LabelChange change = labels.update(mesh, changedTriangles(delta));
    expectSamePieces(labels, mesh);
    EXPECT_TRUE(change.piecesChanged);
    EXPECT_EQ(change.source, (std::vector<int>{0, 0}));
    for (const LabelMove& move : change.moves) {
        EXPECT_EQ(labels.ofVertex()[move.vertex], move.to);
        EXPECT_EQ(move.from, move.vertex < static_cast<int>(before) ? 0 : -1);
    }
}

TEST(PieceLabels, RestOftenWhileALargePartComesOff) {
    SurfaceMesh mesh = box(Vec3::Ones(), 40);
    PieceLabels labels(mesh);
    const CutDelta delta = HandCut(mesh).delta();
    int rests = 0;
    {
        const Pauses pauses([&] { ++rests; });
        labels.update(mesh, changedTriangles(delta));
    }
    EXPECT_GT(rests, 100) << "for 19,200 triangles";
    expectSamePieces(labels, mesh);
}

TEST(PieceLabels, AChangeOfNothingMovesNothing) {
    const SurfaceMesh mesh = torus();
    PieceLabels labels(mesh);
    const LabelChange change = labels.update(mesh, {});
    EXPECT_TRUE(change.moves.empty());
    EXPECT_FALSE(change.piecesChanged);
    expectSamePieces(labels, mesh);
}

TEST(PieceLabels, ARemovedPieceVanishes) {
    SurfaceMesh mesh = meshOf(joined(boxSoup({0.2, 0.3, 0.4}, 3), icosphereSoup(2), {2, 0, 0}));
    PieceLabels labels(mesh);
    std::vector<int> removed;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (labels.ofVertex()[mesh.triangle(t)[0]] == 0) {
            removed.push_back(t);
        }
    }
    for (const int t : removed) {
        for (const int v : Triangle(mesh.triangle(t))) {
            mesh.setOutgoing(v, -1);
        }
        mesh.removeTriangle(t);
    }
    const LabelChange change = labels.update(mesh, removed);
    expectSamePieces(labels, mesh);
    ASSERT_EQ(labels.pieces().size(), 1u);
    EXPECT_EQ(change.source, (std::vector<int>{1}));
}

TEST(PieceLabels, FollowRandomCutsStepByStep) {
    const unsigned seed = 5;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto direction = [&] {
        return Vec3(uniform(random), uniform(random), uniform(random)).normalized();
    };
    SurfaceMesh mesh = torus();
    PieceLabels labels(mesh);
    for (int stroke = 0; stroke < 5; ++stroke) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", stroke " + std::to_string(stroke));
        const Vec3 along = direction();
        const Vec3 travel = along.cross(direction()).normalized();
        Cutter cutter(mesh, exactSettings());
        const Stroke blades = straightStroke(0.1 * direction(), along, travel, 3, 2, 25);
        eachStep(cutter, blades, [&](const CutResult& result) {
            labels.update(mesh, changedTriangles(result.delta));
            expectSamePieces(labels, mesh);
        });
    }
    EXPECT_GT(labels.pieces().size(), 3u);
}

TEST(PieceLabels, FollowCutsOfAHollowBody) {
    SurfaceMesh mesh = hollow(icosphereSoup(3), icosphereSoup(2, 0.25), Vec3(0.02, 0, 0.01));
    PieceLabels labels(mesh);
    Cutter cutter(mesh, exactSettings());
    const Stroke stroke =
        straightStroke({0.013, 0.021, 0.034}, Vec3::UnitX(), -Vec3::UnitY(), 3, 2.4, 60);
    int changes = 0;
    cutter.begin(stroke.front());
    for (const Blade& blade : stroke) {
        const CutResult result = cutter.advance(blade);
        const LabelChange change = labels.update(mesh, changedTriangles(result.delta));
        expectSamePieces(labels, mesh);
        changes += change.piecesChanged ? 1 : 0;
    }
    EXPECT_EQ(labels.pieces().size(), 2u);
    EXPECT_EQ(changes, 1) << "while shell and cavity are cut apart they are one piece still";
}

PieceFigures figuresAt(const SurfaceMesh& mesh, int triangle) {
    return figuresOfPiece(mesh, PieceShells(mesh), triangle);
}

TEST(PieceFigures, OfABoxAreThoseOfABox) {
    const PieceFigures box = figuresAt(test::box(Vec3(1, 2, 3), 3), 0);
    EXPECT_EQ(box.triangles, 108);
    EXPECT_NEAR(box.volume, 6, 1e-9);
    EXPECT_NEAR(box.skinArea, 22, 1e-9);
    EXPECT_EQ(box.cutArea, 0);
    EXPECT_NEAR(box.centroid.norm(), 0, 1e-9);
    EXPECT_NEAR((box.bounds.high - box.bounds.low - Vec3(1, 2, 3)).norm(), 0, 1e-9);
}

TEST(PieceFigures, OfASphereAreNearlyThoseOfABall) {
    const PieceFigures ball = figuresAt(icosphere(4, 0.5), 7);
    EXPECT_NEAR(ball.volume, std::numbers::pi / 6, 0.005);
    EXPECT_NEAR(ball.area(), std::numbers::pi, 0.01);
}

TEST(PieceFigures, AreThoseOfOnePieceOfSeveral) {
    const TriangleSoup both =
        joined(boxSoup(Vec3::Ones(), 1), boxSoup(Vec3(1, 1, 3), 1), Vec3(5, 0, 0));
    const SurfaceMesh mesh = meshOf(both);
    EXPECT_NEAR(figuresAt(mesh, 0).volume, 1, 1e-9);
    const PieceFigures second = figuresAt(mesh, 12);
    EXPECT_NEAR(second.volume, 3, 1e-9);
    EXPECT_NEAR((second.centroid - Vec3(5, 0, 0)).norm(), 0, 1e-9);
}

const Vec3 kAside(0.1, 0.02, -0.03);

TEST(Cavities, AreOnePieceWithTheShellAround) {
    const TriangleSoup outer = icosphereSoup(2);
    const TriangleSoup inner = icosphereSoup(2, 0.2);
    const SurfaceMesh mesh = hollow(outer, inner, kAside);
    const PieceLabels labels(mesh);
    ASSERT_EQ(labels.pieces().size(), 1u);
    EXPECT_TRUE(labels.hasCavities());
    EXPECT_EQ(labels.pieces()[0].triangles, 640);
    EXPECT_NEAR(labels.pieces()[0].restVolume,
                meshVolume(meshOf(outer)) - meshVolume(meshOf(inner)), 1e-12);
}

TEST(Cavities, BelongToTheSmallestShellAround) {
    // A shell in the cavity of another one, and a ball apart.
    TriangleSoup nested = joined(icosphereSoup(3), turned(icosphereSoup(3, 0.4)), Vec3::Zero());
    nested = joined(nested, icosphereSoup(2, 0.3), kAside / 10);
    nested = joined(nested, turned(icosphereSoup(2, 0.2)), kAside / 10);
    nested = joined(nested, icosphereSoup(1), Vec3(1.5, 0, 0));
    const SurfaceMesh mesh = meshOf(nested);
    const PieceLabels labels(mesh);
    ASSERT_EQ(labels.pieces().size(), 3u);
    EXPECT_EQ(labels.pieces()[0].triangles, 2 * 1280);
    EXPECT_EQ(labels.pieces()[1].triangles, 2 * 320);
    EXPECT_EQ(labels.pieces()[2].triangles, 80);
}

TEST(Cavities, DoNotBelongToACoreThatFillsThem) {
    const TriangleSoup core = icosphereSoup(2, 0.4);
    TriangleSoup filled = joined(icosphereSoup(3), turned(core), Vec3::Zero());
    filled = joined(filled, core, Vec3::Zero());
    const SurfaceMesh mesh = meshOf(filled);
    const PieceLabels labels(mesh);
    ASSERT_EQ(labels.pieces().size(), 2u);
    EXPECT_EQ(labels.pieces()[0].triangles, 1280 + 320);
    EXPECT_EQ(labels.pieces()[1].triangles, 320);
    EXPECT_NEAR(labels.pieces()[1].restVolume, meshVolume(meshOf(core)), 1e-12);
}

TEST(Cavities, WhatIsInsideOutAndInNothingIsNone) {
    const PieceLabels labels(
        meshOf(joined(icosphereSoup(2), turned(icosphereSoup(2, 0.2)), Vec3(0.9, 0.02, 0.03))));
    EXPECT_EQ(labels.pieces().size(), 2u);
    EXPECT_FALSE(labels.hasCavities());
}

// As a cut along an older slit may leave them.
TEST(Cavities, CrumbsThatAreInsideOutAreNone) {
    const auto hasCavity = [](double radius) {
        return PieceLabels(hollow(icosphereSoup(2), icosphereSoup(1, radius), kAside))
            .hasCavities();
    };
    EXPECT_FALSE(hasCavity(2e-6));
    EXPECT_TRUE(hasCavity(2e-4));
}

TEST(Cavities, AreCountedInTheFiguresOfTheirPiece) {
    const SurfaceMesh mesh = hollow(boxSoup(Vec3(2, 2, 2)), boxSoup(Vec3::Ones()), kAside);
    const PieceShells shells(mesh);
    for (const int triangle : {0, 12}) {
        const PieceFigures figures = figuresOfPiece(mesh, shells, triangle);
        EXPECT_EQ(figures.triangles, 24);
        EXPECT_NEAR(figures.volume, 7, 1e-12);
        EXPECT_NEAR(figures.skinArea, 24 + 6, 1e-12);
        EXPECT_NEAR((figures.centroid + kAside / 7).norm(), 0, 1e-12);
    }
}

}  // namespace
}  // namespace kerf
