#pragma once

#include "sim/cut/cut_types.h"
#include "sim/cut/plan/input/step.h"

namespace kerf::cut {

/// The levels of the retry ladder, each by what it changes. None is random; docs/notes/ladder.md
/// lists the strokes that fail without each.
enum class Level {
    asIs,       ///< the blade and the body as they are
    beside,     ///< the blade beside its plane
    onSurface,  ///< vertices of the front, and around its ends, back on the skin they slid over
    crumpled,   ///< close nodes of the curves merged, with older slits closed
    wide,       ///< the same, with the largest offset of the blade
};
/// The number of levels.
inline constexpr int kLevels = 5;

/// The largest Attempt::offsetScale of all levels.
double largestOffsetScale();

/// A try at a level, which only affects predicates. `tolerance`: CutSettings::tolerance, as a share
/// of the local edge length; no level goes below it.
Attempt attemptAt(Level level, double tolerance);

/// Disables one level in all cutters of this thread during its lifetime: for tests.
class WithoutLevel {
  public:
    /// Disables `level`.
    explicit WithoutLevel(Level level);
    ~WithoutLevel();
    WithoutLevel(const WithoutLevel&) = delete;
    WithoutLevel& operator=(const WithoutLevel&) = delete;
};

/// Whether a level is disabled (WithoutLevel).
bool isLeftOut(Level level);

}  // namespace kerf::cut

namespace kerf {

/// The result of a step that changed nothing and has this outcome.
CutResult outcome(CutOutcome what);

/// Adds the result for one piece to the sum over several. The outcome becomes the later one in the
/// list of CutOutcome, but a cut precedes a refusal, since it changed the mesh.
void addTo(CutResult& sum, const CutResult& part);

/// Adds a later clean-up of a stroke to an earlier one.
void addTo(CleanupStatistics& sum, const CleanupStatistics& later);

}  // namespace kerf
