#pragma once

#include "sim/cut/plan/input/step.h"

namespace kerf::cut {

/// The levels of the retry ladder, each by what it sees otherwise than the one before. None is
/// drawn at random; docs/notes/ladder.md tells the strokes that fail without each.
enum class Level {
    asIs,       ///< the blade and the body as they are
    beside,     ///< the blade beside its plane
    onSurface,  ///< vertices of the front, and around its ends, on the skin that they slid over
    crumpled,   ///< near nodes of the curves as one, with older slits closed
    wide,       ///< the same, with the blade farthest aside
};
/// The number of levels.
inline constexpr int kLevels = 5;

/// The largest Attempt::offsetScale of all levels.
double largestOffsetScale();

/// A try at a level. All that it changes is for the predicates alone. `tolerance`:
/// CutSettings::tolerance, as a share of the edge length around; no level goes below it.
Attempt attemptAt(Level level, double tolerance);

/// Leaves out one level in all cutters of this thread while it lives: for tests.
class WithoutLevel {
  public:
    /// Leaves out `level`.
    explicit WithoutLevel(Level level);
    ~WithoutLevel();
    WithoutLevel(const WithoutLevel&) = delete;
    WithoutLevel& operator=(const WithoutLevel&) = delete;
};

/// Whether tries at a level are left out (WithoutLevel).
bool isLeftOut(Level level);

}  // namespace kerf::cut
