#include "sim/cut/step_result.h"

#include <algorithm>

namespace kerf {

namespace {

template <class T>
void append(std::vector<T>& to, const std::vector<T>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

void addTo(CutDelta& sum, const CutDelta& part) {
    append(sum.removedTriangles, part.removedTriangles);
    append(sum.addedTriangles, part.addedTriangles);
    append(sum.changedTriangles, part.changedTriangles);
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

}  // namespace kerf
