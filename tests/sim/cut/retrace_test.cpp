#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/stroke/group_stroke.h"
#include "sim/mesh/union_find.h"

namespace kerf::cut {
namespace {

/// Runs a seed of the fuzz and expects valid meshes, no refusals, and pieces that came apart.
/// Returns what happened by setting, for what else is to be expected.
std::vector<FuzzFigures> expectSoundStrokes(std::uint64_t seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    FuzzReport report;
    fuzzOnce(seed, report);
    std::vector<FuzzFigures> totals;
    for (const FuzzSetting setting : kFuzzSettings) {
        totals.push_back(report.total(setting));
        EXPECT_EQ(totals.back().invalid, 0);
        EXPECT_EQ(totals.back().refused, 0);
        EXPECT_EQ(totals.back().unseparated, 0);
    }
    return totals;
}

// The blade hangs from above, its tip at height `tipY`, and goes along x through the unit sphere.
Stroke along(double tipY, double z, double fromX, double toX) {
    constexpr int kSteps = 40;
    Stroke stroke;
    for (int i = 0; i <= kSteps; ++i) {
        const double x = fromX + (toX - fromX) * i / kSteps;
        stroke.push_back({{x, 1.5, z}, {x, tipY, z}});
    }
    return stroke;
}

// Exactly along the older cut, and a twentieth of an edge beside it.
TEST(Retrace, AlongACutThatWentThroughCutsNothing) {
    for (const double beside : {0.0, 0.004}) {
        SCOPED_TRACE(beside);
        SurfaceMesh mesh = icosphere(3);
        Cutter cutter(mesh, CutSettings{});
        expectSound(runStroke(cutter, mesh, along(-1, 0.013, -0.8, 0.8)));
        ASSERT_EQ(piecesOf(mesh), 2);
        const int triangles = mesh.aliveTriangles();
        const CutCheck again = runStroke(cutter, mesh, along(-1, 0.013 + beside, -0.8, 0.8));
        expectSound(again);
        EXPECT_EQ(again.cuts, 0);
        EXPECT_EQ(piecesOf(mesh), 2);
        EXPECT_EQ(mesh.aliveTriangles(), triangles);
    }
}

TEST(Retrace, ADeeperCutGoesOnFromTheEndOfTheSlit) {
    for (const bool backwards : {false, true}) {
        SCOPED_TRACE(backwards ? "backwards" : "forwards");
        SurfaceMesh mesh = icosphere(3);
        Cutter cutter(mesh, CutSettings{});
        expectSound(runStroke(cutter, mesh, along(0.2, 0.013, -0.8, 0.8)));
        ASSERT_EQ(piecesOf(mesh), 1);
        const double from = backwards ? 0.8 : -0.8;
        const CutCheck deeper = runStroke(cutter, mesh, along(-1, 0.013, from, -from));
        expectSound(deeper);
        EXPECT_GT(deeper.cuts, 0);
        EXPECT_EQ(piecesOf(mesh), 2) << "no slab comes off between the two cuts";
        EXPECT_EQ(slitEdges(mesh, 1), 0);
        EXPECT_LE(deeper.quality.all().below002, deeper.quality.all().triangles / 20);
    }
}

// Strokes of the fuzz: turned back in their own cut, or ran along earlier ones.
TEST(Retrace, FuzzedStrokesAreNeitherRefusedNorLoseTheirMirrors) {
    for (const std::uint64_t seed : {70599, 80006, 80057, 80178, 81459, 81469, 81943}) {
        for (const FuzzFigures& figures : expectSoundStrokes(seed)) {
            EXPECT_EQ(figures.unmirrored, 0) << "seed " << seed;
        }
    }
}

// On floats. Not seen open any more, the facing wall lay on the end of the front: the rung ran on
// into it, and what lay behind stayed as a bridge of one edge.
TEST(Retrace, ABladeThatLeavesAnOlderSlitAtAnAnglePartsTheBody) {
    for (const FuzzFigures& figures : expectSoundStrokes(81756)) {
        EXPECT_EQ(figures.slitEnds, 0);
        EXPECT_EQ(figures.unmirrored, 0);
    }
}

constexpr double kH = 0.1;

std::vector<RungNode> rungAlongY() {
    std::vector<RungNode> rung;
    for (const double s : {0.0, 0.4, 0.4001, 0.6, 1.0}) {
        rung.push_back({{0, s, 0}, s, s > 0 && s < 1 ? 1 : -1, false});
    }
    return rung;
}

Blade bladeAhead(double way) {
    return {{way, 0, 0}, {way, 1, 0}};
}

// The old walls lie in z = 0 and end at x = 0.
TEST(Resume, TheNewStripCrossesTheOldWallsAndEndsCloseBesideTheBlade) {
    for (const double way : {0.1 * kH, kH, 8 * kH}) {
        SCOPED_TRACE(way);
        const std::vector<Resumption> ways = resumptions(rungAlongY(), bladeAhead(way), kH);
        ASSERT_FALSE(ways.empty());
        for (const Resumption& crossing : ways) {
            const Vec3& start = crossing.rung.front().position;
            const Vec3& end = crossing.blade.a;
            ASSERT_LT(start.z() * end.z(), 0) << "one on each side";
            const double share = start.z() / (start.z() - end.z());
            EXPECT_NEAR(start.x() + share * (end.x() - start.x()), -0.35 * kH, 1e-12);
            EXPECT_GT(end.x(), 0);
            EXPECT_LT(end.x(), way + 1e-12);
            EXPECT_LT(end.x(), 0.7 * kH);
            EXPECT_LT(std::fabs(end.z()), 0.3 * kH);
        }
    }
}

TEST(Resume, TheNewRungHasNothingInCommonWithTheFront) {
    for (const Resumption& resumption : resumptions(rungAlongY(), bladeAhead(kH), kH)) {
        ASSERT_EQ(resumption.rung.size(), 4U) << "a crowd becomes one node";
        for (const RungNode& node : resumption.rung) {
            EXPECT_LT(node.vertex, 0);
            EXPECT_FALSE(node.attached);
        }
    }
}

TEST(Resume, ABladeThatStandsHasNoWayOn) {
    EXPECT_TRUE(resumptions(rungAlongY(), bladeAhead(0), kH).empty());
}

// Strokes of the fuzz whose fronts crumple where three cuts meet within a thousandth of an edge.
// The first one built walls far outside the body at what was then the last level of the ladder.
TEST(Resume, CrumpledFrontsAreCutAnewAndTheBodyParts) {
    int resumed = 0;
    for (const std::uint64_t seed : {201160, 300344, 300617, 300945, 302320}) {
        for (const FuzzFigures& figures : expectSoundStrokes(seed)) {
            EXPECT_EQ(figures.outside, 0) << "seed " << seed;
            resumed += figures.resumed;
        }
    }
    EXPECT_GT(resumed, 0);
}

// What moves may let the blade through in the next step.
TEST(Resume, InABodyThatMovesTheBladeWaitsFirst) {
    const auto played = [](const Vec3& velocity) {
        FuzzReport report;
        fuzzOnce(401098, report, {}, velocity);
        FuzzFigures sum;
        for (const FuzzSetting setting : kFuzzSettings) {
            const FuzzFigures figures = report.total(setting);
            EXPECT_EQ(figures.invalid, 0);
            sum.refused += figures.refused;
            sum.resumed += figures.resumed;
        }
        return sum;
    };
    const FuzzFigures still = played(Vec3::Zero());
    const FuzzFigures moving = played({0, -1, 0});
    EXPECT_GT(still.resumed, 0);
    EXPECT_EQ(still.refused, 0);
    EXPECT_GT(moving.refused, 0);
    EXPECT_LE(moving.resumed, still.resumed);
}

// Cut steeply, the pieces reached 0.6 of an edge to the other side of the blade.
TEST(Resume, WhatIsCutAnewStaysCloseToTheBlade) {
    int resumed = 0;
    for (const FuzzFigures& figures : expectSoundStrokes(401098)) {
        EXPECT_EQ(figures.unmirrored, 0);
        resumed += figures.resumed;
    }
    EXPECT_GT(resumed, 0);
}

// Of the blade, share of an edge: the parts differ by the volume that it has swept.
constexpr double kOffset = 1e-10;

/// Pieces that the plane makes, independent of the cutter: vertices joined by edges that stay on
/// one side. Right where no part's cap has a hole.
int partsBeside(const SurfaceMesh& mesh, const Vec3& point, const Vec3& normal) {
    UnionFind parts(mesh.vertexCount());
    const auto side = [&](int v) { return (mesh.position(v) - point).dot(normal) > 0; };
    std::set<int> roots;
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        if (side(mesh.origin(h)) == side(mesh.target(h))) {
            parts.join(mesh.origin(h), mesh.target(h));
        }
    }
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        roots.insert(parts.root(v));
    }
    return static_cast<int>(roots.size());
}

void expectPlanarHalves(const SurfaceMesh& whole, const Stroke& stroke, const Vec3& point,
                        const Vec3& normal, int pieces) {
    const HalfSpaceVolumes expected = clipVolumes(whole, point, normal);
    const double volume = meshVolume(whole);
    for (const bool cleanUp : {false, true}) {
        SCOPED_TRACE(cleanUp ? "with clean-up" : "without clean-up");
        SurfaceMesh mesh = whole;
        CutSettings settings = exactSettings();
        settings.offset = kOffset;
        settings.tolerance = 0.01 * kOffset;
        settings.cleanUp = cleanUp;
        const CutCheck check = runStroke(mesh, settings, stroke);
        expectSound(check);
        EXPECT_GT(check.cuts, 0);
        const PieceMap map = findPieces(mesh);
        EXPECT_EQ(static_cast<int>(map.pieces.size()), pieces);
        double above = 0;
        double below = 0;
        for (int p = 0; p < static_cast<int>(map.pieces.size()); ++p) {
            (meanSide(mesh, map, p, point, normal) > 0 ? above : below) += map.pieces[p].volume;
        }
        const double tolerance = (cleanUp ? 1e-7 : 1e-9) * volume;
        EXPECT_NEAR(above, expected.above, tolerance);
        EXPECT_NEAR(below, expected.below, tolerance);
        EXPECT_NEAR(above + below, volume, tolerance);
    }
}

/// Blade along `along`, moving in direction `travel`, through `center`; it clears a unit body.
Stroke planarStroke(const Vec3& center, const Vec3& along, const Vec3& travel, int steps) {
    return straightStroke(center, along, travel, 3.0, 2.4, steps);
}

TEST(PlanarCut, PartsRoundBodiesInTwo) {
    struct Row {
        const char* name;
        SurfaceMesh mesh;
        Vec3 center, along, travel;
        int steps = 60;
    };
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    const Vec3 beside(0.013, 0.021, 0.034);
    const Vec3 inRing(0.003, 0.0012, 0.007);
    for (const Row& row :
         std::vector<Row>{{"a coarse sphere", icosphere(0), beside, x, -y},
                          {"a sphere less coarse", icosphere(1), beside, x, -y},
                          {"a sphere", icosphere(3), beside, x, -y},
                          {"a sphere in one giant step", icosphere(3), inRing, x, z, 1},
                          {"a torus into two arches", torus(), {0.003, 0.001, 0.007}, x, -y},
                          {"a torus into two rings", torus(), inRing, x, z},
                          {"rings in one giant step", torus(), inRing, x, z, 1},
                          {"a bent tube", bentTube(), {0.02, 0.01, 0.0}, z, -y}}) {
        SCOPED_TRACE(row.name);
        const Vec3 normal = row.along.cross(row.travel).cwiseAbs();
        expectPlanarHalves(row.mesh, planarStroke(row.center, row.along, row.travel, row.steps),
                           row.center, normal, 2);
    }
}

TEST(PlanarCut, ThroughVerticesAndAlongEdges) {
    // The planes z = 0 and x = 0 hold vertices and edges of the icosphere and of the torus.
    for (const SurfaceMesh& mesh : {icosphere(2), torus(), cubeSphere(8)}) {
        expectPlanarHalves(mesh, planarStroke(Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitY(), 48),
                           Vec3::Zero(), Vec3::UnitZ(), 2);
        expectPlanarHalves(mesh, planarStroke(Vec3::Zero(), Vec3::UnitZ(), -Vec3::UnitY(), 48),
                           Vec3::Zero(), Vec3::UnitX(), 2);
    }
}

TEST(PlanarCut, OctopusLosesItsArmsToOnePlane) {
    const SurfaceMesh octopus = builtin("octopus");
    const Bounds bounds = meshBounds(octopus);
    for (const int axis : {1, 2}) {
        SCOPED_TRACE("axis " + std::to_string(axis));
        const Vec3 normal = Vec3::Unit(axis);
        const Vec3 center = bounds.center() - 0.171 * bounds.diagonal() * normal;
        const int parts = partsBeside(octopus, center, normal);
        EXPECT_GT(parts, 1);
        expectPlanarHalves(
            octopus,
            straightStroke(center, Vec3::Unit((axis + 1) % 3), Vec3::Unit((axis + 2) % 3),
                           2.6 * bounds.diagonal(), 2.3 * bounds.diagonal(), 40),
            center, normal, parts);
    }
}

}  // namespace
}  // namespace kerf::cut
