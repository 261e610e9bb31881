// What follows the cutting: clean-up behind the front and at the end of a stroke, and debris.

#include <algorithm>
#include <iterator>

#include "sim/cut/commit/debris.h"
#include "sim/cut/cut_change.h"
#include "sim/cut/patch/patch_commit.h"
#include "sim/cut/stroke/cutter_state.h"

namespace kerf {

void Cutter::State::cleanUpBehindFront(CutResult& result) {
    if (!cleanup) {
        return;
    }
    const std::vector<int> before = changedTriangles(result.delta);
    result.statistics.cleanup = cleanup->behindFront(rung, result.delta);
    followCleanUp(before, result.delta);
    holdLivingVertices();
}

/// The clean-up takes triangles that the step had added out of its delta.
void Cutter::State::followCleanUp(const std::vector<int>& changedBefore, const CutDelta& delta) {
    std::vector<int> changed;
    std::ranges::set_union(changedBefore, changedTriangles(delta), std::back_inserter(changed));
    atRest =
        atRest && std::ranges::all_of(delta.movedVertices, [this](int v) { return liesAtRest(v); });
    surface.follow(changed, cleanup->takeRestMotion());
    follow(changed, -1);
}

void Cutter::State::cleanUpAtEnd(CutResult& result) {
    if (!cleanup) {
        return;
    }
    const std::vector<int> changedBefore = changedTriangles(result.delta);
    const CleanupStatistics before = result.statistics.cleanup;
    CleanupStatistics& sum = result.statistics.cleanup = cleanup->atEnd(result.delta);
    if (settings.wallCoarsening > 1) {
        cleanup->coarsen(settings.wallCoarsening, result.delta);
    }
    followCleanUp(changedBefore, result.delta);
    sum.collapses += before.collapses;
    sum.flips += before.flips;
    sum.slides += before.slides;
    cleanup.reset();
}

void Cutter::State::mend(const std::vector<int>& triangles, CutDelta& delta) {
    cleanup.emplace(mesh, *edgeLengths);
    cleanup->mend(triangles, delta);
    followCleanUp({}, delta);
    cleanup.reset();
}

/// Walls that no patch replaces are part of the body from now on.
void Cutter::State::closeWounds(CutResult& result) {
    for (const cut::Wound& wound : cut::findWounds(mesh)) {
        patch(wound, result);
    }
    std::vector<int> added = result.delta.addedTriangles;
    std::ranges::sort(added);
    std::ranges::set_difference(absentTriangles(mesh), added,
                                std::back_inserter(result.delta.changedTriangles));
    mesh.setOpenStroke(-1);
}

void Cutter::State::patch(const cut::Wound& wound, CutResult& result) {
    WoundClosing& closing = result.statistics.closing;
    if (wound.endsInside) {
        ++closing.slits;
        return;
    }
    try {
        const cut::PatchPlan plan = cut::planPatch(mesh, wound, h);
        const std::vector<int> changed = cut::commitPatch(mesh, wound, plan, result.delta);
        surface.follow(changed, 0);
        follow(changed, -1);
        ++closing.patches;
        closing.patchTriangles += 2 * cut::sizeOf(plan.triangles);
        closing.removedWalls += 2 * cut::sizeOf(wound.plus);
    } catch (const cut::StepFailure& failure) {
        ++closing.unpatched;
        closing.reason = failure.reason;
    }
}

void Cutter::State::removeDebris(CutResult& result) {
    if (settings.debrisVolume <= 0) {
        return;
    }
    const std::vector<int> debris =
        cut::findDebris(mesh, pieces, firstTriangle, settings.debrisVolume * restVolume);
    if (debris.empty()) {
        return;
    }
    for (const int piece : debris) {
        ++result.statistics.debris.pieces;
        result.statistics.debris.volume += pieces.pieces()[piece].restVolume;
    }
    const std::vector<int> removed =
        cut::removePieces(mesh, pieces, debris, firstTriangle, result.delta);
    surface.follow(removed, 0);
    follow(removed, -1);
}

}  // namespace kerf
