#include <gtest/gtest.h>

#include "sim/mesh/invariants.h"
#include "sim/mesh/piece_figures.h"
#include "sim/mesh/piece_labels.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

const Vec3 kAside(0.1, 0.02, -0.03);

TEST(Cavities, AreOnePieceWithTheShellAround) {
    const TriangleSoup outer = test::icosphereSoup(2);
    const TriangleSoup inner = test::icosphereSoup(2, 0.2);
    const SurfaceMesh mesh = test::hollow(outer, inner, kAside);
    const PieceLabels labels(mesh);
    ASSERT_EQ(labels.pieces().size(), 1u);
    EXPECT_TRUE(labels.hasCavities());
    EXPECT_EQ(labels.pieces()[0].triangles, 640);
    EXPECT_NEAR(labels.pieces()[0].restVolume,
                meshVolume(test::meshOf(outer)) - meshVolume(test::meshOf(inner)), 1e-12);
}

TEST(Cavities, BelongToTheSmallestShellAround) {
    // A shell in the cavity of another one, and a ball apart.
    TriangleSoup nested = test::joined(test::icosphereSoup(3),
                                       test::turned(test::icosphereSoup(3, 0.4)), Vec3::Zero());
    nested = test::joined(nested, test::icosphereSoup(2, 0.3), kAside / 10);
    nested = test::joined(nested, test::turned(test::icosphereSoup(2, 0.2)), kAside / 10);
    nested = test::joined(nested, test::icosphereSoup(1), Vec3(1.5, 0, 0));
    const SurfaceMesh mesh = test::meshOf(nested);
    const PieceLabels labels(mesh);
    ASSERT_EQ(labels.pieces().size(), 3u);
    EXPECT_EQ(labels.pieces()[0].triangles, 2 * 1280);
    EXPECT_EQ(labels.pieces()[1].triangles, 2 * 320);
    EXPECT_EQ(labels.pieces()[2].triangles, 80);
}

TEST(Cavities, DoNotBelongToACoreThatFillsThem) {
    const TriangleSoup core = test::icosphereSoup(2, 0.4);
    TriangleSoup filled = test::joined(test::icosphereSoup(3), test::turned(core), Vec3::Zero());
    filled = test::joined(filled, core, Vec3::Zero());
    const SurfaceMesh mesh = test::meshOf(filled);
    const PieceLabels labels(mesh);
    ASSERT_EQ(labels.pieces().size(), 2u);
    EXPECT_EQ(labels.pieces()[0].triangles, 1280 + 320);
    EXPECT_EQ(labels.pieces()[1].triangles, 320);
    EXPECT_NEAR(labels.pieces()[1].restVolume, meshVolume(test::meshOf(core)), 1e-12);
}

TEST(Cavities, WhatIsInsideOutAndInNothingIsNone) {
    const PieceLabels labels(test::meshOf(test::joined(
        test::icosphereSoup(2), test::turned(test::icosphereSoup(2, 0.2)), Vec3(0.9, 0.02, 0.03))));
    EXPECT_EQ(labels.pieces().size(), 2u);
    EXPECT_FALSE(labels.hasCavities());
}

// As a cut along an older slit may leave them.
TEST(Cavities, CrumbsThatAreInsideOutAreNone) {
    const auto hasCavity = [](double radius) {
        return PieceLabels(
                   test::hollow(test::icosphereSoup(2), test::icosphereSoup(1, radius), kAside))
            .hasCavities();
    };
    EXPECT_FALSE(hasCavity(2e-6));
    EXPECT_TRUE(hasCavity(2e-4));
}

TEST(Cavities, AreCountedInTheFiguresOfTheirPiece) {
    const SurfaceMesh mesh =
        test::hollow(test::boxSoup(Vec3(2, 2, 2)), test::boxSoup(Vec3::Ones()), kAside);
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
