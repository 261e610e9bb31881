#include <algorithm>
#include <array>
#include <cmath>

#include "sim/cut/exact/jitter.h"
#include "sim/cut/stroke/ladder.h"

namespace kerf::cut {

namespace {

struct Level {
    double offsetScale;
    bool closed;
    bool touching;
    double tolerance;
    double shake;
    double gap;
    SeenAt seenAt = SeenAt::ownPlace;
    bool ignoreFringe = false;
};

constexpr std::array<Level, 21> kLevels{{
    {1, false, false, 0, 0, 0},
    {1, false, false, 0, 0, 0, SeenAt::frontOnSurface},
    {1, false, false, 0, 0, 0, SeenAt::aroundOnSurface},
    {1, false, false, 0, 0, 0, SeenAt::aroundOnSurface, true},
    {6, true, false, 0, 0, 0, SeenAt::aroundOnSurface, true},
    {6, false, true, 0, 0, 0},
    {6, true, true, 0, 0, 0},
    {6, false, false, 0, 1e-4, 0},
    {6, true, false, 0, 1e-3, 0},
    {6, false, false, 0, 1e-2, 0},
    {36, true, false, 1e-3, 0, 1e-3},
    {36, true, false, 1e-2, 0, 1e-2},
    {36, false, false, 1e-2, 0, 1e-2},
    {36, true, false, 3e-2, 1e-5, 3e-2},
    {6, true, true, 1e-4, 1e-5, 1e-4},
    {36, false, true, 1e-4, 1e-4, 1e-4},
    {36, true, true, 1e-3, 1e-4, 1e-3},
    {36, false, true, 1e-3, 1e-3, 1e-3},
    {216, true, true, 1e-2, 1e-3, 1e-2},
    {216, false, true, 1e-2, 3e-3, 1e-2},
    {216, true, true, 3e-2, 1e-2, 3e-2},
}};
constexpr int kFixedLevels = static_cast<int>(kLevels.size());
constexpr int kRandomLevels = 8;

Level randomLevel(int index, std::uint64_t seed) {
    Jitter jitter(seed + static_cast<std::uint64_t>(index) * 1001);
    Level level{};
    level.offsetScale = jitter.uniform() < 0.5 ? 6 : 36;
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
    return std::ranges::max(kLevels, {}, &Level::offsetScale).offsetScale;
}

Attempt attemptAt(int index, double tolerance, std::uint64_t seed) {
    const Level level = index < kFixedLevels ? kLevels[index] : randomLevel(index, seed);
    Attempt attempt;
    attempt.index = index;
    attempt.offsetScale = level.offsetScale;
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
