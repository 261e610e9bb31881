#include "sim/cut/exact/piercing.h"

#include <gtest/gtest.h>

#include "sim/cut/cleanup/self_piercing.h"
#include "tests/support/shapes.h"

namespace kerf::cut {
namespace {

constexpr std::array<std::array<double, 3>, 3> kCorners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};

std::array<Vec3, 3> triangle() {
    std::array<Vec3, 3> corners;
    std::ranges::transform(kCorners, corners.begin(),
                           [](const auto& c) { return Vec3(c[0], c[1], c[2]); });
    return corners;
}

TEST(Pierces, TheInsideAloneAndFromBothSides) {
    EXPECT_TRUE(pierces({0.2, 0.2, -1}, {0.3, 0.2, 1}, triangle()));
    EXPECT_TRUE(pierces({0.3, 0.2, 1}, {0.2, 0.2, -1}, triangle()));
    EXPECT_FALSE(pierces({0.2, 0.2, 0.1}, {0.3, 0.2, 1}, triangle())) << "ends before it";
    EXPECT_FALSE(pierces({2, 2, -1}, {2, 2, 1}, triangle())) << "passes beside it";
}

TEST(Pierces, NotWhereTheyOnlyTouch) {
    EXPECT_FALSE(pierces({0.2, 0.2, 0}, {0.2, 0.2, 1}, triangle())) << "begins in its plane";
    EXPECT_FALSE(pierces({0.5, 0, -1}, {0.5, 0, 1}, triangle())) << "through an edge";
    EXPECT_FALSE(pierces({0, 0, -1}, {0, 0, 1}, triangle())) << "through a corner";
    EXPECT_FALSE(pierces({-1, 0.2, 0}, {1, 0.2, 0}, triangle())) << "lies in its plane";
}

constexpr int kTop = 0;
const Vec3 kThroughTheBottom(0.9, -0.9, 0.1);

/// About the origin, with its top at this place.
SurfaceMesh octahedron(const Vec3& top) {
    TriangleSoup soup;
    soup.positions = {top, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}, {0, -1, 0}};
    for (int i = 0; i < 4; ++i) {
        const int a = 1 + i;
        const int b = 1 + (i + 1) % 4;
        soup.triangles.push_back({kTop, b, a});
        soup.triangles.push_back({5, a, b});
    }
    return test::meshOf(soup);
}

int piercedPairs(const SurfaceMesh& mesh) {
    int ends = 0;
    for (const int t : livingTriangles(mesh)) {
        for (const int other : piercedNeighbours(mesh, t)) {
            EXPECT_TRUE(std::ranges::binary_search(piercedNeighbours(mesh, other), t));
            ++ends;
        }
    }
    return ends / 2;
}

TEST(SelfPiercing, AMoveAddsPairsOrNot) {
    const Vec3 up(0, 1, 0);
    const auto moveAdds = [](const SurfaceMesh& mesh, const Vec3& place) {
        OneRing ring = ringOfMove(mesh, starOf(mesh, kTop), kTop);
        ring.position = place;
        return addsPiercings(mesh, std::vector<OneRing>{ring});
    };
    const SurfaceMesh sound = octahedron(up);
    const SurfaceMesh dented = octahedron(kThroughTheBottom);
    EXPECT_GT(piercedPairs(dented), 0);
    EXPECT_EQ(piercedPairs(sound), 0);
    EXPECT_FALSE(moveAdds(sound, 2 * up));
    EXPECT_TRUE(moveAdds(sound, kThroughTheBottom));
    EXPECT_FALSE(moveAdds(dented, up));
}

TEST(SelfPiercing, LyingFlatOnItselfCounts) {
    EXPECT_EQ(piercedPairs(octahedron({0, -0.4, 0})), 0) << "dented";
    EXPECT_EQ(piercedPairs(octahedron({0, 0, 0.5})), 0) << "with a flat top";
    EXPECT_GT(piercedPairs(octahedron({0.25, -0.5, 0.25})), 0) << "its top in a face of its bottom";
}

/// The same, with a bottom that a cut made.
SurfaceMesh cutOctahedron(const Vec3& top) {
    SurfaceMesh mesh = octahedron(top);
    for (int t = 0; t < 8; ++t) {
        const Triangle corners = mesh.triangle(t);
        if (std::ranges::find(corners, kTop) != corners.end()) {
            continue;
        }
        const int wall = mesh.addTriangle(corners, SurfaceKind::wall, 0);
        for (int k = 0; k < 3; ++k) {
            mesh.link(3 * wall + k, mesh.twin(3 * t + k));
            mesh.setOutgoing(corners[k], 3 * wall + k);
        }
        mesh.removeTriangle(t);
    }
    return mesh;
}

TEST(SelfPiercing, SkinThatTouchesAWallCounts) {
    const Vec3 inFace(0.25, -0.5, 0.25);
    EXPECT_EQ(piercedPairs(cutOctahedron({0, 1, 0})), 0);
    EXPECT_GT(piercedPairs(cutOctahedron(inFace)), piercedPairs(octahedron(inFace)));
    EXPECT_EQ(piercedPairs(cutOctahedron({0, -0.4, 0})), 0) << "dented";
}

}  // namespace
}  // namespace kerf::cut
