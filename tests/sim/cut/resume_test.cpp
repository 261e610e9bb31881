#include <gtest/gtest.h>

#include "sim/cut/stroke/group_stroke.h"
#include "tests/support/sound_strokes.h"

namespace kerf::cut {
namespace {

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
        for (const test::FuzzFigures& figures : test::expectSoundStrokes(seed)) {
            EXPECT_EQ(figures.outside, 0) << "seed " << seed;
            resumed += figures.resumed;
        }
    }
    EXPECT_GT(resumed, 0);
}

// What moves may let the blade through in the next step.
TEST(Resume, InABodyThatMovesTheBladeWaitsFirst) {
    const auto played = [](const Vec3& velocity) {
        test::FuzzReport report;
        test::fuzzOnce(401098, report, {}, velocity);
        test::FuzzFigures sum;
        for (const test::FuzzSetting setting : test::kFuzzSettings) {
            const test::FuzzFigures figures = report.total(setting);
            EXPECT_EQ(figures.invalid, 0);
            sum.refused += figures.refused;
            sum.resumed += figures.resumed;
        }
        return sum;
    };
    const test::FuzzFigures still = played(Vec3::Zero());
    const test::FuzzFigures moving = played({0, -1, 0});
    EXPECT_GT(still.resumed, 0);
    EXPECT_EQ(still.refused, 0);
    EXPECT_GT(moving.refused, 0);
    EXPECT_LE(moving.resumed, still.resumed);
}

// Cut steeply, the pieces reached 0.6 of an edge to the other side of the blade.
TEST(Resume, WhatIsCutAnewStaysCloseToTheBlade) {
    int resumed = 0;
    for (const test::FuzzFigures& figures : test::expectSoundStrokes(401098)) {
        EXPECT_EQ(figures.unmirrored, 0);
        resumed += figures.resumed;
    }
    EXPECT_GT(resumed, 0);
}

}  // namespace
}  // namespace kerf::cut
