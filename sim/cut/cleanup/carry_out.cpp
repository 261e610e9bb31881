#include <algorithm>

#include "sim/cut/cleanup/collapse.h"
#include "sim/cut/cleanup/collapse_topology.h"

namespace kerf::cut {

namespace {

void mergeVertices(const CollapsePlan& plan, Workspace& workspace) {
    SurfaceMesh& mesh = workspace.mesh;
    for (const auto& [gone, kept] : plan.merges) {
        for (const int t : collapseHalfEdge(mesh, mesh.findHalfEdge(gone, kept))) {
            workspace.removeTriangle(t);
        }
        workspace.removeVertex(gone);
    }
}

// What is left of the point that goes consists of copies of the one that stays.
void joinMates(const CollapsePlan& plan, SurfaceMesh& mesh) {
    for (const OneRing& ring : plan.rings) {
        if (ring.joins) {
            mesh.leaveCopies(ring.vertex);
        }
    }
    for (const OneRing& ring : plan.rings) {
        if (ring.joins) {
            mesh.joinCopies(plan.to, ring.vertex);
        }
    }
}

}  // namespace

void carryOut(const CollapsePlan& plan, Workspace& workspace) {
    mergeVertices(plan, workspace);
    joinMates(plan, workspace.mesh);
    std::vector<int> copies;
    for (const OneRing& ring : plan.rings) {
        workspace.moveVertex(ring);
        copies.push_back(ring.vertex);
    }
    workspace.setDeviation(copies, plan.deviation);
    workspace.spend(plan.defect);
}

}  // namespace kerf::cut
