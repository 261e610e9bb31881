#include <gtest/gtest.h>

#include "tests/support/shape_error.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

std::vector<int> everyVertex(const std::vector<Vec3>& points) {
    std::vector<int> all(points.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

TEST(ShapeError, IsZeroForARigidMotion) {
    const std::vector<Vec3> rest = test::bentTube(8, 6).restPositions();
    const Eigen::AngleAxisd turn(2.5, Vec3(1, -2, 0.5).normalized());
    std::vector<Vec3> moved;
    moved.reserve(rest.size());
    for (const Vec3& p : rest) {
        moved.push_back(turn * p + Vec3(3, -7, 11));
    }
    EXPECT_NEAR(test::rmsShapeError(rest, moved, everyVertex(rest)), 0, 1e-12);
}

TEST(ShapeError, SeesStretchAndAMirrorImage) {
    const std::vector<Vec3> rest = test::box().restPositions();
    std::vector<Vec3> stretched = rest;
    std::vector<Vec3> mirrored = test::bentTube(8, 6).restPositions();
    for (Vec3& p : stretched) {
        p.y() *= 1.2;
    }
    EXPECT_NEAR(test::rmsShapeError(rest, stretched, everyVertex(rest)), 0.1, 1e-12);
    const std::vector<Vec3> tube = mirrored;
    for (Vec3& p : mirrored) {
        p.y() *= -1;
    }
    mirrored[0].z() += 0.3;
    EXPECT_GT(test::rmsShapeError(tube, mirrored, everyVertex(tube)), 1e-3);
}

TEST(ShapeError, LooksAtTheSubsetOnly) {
    const std::vector<Vec3> rest = test::box().restPositions();
    std::vector<Vec3> moved = rest;
    moved[3] += Vec3(9, 9, 9);
    const std::vector<int> others = {0, 1, 2, 4, 5, 6, 7};
    EXPECT_NEAR(test::rmsShapeError(rest, moved, others), 0, 1e-12);
    EXPECT_EQ(test::rmsShapeError(rest, moved, {}), 0);
}

}  // namespace
}  // namespace kerf
