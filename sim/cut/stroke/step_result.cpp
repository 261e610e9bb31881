#include "sim/cut/stroke/step_result.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>

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
