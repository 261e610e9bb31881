#include "sim/cut/stroke/ladder.h"

#include <algorithm>
#include <array>
#include <optional>

namespace kerf::cut {

namespace {

// Of an edge: what lies so near to the front where slits meet is one node with it.
constexpr double kNear = 0.03;

// The first levels leave the blade where it is, or close beside: a wider offset may lead the rung
// into a wall that faces the front, and what lies behind it stays as a bridge. docs/notes/ladder.md
// tells what each level is for and what was measured.
constexpr std::array<Attempt, kLevels> kAttempts{{
    {.staysInPlane = true},
    // The blade meets the end of an older slit or a line in which older slits meet: it passes
    // beside it.
    {},
    // Nearly all refusals of a moving body: the light vertex where the front leaves the skin slid
    // over the next triangle, and the front's last edge pierces that; or the skin around it has
    // folded over with it.
    {.onSurface = true},
    // The front has crumpled where several slits meet: no order of nodes so close is right.
    {.closing = kCloseDistance, .tolerance = kNear},
    // The blade runs along an edge of what crumpled there, and passes it by a fifth of an edge.
    {.offsetScale = 216, .closing = kCloseDistance, .tolerance = kNear},
}};

thread_local std::optional<Level> leftOut;

}  // namespace

double largestOffsetScale() {
    return std::ranges::max(kAttempts, {}, &Attempt::offsetScale).offsetScale;
}

Attempt attemptAt(Level level, double tolerance) {
    Attempt attempt = kAttempts.at(static_cast<std::size_t>(level));
    attempt.level = static_cast<int>(level);
    attempt.tolerance = std::max(attempt.tolerance, tolerance);
    return attempt;
}

WithoutLevel::WithoutLevel(Level level) {
    leftOut = level;
}

WithoutLevel::~WithoutLevel() {
    leftOut.reset();
}

bool isLeftOut(Level level) {
    return leftOut == level;
}

}  // namespace kerf::cut
