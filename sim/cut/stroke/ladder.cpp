#include "sim/cut/stroke/ladder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/cut/exact/jitter.h"

namespace kerf::cut {

namespace {

/// What a level changes of the first try; members as those of Attempt.
struct Level {
    double scale = 1;     ///< Attempt::offsetScale
    bool closed = false;  ///< Attempt::closing is kCloseDistance
    bool touching = false;
    double tolerance = 0;
    double shake = 0;
    double gap = 0;
    SeenAt seenAt = SeenAt::ownPlace;
    bool ignoreFringe = false;
};

// The first levels leave the blade where it is: a wider offset may lead the rung into a wall that
// faces the front, and what lies behind it stays as a bridge. Sizes were chosen by measurement.
constexpr std::array<Level, 21> kLevels{{
    // The blade and the body as they are.
    {},
    // Nearly all refusals of a moving body: the light vertex where the front leaves the skin slid
    // over the next triangle, and the front's last edge pierces that.
    {.seenAt = SeenAt::frontOnSurface},
    // The skin around that vertex has folded over with it.
    {.seenAt = SeenAt::aroundOnSurface},
    // Seen so, the front may touch the two rows of walls behind it, which it has just made.
    {.seenAt = SeenAt::aroundOnSurface, .ignoreFringe = true},
    // Older slits are seen closed as well, and the blade passes them farther aside.
    {.scale = 6, .closed = true, .seenAt = SeenAt::aroundOnSurface, .ignoreFringe = true},
    // Another piece touches the front with a vertex: the vertex belongs to the front's node.
    {.scale = 6, .touching = true},
    // So does a vertex on the other wall of an older slit, once that is seen closed.
    {.scale = 6, .closed = true, .touching = true},
    // A sliver beside the front has flipped over: a front that moves a little lets go of it.
    {.scale = 6, .shake = 1e-4},
    // It moves ten times as far, with older slits seen closed.
    {.scale = 6, .closed = true, .shake = 1e-3},
    // It moves ten times as far again, with older slits as they are.
    {.scale = 6, .shake = 1e-2},
    // The front has crumpled where several slits meet within a thousandth of an edge: nodes so
    // close become one.
    {.scale = 36, .closed = true, .tolerance = 1e-3, .gap = 1e-3},
    // Nodes ten times as far apart become one.
    {.scale = 36, .closed = true, .tolerance = 1e-2, .gap = 1e-2},
    // They do so with older slits as they are, where closed ones gave no valid step.
    {.scale = 36, .tolerance = 1e-2, .gap = 1e-2},
    // Nodes yet farther apart become one, and the front moves by a trace.
    {.scale = 36, .closed = true, .tolerance = 3e-2, .shake = 1e-5, .gap = 3e-2},
    // All means together, ever stronger, with older slits seen closed and as they are in turn.
    {.scale = 6, .closed = true, .touching = true, .tolerance = 1e-4, .shake = 1e-5, .gap = 1e-4},
    {.scale = 36, .touching = true, .tolerance = 1e-4, .shake = 1e-4, .gap = 1e-4},
    {.scale = 36, .closed = true, .touching = true, .tolerance = 1e-3, .shake = 1e-4, .gap = 1e-3},
    {.scale = 36, .touching = true, .tolerance = 1e-3, .shake = 1e-3, .gap = 1e-3},
    {.scale = 216, .closed = true, .touching = true, .tolerance = 1e-2, .shake = 1e-3, .gap = 1e-2},
    {.scale = 216, .touching = true, .tolerance = 1e-2, .shake = 3e-3, .gap = 1e-2},
    {.scale = 216, .closed = true, .touching = true, .tolerance = 3e-2, .shake = 1e-2, .gap = 3e-2},
}};
constexpr int kFixedLevels = static_cast<int>(kLevels.size());
// Where no fixed level works some other mixture of the means may.
constexpr int kRandomLevels = 8;

Level randomLevel(int index, std::uint64_t seed) {
    Jitter jitter(seed + static_cast<std::uint64_t>(index) * 1001);
    Level level;
    level.scale = jitter.uniform() < 0.5 ? 6 : 36;
    level.closed = (index - kFixedLevels) % 2 == 0;
    level.touching = jitter.uniform() < 0.7;
    level.tolerance = std::pow(10, jitter.uniform(-5, -1.3));
    level.shake = std::pow(10, jitter.uniform(-6, -1.7));
    level.gap = jitter.uniform() < 0.3 ? 0 : level.tolerance;
    return level;
}

}  // namespace

int attemptCount() {
    return kFixedLevels + kRandomLevels;
}

double largestOffsetScale() {
    return std::ranges::max(kLevels, {}, &Level::scale).scale;
}

Attempt attemptAt(int index, double tolerance, std::uint64_t seed) {
    const Level level = index < kFixedLevels ? kLevels[index] : randomLevel(index, seed);
    Attempt attempt;
    attempt.index = index;
    attempt.offsetScale = level.scale;
    attempt.closing = level.closed ? kCloseDistance : kCloseNoise;
    attempt.seenAt = level.seenAt;
    attempt.touching = level.touching;
    attempt.tolerance = std::max(level.tolerance, tolerance);
    attempt.shake = level.shake;
    attempt.gap = std::max(level.gap, tolerance);
    attempt.ignoreFringe = level.ignoreFringe;
    return attempt;
}

}  // namespace kerf::cut
