// What follows the cutting: clean-up behind the front and at the end of a stroke, patches, debris.

#include "sim/cut/cut_change.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/patch/patch_commit.h"
#include "sim/cut/stroke/stroke.h"
#include "sim/mesh/piece_labels.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

namespace {

int largestPiece(const PieceLabels& pieces) {
    const auto largest = std::ranges::max_element(
        pieces.pieces(), {}, [](const PieceContent& p) { return p.restVolume; });
    return static_cast<int>(largest - pieces.pieces().begin());
}

/// Ascending.
std::vector<int> trianglesOf(const SurfaceMesh& mesh, const PieceLabels& pieces,
                             const std::vector<int>& which, int firstTriangle) {
    std::set<int> found;
    std::vector<int> open;
    const auto add = [&](int t) {
        if (found.insert(t).second) {
            open.push_back(t);
        }
    };
    for (int t = firstTriangle; t < mesh.triangleSlots(); ++t) {
        if (mesh.alive(t) &&
            std::ranges::binary_search(which, pieces.ofVertex()[mesh.triangle(t)[0]])) {
            add(t);
        }
    }
    while (!open.empty()) {
        const int t = open.back();
        open.pop_back();
        for (int corner = 0; corner < 3; ++corner) {
            add(mesh.twin(3 * t + corner) / 3);
        }
    }
    return {found.begin(), found.end()};
}

std::vector<int> cornersOf(const SurfaceMesh& mesh, const std::vector<int>& triangles) {
    std::set<int> corners;
    for (const int t : triangles) {
        corners.insert(mesh.triangle(t).begin(), mesh.triangle(t).end());
    }
    return {corners.begin(), corners.end()};
}

/// Pieces with a wall among the triangles from `firstTriangle` on that hold less than `leastVolume`
/// [m^3] at rest; ascending. The largest piece is never among them.
std::vector<int> findDebris(const SurfaceMesh& mesh, const PieceLabels& pieces, int firstTriangle,
                            double leastVolume) {
    const int largest = largestPiece(pieces);
    std::set<int> found;
    for (int t = firstTriangle; t < mesh.triangleSlots(); ++t) {
        if (!mesh.alive(t) || mesh.kind(t) != SurfaceKind::wall) {
            continue;
        }
        const int piece = pieces.ofVertex()[mesh.triangle(t)[0]];
        if (piece != largest && std::fabs(pieces.pieces()[piece].restVolume) < leastVolume) {
            found.insert(piece);
        }
    }
    return {found.begin(), found.end()};
}

/// Removes whole pieces from the mesh and adds that to `delta`, which holds what the step did so
/// far. Returns the removed slots, ascending. O(removed triangles and those from `firstTriangle`
/// on).
std::vector<int> removePieces(SurfaceMesh& mesh, const PieceLabels& pieces,
                              const std::vector<int>& which, int firstTriangle, CutDelta& delta) {
    // A cavity may lie in what comes off without having been cut.
    std::vector<int> triangles =
        trianglesOf(mesh, pieces, which, pieces.hasCavities() ? 0 : firstTriangle);
    const std::vector<int> vertices = cornersOf(mesh, triangles);
    for (const int t : triangles) {
        mesh.removeTriangle(t);
    }
    for (const int v : vertices) {
        mesh.removeVertex(v);
    }
    noteRemoved(triangles, vertices, delta);
    return triangles;
}

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

CutDelta removePiece(CutBody& body, int piece) {
    CutDelta delta;
    delta.firstNewVertex = body.mesh.vertexCount();
    body.follow({.triangles = removePieces(body.mesh, body.pieces.labels(), {piece}, 0, delta)});
    return delta;
}

}  // namespace kerf::cut
