#include "sim/cut/stroke/ladder.h"

#include <gtest/gtest.h>

#include "tests/support/cut_fuzz.h"
#include "tests/support/cut_strokes.h"
#include "tests/support/shapes.h"

namespace kerf::cut {
namespace {

/// What a stroke is judged by.
struct Outcome {
    int refused = 0;
    int cutAnew = 0;
    int slitEnds = 0;
    bool operator==(const Outcome&) const = default;
};

/// A seed of the fuzz, whatever its positions are kept in.
Outcome played(std::uint64_t seed) {
    test::FuzzReport report;
    test::fuzzOnce(seed, report);
    Outcome outcome;
    for (const test::FuzzSetting setting : test::kFuzzSettings) {
        const test::FuzzFigures figures = report.total(setting);
        EXPECT_EQ(figures.invalid, 0);
        outcome.refused += figures.refused;
        outcome.cutAnew += figures.resumed;
        outcome.slitEnds += figures.slitEnds;
    }
    return outcome;
}

Outcome playedWithout(Level level, std::uint64_t seed) {
    const WithoutLevel without(level);
    return played(seed);
}

/// The stroke comes through, and without the level its front is let go or ends inside the body.
void expectNeeded(Level level, std::uint64_t seed) {
    EXPECT_EQ(played(seed), Outcome{});
    EXPECT_NE(playedWithout(level, seed), Outcome{});
}

TEST(Ladder, WithoutTheBladeInItsPlaneAFoilComesOff) {
    int pieces = 0;
    for (const bool inPlane : {true, false}) {
        std::optional<WithoutLevel> without;
        if (!inPlane) {
            without.emplace(Level::asIs);
        }
        for (const double side : {-0.5, 0.5}) {
            SurfaceMesh mesh = test::box();
            test::runStroke(
                mesh, CutSettings{},
                test::straightStroke({0, side, 0}, Vec3::UnitX(), Vec3::UnitZ(), 3, 3, 17));
            pieces += test::piecesOf(mesh);
        }
        EXPECT_EQ(pieces, inPlane ? 2 : 2 + 3);
    }
}

// What is cut anew has no front, and is tried so alone.
TEST(Ladder, WithoutTheBladeBesideItsPlaneNothingIsCutAnew) {
    EXPECT_EQ(played(400805).refused, 0);
    EXPECT_GT(playedWithout(Level::beside, 400805).refused, 0);
}

TEST(Ladder, AStrokeNeedsWhatSurroundsItSeenOnTheSurface) {
    expectNeeded(Level::onSurface, 400531);
}

TEST(Ladder, AStrokeNeedsTheBladeFarAside) {
    expectNeeded(Level::wide, 402700);
}

TEST(Ladder, OnlyTheFirstLevelSeesAllAsItIs) {
    const Attempt first = attemptAt(Level::asIs, 1e-5);
    EXPECT_EQ(first.offsetScale, 1);
    EXPECT_TRUE(first.staysInPlane);
    EXPECT_EQ(first.closing, kCloseNoise);
    EXPECT_FALSE(first.onSurface);
    EXPECT_EQ(first.tolerance, 1e-5);
    for (int i = 1; i < kLevels; ++i) {
        const Attempt level = attemptAt(static_cast<Level>(i), 1e-5);
        EXPECT_EQ(level.level, i);
        EXPECT_FALSE(level.staysInPlane);
        EXPECT_TRUE(static_cast<Level>(i) == Level::beside || level.onSurface ||
                    level.closing == kCloseDistance)
            << "level " << i;
        EXPECT_LE(level.offsetScale, largestOffsetScale());
        EXPECT_GE(level.tolerance, 1e-5);
    }
}

}  // namespace
}  // namespace kerf::cut
