#include <gtest/gtest.h>

#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/invariants.h"
#include "tests/support/cut_strokes.h"
#include "tests/support/shapes.h"
#include "tests/support/sound_strokes.h"

namespace kerf {
namespace {

using test::CutCheck;
using test::piecesOf;
using test::Stroke;

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

void expectSound(const CutCheck& check) {
    EXPECT_EQ(check.problem, "");
    EXPECT_EQ(check.unmirrored, "");
    EXPECT_EQ(check.refused, 0) << check.reason;
}

// Exactly along the older cut, and a twentieth of an edge beside it.
TEST(Retrace, AlongACutThatWentThroughCutsNothing) {
    for (const double beside : {0.0, 0.004}) {
        SCOPED_TRACE(beside);
        SurfaceMesh mesh = test::icosphere(3);
        Cutter cutter(mesh, CutSettings{});
        expectSound(test::runStroke(cutter, mesh, along(-1, 0.013, -0.8, 0.8)));
        ASSERT_EQ(piecesOf(mesh), 2);
        const int triangles = mesh.aliveTriangles();
        const CutCheck again = test::runStroke(cutter, mesh, along(-1, 0.013 + beside, -0.8, 0.8));
        expectSound(again);
        EXPECT_EQ(again.cuts, 0);
        EXPECT_EQ(piecesOf(mesh), 2);
        EXPECT_EQ(mesh.aliveTriangles(), triangles);
    }
}

TEST(Retrace, ADeeperCutGoesOnFromTheEndOfTheSlit) {
    for (const bool backwards : {false, true}) {
        SCOPED_TRACE(backwards ? "backwards" : "forwards");
        SurfaceMesh mesh = test::icosphere(3);
        Cutter cutter(mesh, CutSettings{});
        expectSound(test::runStroke(cutter, mesh, along(0.2, 0.013, -0.8, 0.8)));
        ASSERT_EQ(piecesOf(mesh), 1);
        const double from = backwards ? 0.8 : -0.8;
        const CutCheck deeper = test::runStroke(cutter, mesh, along(-1, 0.013, from, -from));
        expectSound(deeper);
        EXPECT_GT(deeper.cuts, 0);
        EXPECT_EQ(piecesOf(mesh), 2) << "no slab comes off between the two cuts";
        EXPECT_EQ(test::slitEdges(mesh, 1), 0);
        EXPECT_LE(deeper.quality.all().below002, deeper.quality.all().triangles / 20);
    }
}

// Strokes of the fuzz: turned back in their own cut, or ran along earlier ones.
TEST(Retrace, FuzzedStrokesAreNeitherRefusedNorLoseTheirMirrors) {
    for (const std::uint64_t seed : {70599, 80006, 80057, 80178, 81459, 81469, 81943}) {
        for (const test::FuzzFigures& figures : test::expectSoundStrokes(seed)) {
            EXPECT_EQ(figures.unmirrored, 0) << "seed " << seed;
        }
    }
}

// On floats. Not seen open any more, the facing wall lay on the end of the front: the rung ran on
// into it, and what lay behind stayed as a bridge of one edge.
TEST(Retrace, ABladeThatLeavesAnOlderSlitAtAnAnglePartsTheBody) {
    for (const test::FuzzFigures& figures : test::expectSoundStrokes(81756)) {
        EXPECT_EQ(figures.slitEnds, 0);
        EXPECT_EQ(figures.unmirrored, 0);
    }
}

}  // namespace
}  // namespace kerf
