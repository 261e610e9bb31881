// What follows the cutting: clean-up behind the front and at the end of a stroke, patches, debris.

#include <algorithm>
#include <iterator>

#include "sim/cut/commit/debris.h"
#include "sim/cut/cut_change.h"
#include "sim/cut/patch/patch_commit.h"
#include "sim/cut/stroke/stroke.h"

namespace kerf::cut {

namespace {

/// The clean-up takes triangles that the step had added out of its delta.
void followCleanUp(CutBody& body, const std::vector<int>& changedBefore, const CutDelta& delta,
                   Cleanup& cleanup) {
    std::vector<int> changed;
    std::ranges::set_union(changedBefore, changedTriangles(delta), std::back_inserter(changed));
    body.follow({.triangles = changed,
                 .movedVertices = delta.movedVertices,
                 .restMotion = cleanup.takeRestMotion()});
}

/// Patches one wound, or counts why not.
void patch(CutBody& body, const Wound& wound, WoundClosing& closing, CutDelta& delta) {
    if (wound.endsInside) {
        ++closing.slits;
        return;
    }
    try {
        const PatchPlan plan = planPatch(body.mesh, wound, body.h());
        body.follow({.triangles = commitPatch(body.mesh, wound, plan, delta)});
        ++closing.patches;
        closing.patchTriangles += 2 * sizeOf(plan.triangles);
        closing.removedWalls += 2 * sizeOf(wound.plus);
    } catch (const StepFailure& failure) {
        ++closing.unpatched;
        closing.reason = failure.reason;
    }
}

}  // namespace

CleanupStatistics Stroke::cleanUpBehindFront(CutBody& body, CutDelta& delta) {
    if (!cleanup) {
        return {};
    }
    const std::vector<int> before = changedTriangles(delta);
    const CleanupStatistics statistics = cleanup->behindFront(rung, delta);
    followCleanUp(body, before, delta, *cleanup);
    return statistics;
}

CleanupStatistics Stroke::cleanUpAtEnd(CutBody& body, CutDelta& delta) {
    if (!cleanup) {
        return {};
    }
    const std::vector<int> before = changedTriangles(delta);
    const CleanupStatistics statistics = cleanup->atEnd(delta);
    if (const double coarsening = body.settings.wallCoarsening; coarsening > 1) {
        cleanup->coarsen(coarsening, delta);
    }
    followCleanUp(body, before, delta, *cleanup);
    cleanup.reset();
    return statistics;
}

WoundClosing closeWounds(CutBody& body, CutDelta& delta) {
    WoundClosing closing;
    for (const Wound& wound : findWounds(body.mesh)) {
        patch(body, wound, closing, delta);
    }
    std::vector<int> added = delta.addedTriangles;
    std::ranges::sort(added);
    std::ranges::set_difference(absentTriangles(body.mesh), added,
                                std::back_inserter(delta.changedTriangles));
    body.mesh.setOpenStroke(-1);
    return closing;
}

Debris Stroke::removeDebris(CutBody& body, CutDelta& delta) const {
    const double share = body.settings.debrisVolume;
    const PieceLabels& pieces = body.pieces.labels();
    const std::vector<int> found =
        share > 0 ? findDebris(body.mesh, pieces, start.firstTriangle, share * start.restVolume)
                  : std::vector<int>{};
    Debris debris;
    for (const int piece : found) {
        ++debris.pieces;
        debris.volume += pieces.pieces()[piece].restVolume;
    }
    if (debris.pieces > 0) {
        const std::vector<int> removed =
            removePieces(body.mesh, pieces, found, start.firstTriangle, delta);
        body.follow({.triangles = removed});
    }
    return debris;
}

CutDelta mend(CutBody& body, const std::vector<int>& triangles) {
    CutDelta delta;
    delta.firstNewVertex = body.mesh.vertexCount();
    if (body.settings.cleanUp) {
        Cleanup cleanup(body.mesh, *body.edgeLengths);
        cleanup.mend(triangles, delta);
        followCleanUp(body, {}, delta, cleanup);
    }
    return delta;
}

}  // namespace kerf::cut
