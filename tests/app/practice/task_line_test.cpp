#include "app/practice/task_line.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shapes.h"

namespace kerf::app {
namespace {

/// From `from` to `to`, over a cube of 1 m around the origin.
TaskLine straightLine(const Vec3& from, const Vec3& to) {
    TaskLine line;
    line.points = {from, to};
    return line;
}

std::vector<LineSection> sectionsOf(const TaskLine& line, const SurfaceMesh& uncut) {
    const std::vector<int> members(uncut.triangleSlots(), 0);
    return LineCurve(line).sections(uncut, members);
}

TEST(TaskLine, HasSectionsWhereTheBodyLiesUnderIt) {
    const SurfaceMesh cube = test::box();
    const TaskLine inside = straightLine({-0.01, 0.7, 0.1}, {0.01, 0.7, 0.1});
    EXPECT_DOUBLE_EQ(LineCurve(inside).length(), 0.02);
    EXPECT_DOUBLE_EQ(LineCurve(inside).sectionStep(), 0.0002) << "a hundred at least";
    const auto sections = sectionsOf(inside, cube);
    ASSERT_EQ(sections.size(), 100U);
    EXPECT_NEAR((sections[0].top - Vec3(-0.0099, 0.5, 0.1)).norm(), 0, 1e-12);
    EXPECT_NEAR(sections[0].toEnd, 0.0001, 1e-12);
    EXPECT_NEAR(sections[99].toEnd, 0.0001, 1e-12);
    EXPECT_NEAR((sections[0].along - Vec3::UnitX()).norm(), 0, 1e-12);
    EXPECT_NEAR(std::abs(sections[0].aside.z()), 1, 1e-12);

    const TaskLine overhanging = straightLine({0.25, 0.5, 0}, {0.75, 0.5, 0});
    EXPECT_DOUBLE_EQ(LineCurve(overhanging).sectionStep(), 0.0005) << "half a millimetre at most";
    EXPECT_EQ(sectionsOf(overhanging, cube).size(), 500U) << "half of it hangs over";
}

TEST(TaskLine, MeetsTheBodyFromOutsideWhereverThePointsLie) {
    const SurfaceMesh hollow =
        test::hollow(test::boxSoup(), test::boxSoup(Vec3::Constant(0.4)), Vec3::Zero());
    for (const double y : {0.9, 0.3, 0.0, -2.0}) {
        for (const LineSection& section :
             sectionsOf(straightLine({-.1, y, 0}, {.1, y, 0}), hollow)) {
            EXPECT_NEAR(section.top.y(), 0.5, 1e-12);
        }
    }
    TaskLine fromBelow = straightLine({-.1, 0.4, 0}, {.1, 0.4, 0});
    fromBelow.into = Vec3(0, 3, 0);
    ASSERT_FALSE(sectionsOf(fromBelow, hollow).empty());
    EXPECT_NEAR(sectionsOf(fromBelow, hollow).front().top.y(), -0.5, 1e-12);
    const LineCurve curve(fromBelow);
    EXPECT_NEAR(curve.depthOf({0.05, -0.2, 0.1}, {0, -0.5, 0}), 0.3, 1e-12);
}

TEST(TaskLine, AHoleIsNotOfTheLine) {
    const TaskLine line = straightLine({-0.6, 0, 0}, {0.6, 0, 0});
    const auto sections = sectionsOf(line, test::torus());
    EXPECT_NEAR(static_cast<double>(sections.size()) * LineCurve(line).sectionStep(), 0.6, 2e-3);
    for (const LineSection& section : sections) {
        EXPECT_NEAR(std::hypot(std::abs(section.top.x()) - 0.35, section.top.y()), 0.15, 4e-3);
        EXPECT_GE(section.top.y(), 0);
    }
}

TEST(TaskLine, OtherModelsAreNotUnderIt) {
    const SurfaceMesh cube = test::box();
    const std::vector<int> members(cube.triangleSlots(), 1);
    TaskLine line = straightLine({-.1, 0.4, 0}, {.1, 0.4, 0});
    EXPECT_TRUE(LineCurve(line).sections(cube, members).empty());
    line.model = 1;
    EXPECT_FALSE(LineCurve(line).sections(cube, members).empty());
}

TEST(TaskLine, DistanceIsMeasuredAlongTheDirectionIntoTheBody) {
    const TaskLine line = straightLine({-0.1, 0.5, 0}, {0.1, 0.6, 0});
    const LineCurve curve(line);
    EXPECT_NEAR(curve.length(), 0.2, 1e-12) << "as it is seen from above";
    EXPECT_NEAR(curve.nearest({0, -7, 0}).distance, 0, 1e-12);
    EXPECT_NEAR(curve.nearest({0.05, 3, -0.02}).distance, 0.02, 1e-12);
    EXPECT_FALSE(curve.nearest({0.05, 3, -0.02}).isBeyond);
    EXPECT_TRUE(curve.nearest({0.11, 0.5, 0}).isBeyond);
    EXPECT_TRUE(curve.nearest({-0.11, 0.5, 0.02}).isBeyond);
    EXPECT_FALSE(curve.nearest({-0.1001, 0.5, 0.02}).isBeyond) << "hardly";
    EXPECT_NEAR(curve.nearest({0.13, 0, 0.04}).distance, 0.05, 1e-12);
}

TEST(TaskLine, AClosedOneHasNoEnds) {
    TaskLine square;
    square.points = {{-.1, .5, -.1}, {.1, .5, -.1}, {.1, .5, .1}, {-.1, .5, .1}};
    square.closed = true;
    const LineCurve curve(square);
    EXPECT_NEAR(curve.length(), 0.8, 1e-12);
    EXPECT_NEAR(curve.nearest({-.13, 0, .14}).distance, 0.05, 1e-12) << "off a corner";
    EXPECT_NEAR(curve.nearest({-.12, 0, 0}).distance, 0.02, 1e-12) << "the last side";
    const auto sections = sectionsOf(square, test::box());
    ASSERT_EQ(sections.size(), 1600U);
    for (const LineSection& section : sections) {
        EXPECT_TRUE(std::isinf(section.toEnd));
        EXPECT_NEAR(curve.nearest(section.top).distance, 0, 1e-12);
    }
    EXPECT_NEAR((sections.back().along + Vec3::UnitZ()).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace kerf::app
