#include "sim/cut/stroke/ladder.h"

namespace kerf::cut {
namespace {

/// What a stroke is judged by.
struct LadderOutcome {
    int refused = 0;
    int cutAnew = 0;
    int slitEnds = 0;
    bool operator==(const LadderOutcome&) const = default;
};

/// A seed of the fuzz, whatever its positions are kept in.
LadderOutcome played(std::uint64_t seed) {
    FuzzReport report;
    fuzzOnce(seed, report);
    LadderOutcome outcome;
    for (const FuzzSetting setting : kFuzzSettings) {
        const FuzzFigures figures = report.total(setting);
        EXPECT_EQ(figures.invalid, 0);
        outcome.refused += figures.refused;
        outcome.cutAnew += figures.resumed;
        outcome.slitEnds += figures.slitEnds;
    }
    return outcome;
}

LadderOutcome playedWithout(Level level, std::uint64_t seed) {
    const WithoutLevel without(level);
    return played(seed);
}

/// The stroke comes through, and without the level its front is let go or ends inside the body.
void expectNeeded(Level level, std::uint64_t seed) {
    EXPECT_EQ(played(seed), LadderOutcome{});
    EXPECT_NE(playedWithout(level, seed), LadderOutcome{});
}

TEST(Ladder, WithoutTheBladeInItsPlaneAFoilComesOff) {
    int pieces = 0;
    for (const bool inPlane : {true, false}) {
        std::optional<WithoutLevel> without;
        if (!inPlane) {
            without.emplace(Level::asIs);
        }
        for (const double side : {-0.5, 0.5}) {
            SurfaceMesh mesh = box();
            runStroke(mesh, CutSettings{},
                      straightStroke({0, side, 0}, Vec3::UnitX(), Vec3::UnitZ(), 3, 3, 17));
            pieces += piecesOf(mesh);
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
