#include "sim/mesh/piece_figures.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace kerf {
namespace {

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
    const PieceFigures ball = figuresAt(test::icosphere(4, 0.5), 7);
    EXPECT_NEAR(ball.volume, std::numbers::pi / 6, 0.005);
    EXPECT_NEAR(ball.area(), std::numbers::pi, 0.01);
}

TEST(PieceFigures, AreThoseOfOnePieceOfSeveral) {
    const TriangleSoup both = test::joined(test::boxSoup(Vec3::Ones(), 1),
                                           test::boxSoup(Vec3(1, 1, 3), 1), Vec3(5, 0, 0));
    const SurfaceMesh mesh = test::meshOf(both);
    EXPECT_NEAR(figuresAt(mesh, 0).volume, 1, 1e-9);
    const PieceFigures second = figuresAt(mesh, 12);
    EXPECT_NEAR(second.volume, 3, 1e-9);
    EXPECT_NEAR((second.centroid - Vec3(5, 0, 0)).norm(), 0, 1e-9);
}

}  // namespace
}  // namespace kerf
