#include "sim/cut/plan/input/slit_opening.h"

#include <gtest/gtest.h>

#include "sim/mesh/invariants.h"
#include "tests/support/shapes.h"
#include "tests/support/step_bench.h"

namespace kerf::cut {
namespace {

using test::bladeAt;

constexpr double kH = 0.25;
constexpr double kOpen = 0.1 * kH;  // as far from the strip as walls are seen

/// A box in two halves, cut in the plane z = 0.1.
class SlitOpeningOfABox : public ::testing::Test {
  protected:
    SlitOpeningOfABox() {
        bench.begin(bladeAt(1, 0.1));
        bench.cutTo(bladeAt(-1, 0.1));
        bench.seesSlitsOpen = true;
    }
    SlitOpening openedBy(const Blade& from, const Blade& to) {
        bench.begin(from);
        return bench.stepTo(to).opening;
    }

    test::StepBench bench{test::box(Vec3::Ones(), 2), kH};
};

TEST_F(SlitOpeningOfABox, OpensEachWallIntoItsHalf) {
    const double beside = 0.004;
    const SlitOpening opening = openedBy(bladeAt(1, 0.1 + beside), bladeAt(-1, 0.1 + beside));
    const PieceMap pieces = findPieces(bench.mesh);
    for (const auto& [v, way] : opening.displacements()) {
        const bool isUpper = pieces.pieces[pieces.ofVertex[v]].volume < 0.5;
        EXPECT_NEAR(way.x(), 0, 1e-9);
        EXPECT_NEAR(way.y(), 0, 1e-9);
        EXPECT_NEAR(way.z(), isUpper ? kOpen + beside : beside - kOpen, 1e-9);
    }
}

TEST_F(SlitOpeningOfABox, OpensAllOfAWallThatTheBladeRunsAlong) {
    const SlitOpening opening = openedBy(bladeAt(1, 0.1), bladeAt(-1, 0.1));
    std::set<int> wanted;
    for (const int t : livingTriangles(bench.mesh)) {
        if (bench.mesh.kind(t) == SurfaceKind::wall) {
            wanted.insert(bench.mesh.triangle(t).begin(), bench.mesh.triangle(t).end());
        }
    }
    for (const int v : wanted) {
        EXPECT_FALSE(opening.displacement(v).isZero(0)) << v;
    }
    EXPECT_NEAR(opening.reach(), kOpen, 1e-9);
}

TEST_F(SlitOpeningOfABox, LeavesTheRestWhereItIs) {
    const SlitOpening opening = openedBy(bladeAt(1, 0.1), bladeAt(-1, 0.1));
    for (int v = 0; v < bench.mesh.vertexCount(); ++v) {
        const bool isFar = std::fabs(bench.mesh.position(v).z() - 0.1) > kOpen;
        EXPECT_TRUE(!isFar || opening.displacement(v).isZero(0)) << v;
        EXPECT_EQ(opening.displacements().count(v) == 0, opening.displacement(v).isZero(0));
    }
}

TEST_F(SlitOpeningOfABox, ABladeBesideOrAcrossItOpensNothing) {
    EXPECT_TRUE(openedBy(bladeAt(1, 0.13), bladeAt(-1, 0.13)).empty()) << "too far";
    EXPECT_TRUE(openedBy({{-2, 1, 0.25}, {2, 1, 0.25}}, {{-2, -1, -0.05}, {2, -1, -0.05}}).empty())
        << "8.5 degrees";
    EXPECT_TRUE(openedBy({{0.1, 1, -2}, {0.1, 1, 2}}, {{0.1, -1, -2}, {0.1, -1, 2}}).empty());
    EXPECT_EQ(openedBy(bladeAt(1, 0.3), bladeAt(-1, 0.3)).reach(), 0);
}

TEST(SlitOpeningOfItsOwnStroke, IsNone) {
    test::StepBench bench(test::box(), kH);
    bench.seesSlitsOpen = true;
    bench.begin(bladeAt(1, 0.1));
    bench.cutTo(bladeAt(-0.2, 0.1));
    EXPECT_TRUE(bench.stepTo(bladeAt(-0.4, 0.1)).opening.empty());
    bench.cutTo(bladeAt(-1, 0.1));
    EXPECT_TRUE(bench.stepTo(bladeAt(1, 0.1)).opening.empty()) << "back again";
}

}  // namespace
}  // namespace kerf::cut
