#include "sim/mesh/triangle_soup.h"

#include <gtest/gtest.h>

#include <random>

#include "sim/repair/soup_inspection.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

constexpr unsigned kSoupSeed = 20261126;

TEST(RoundToFloats, LeavesNoDoubleHoweverManyThereAre) {
    std::mt19937 random(kSoupSeed);
    std::uniform_real_distribution<double> any(1, 3);
    for (int count = 1; count < 40; ++count) {
        TriangleSoup soup;
        for (int i = 0; i < count; ++i) {
            soup.positions.emplace_back(any(random), any(random), any(random));
            soup.triangles.push_back({i, (i + 1) % count, (i + 2) % count});
        }
        roundToFloats(soup);
        for (const Vec3& p : soup.positions) {
            for (const double x : p) {
                const volatile float rounded = static_cast<float>(x);
                EXPECT_EQ(x, rounded) << "seed " << kSoupSeed << ", of " << count;
            }
        }
    }
}

TEST(RoundToFloats, JoinsWhatIsOnePlaceThen) {
    TriangleSoup soup{{{1, 0, 0}, {1 + 1e-12, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 3}, {1, 3, 2}}};
    roundToFloats(soup);
    EXPECT_EQ(soup.positions.size(), 3u);
}

/// Each triangle with corners of its own, as in an STL.
TriangleSoup exploded(const TriangleSoup& soup) {
    TriangleSoup all;
    all.objects = soup.objects;
    for (const Triangle& t : soup.triangles) {
        const int first = static_cast<int>(all.positions.size());
        for (const int v : t) {
            all.positions.push_back(soup.positions[v]);
        }
        all.triangles.push_back({first, first + 1, first + 2});
    }
    return all;
}

/// Two cubes with a face in common, each of its own vertices.
TriangleSoup touchingBoxes() {
    const TriangleSoup box = weldExactly(test::boxSoup());
    TriangleSoup both = test::joined(box, box, Vec3::UnitX());
    both.objects.assign(both.triangles.size(), 0);
    std::fill(both.objects.begin() + std::ptrdiff_t(box.triangles.size()), both.objects.end(), 1);
    return both;
}

TEST(WeldObjects, KeepsSolidsThatTouchApart) {
    const TriangleSoup both = touchingBoxes();
    for (const TriangleSoup& soup : {both, exploded(both)}) {
        const TriangleSoup welded = weldObjects(soup);
        const MeshReport report = inspectTriangles(welded);
        EXPECT_TRUE(report.cuttable) << report.problem;
        EXPECT_EQ(report.pieces, 2);
        EXPECT_EQ(report.vertices, 16);
        EXPECT_EQ(welded.objects, both.objects);
    }
    TriangleSoup untold = both;
    untold.objects.clear();
    EXPECT_EQ(inspectTriangles(weldObjects(untold)).pieces, 2) << "closed by their own vertices";
    EXPECT_FALSE(inspectTriangles(weldObjects(exploded(untold))).cuttable) << "nothing parts them";
}

TEST(WeldObjects, KeepsObjectsThatShareTheVerticesOfTheFileApart) {
    TriangleSoup both = weldExactly(touchingBoxes());
    ASSERT_EQ(both.positions.size(), 12u);
    const MeshReport report = inspectTriangles(weldObjects(both));
    EXPECT_TRUE(report.cuttable);
    EXPECT_EQ(report.pieces, 2);
    EXPECT_EQ(report.vertices, 16);
}

TEST(WeldObjects, JoinsPartsThatAreOpenByThemselves) {
    TriangleSoup patches = exploded(weldExactly(test::boxSoup()));
    for (std::size_t t = 0; t < patches.triangles.size(); ++t) {
        patches.objects.push_back(static_cast<int>(t / 2));
    }
    const TriangleSoup welded = weldObjects(patches);
    EXPECT_TRUE(inspectTriangles(welded).cuttable);
    EXPECT_EQ(welded.positions.size(), 8u);
    EXPECT_EQ(welded.objects, std::vector<int>(12, 0)) << "they hang together";
}

TEST(WeldObjects, LetsAnOpenPartBesideASolidStayAPart) {
    TriangleSoup both = touchingBoxes();
    both.triangles.pop_back();  // of the second box
    both.objects.pop_back();
    const TriangleSoup welded = weldObjects(exploded(both));
    EXPECT_EQ(welded.positions.size(), 16u);
    EXPECT_EQ(inspectTriangles(welded).openEdges, 3);
}

TEST(WeldObjects, FindsASolidThatIsThereTwice) {
    TriangleSoup both = touchingBoxes();
    for (std::size_t v = 8; v < 16; ++v) {
        both.positions[v] = both.positions[v - 8];
    }
    EXPECT_EQ(inspectTriangles(weldObjects(both)).nonManifoldEdges, 18);
}

}  // namespace
}  // namespace kerf
