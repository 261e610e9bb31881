#include "bench/lab/fem/solid_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "bench/lab/fem/solid_solver.h"
#include "sim/mesh/invariants.h"

namespace kerf {
namespace {

const std::array<GridLines, 3> kLines{gridLinesThrough(-0.2, -0.05, 0.2, 2),
                                      evenGridLines(-0.1, 0.1, 4), evenGridLines(-0.1, 0.1, 4)};

/// Its skin without the nodes inside.
SurfaceMesh skinOf(const SolidMesh& mesh) {
    std::vector<Triangle> skin = mesh.skin;
    std::vector<int> number(mesh.nodes.size(), -1);
    std::vector<Vec3> used;
    for (Triangle& t : skin) {
        for (int& v : t) {
            if (number[v] < 0) {
                number[v] = static_cast<int>(used.size());
                used.push_back(mesh.nodes[v]);
            }
            v = number[v];
        }
    }
    return SurfaceMesh::fromTriangles(used, skin);
}

TEST(SolidMesh, GridLinesGoThroughTheMiddleOneInEvenSteps) {
    const GridLines lines = gridLinesThrough(-0.2, -0.05, 0.2, 3);
    ASSERT_EQ(lines.size(), 9u);
    EXPECT_EQ(lines.front(), -0.2);
    EXPECT_EQ(lines[3], -0.05);
    EXPECT_EQ(lines.back(), 0.2);
    EXPECT_THROW(gridLinesThrough(0, 0, 1, 3), std::invalid_argument);
}

TEST(SolidMesh, ABoxHasAClosedSkinAroundItsVolume) {
    const SolidMesh mesh = solidBox(kLines);
    EXPECT_EQ(mesh.tetrahedra.size(), 5u * 4 * 4 * 6);
    EXPECT_EQ(mesh.nodes.size(), 11u * 9 * 9);
    EXPECT_NEAR(solidVolume(mesh, mesh.nodes), 0.4 * 0.2 * 0.2, 1e-15);
    EXPECT_EQ(checkClosedManifold(skinOf(mesh)), "");
    EXPECT_TRUE(mesh.lips.empty());
}

TEST(SolidMesh, ASlitOpensTheSkinAndTakesNoVolume) {
    const SolidMesh mesh = solidBox(kLines, Slit{-0.05, 0, 1});
    // Above its bottom, nodes of 4 of 8 rows and all 9 columns are there twice.
    EXPECT_EQ(mesh.nodes.size(), 11u * 9 * 9 + 4 * 9);
    EXPECT_EQ(mesh.lips.size(), 4u * 9);
    EXPECT_EQ(mesh.skin.size(), solidBox(kLines).skin.size() + 2 * 4 * 2 * 4 * 2);
    EXPECT_NEAR(solidVolume(mesh, mesh.nodes), 0.4 * 0.2 * 0.2, 1e-15);
    EXPECT_EQ(checkClosedManifold(skinOf(mesh)), "");
}

TEST(SolidMesh, TheLipsOfASlitAreItsTwoSides) {
    SolidMesh mesh = solidBox(kLines, Slit{-0.05, 0, 0.1});
    std::set<int> seen;
    for (const auto& [lower, upper] : mesh.lips) {
        EXPECT_EQ(mesh.nodes[lower], mesh.nodes[upper]);
        EXPECT_GT(mesh.nodes[lower].y(), 0);
        seen.insert({lower, upper});
    }
    EXPECT_EQ(seen.size(), 2 * mesh.lips.size());
    for (const std::array<int, 10>& nodes : mesh.tetrahedra) {
        double middle = 0;
        for (int corner = 0; corner < 4; ++corner) {
            middle += mesh.nodes[nodes[corner]].x() / 4;
        }
        for (const auto& [lower, upper] : mesh.lips) {
            const int other = middle < -0.05 ? upper : lower;
            EXPECT_EQ(std::ranges::count(nodes, other), 0);
        }
    }
}

TEST(SolidMesh, ABallIsRoundAndItsHalfIsHalfOfIt) {
    const SolidMesh ball = solidBall(0.5, 4, 3, false);
    const SolidMesh half = solidBall(0.5, 4, 3, true);
    EXPECT_EQ(ball.skin.size(), 8u * 16 * 4);
    EXPECT_EQ(checkClosedManifold(skinOf(ball)), "");
    EXPECT_EQ(checkClosedManifold(skinOf(half)), "");
    const double volume = solidVolume(ball, ball.nodes);
    EXPECT_NEAR(solidVolume(half, half.nodes), volume / 2, 1e-14);
    EXPECT_NEAR(volume, 4.0 / 3 * EIGEN_PI * 0.125, 0.1 * volume);
    double farthest = 0;
    for (const Vec3& p : ball.nodes) {
        farthest = std::max(farthest, p.norm());
    }
    EXPECT_NEAR(farthest, 0.5, 1e-15);
    for (const Vec3& p : half.nodes) {
        EXPECT_GE(p.x(), 0);
    }
}

}  // namespace
}  // namespace kerf
