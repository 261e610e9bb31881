#include "sim/cut/stroke/ladder.h"

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

namespace kerf {

namespace {

template <class T>
void append(std::vector<T>& to, const std::vector<T>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

// The later part may have changed what the earlier one added.
void addTo(CutDelta& sum, const CutDelta& part) {
    std::vector<int> removed = part.removedTriangles;
    std::ranges::sort(removed);
    const auto isAdded =
        [added = std::set<int>(sum.addedTriangles.begin(), sum.addedTriangles.end())](int t) {
            return added.contains(t);
        };
    std::erase_if(sum.addedTriangles,
                  [&](int t) { return std::ranges::binary_search(removed, t); });
    std::erase_if(sum.changedTriangles,
                  [&](int t) { return std::ranges::binary_search(removed, t); });
    std::ranges::copy_if(part.removedTriangles, std::back_inserter(sum.removedTriangles),
                         std::not_fn(isAdded));
    std::ranges::copy_if(part.changedTriangles, std::back_inserter(sum.changedTriangles),
                         std::not_fn(isAdded));
    append(sum.addedTriangles, part.addedTriangles);
    append(sum.movedVertices, part.movedVertices);
    append(sum.deadVertices, part.deadVertices);
}

void addTo(CutStatistics& sum, const CutStatistics& part) {
    sum.cutPieces += part.cutPieces;
    sum.refusedPieces += part.refusedPieces;
    sum.resumed += part.resumed;
    sum.touchedTriangles += part.touchedTriangles;
    sum.wallTriangles += part.wallTriangles;
    sum.splitVertices += part.splitVertices;
    sum.tries = std::max(sum.tries, part.tries);
    kerf::addTo(sum.patterns, part.patterns);
    sum.seeds += part.seeds;
    sum.swept.add(part.swept);
    sum.volumeChange += part.volumeChange;
}

}  // namespace

CutResult outcome(CutOutcome what) {
    CutResult result;
    result.outcome = what;
    return result;
}

void addTo(CutResult& sum, const CutResult& part) {
    const bool first = part.outcome == CutOutcome::cut && sum.outcome != CutOutcome::cut;
    if (first) {
        sum.delta.firstNewVertex = part.delta.firstNewVertex;
    }
    if (first || (sum.outcome != CutOutcome::cut && part.outcome > sum.outcome)) {
        sum.outcome = part.outcome;
    }
    addTo(sum.delta, part.delta);
    addTo(sum.statistics, part.statistics);
    sum.reason = part.reason.empty() ? sum.reason : part.reason;
}

void addTo(CleanupStatistics& sum, const CleanupStatistics& later) {
    sum.collapses += later.collapses;
    sum.flips += later.flips;
    sum.slides += later.slides;
    sum.volumeSpent = later.volumeSpent;
}

}  // namespace kerf
