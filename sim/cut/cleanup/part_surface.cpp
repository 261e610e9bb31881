#include "sim/cut/cleanup/part_surface.h"

#include "sim/cut/cleanup/flip.h"
#include "sim/cut/cleanup/self_piercing.h"

namespace kerf::cut {

namespace {

constexpr int kMostFlipsAtATriangle = 6;

/// One of its corners is on a rim or where sheets meet. Inside a sheet nothing passes through
/// anything.
bool isAtOutline(const SurfaceMesh& mesh, int triangle) {
    bool found = false;
    for (const int v : mesh.triangle(triangle)) {
        mesh.forEachOutgoing(
            v, [&](int h) { found = found || mesh.wallLabel(h / 3) != mesh.wallLabel(triangle); });
    }
    return found;
}

bool flipAnyEdge(Workspace& workspace, int triangle) {
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        if (flipEdgeApart(workspace, h)) {
            return true;
        }
    }
    return false;
}

bool flipBeside(Workspace& workspace, int triangle) {
    const std::vector<int> pierced = piercedNeighbours(workspace.mesh, triangle);
    if (pierced.empty()) {
        return false;
    }
    workspace.workAt(triangle);
    if (flipAnyEdge(workspace, triangle)) {
        return true;
    }
    for (const int other : pierced) {
        if (flipAnyEdge(workspace, other)) {
            return true;
        }
    }
    return false;
}

}  // namespace

int partSurface(Workspace& workspace, const std::vector<int>& triangles) {
    int flips = 0;
    const SurfaceMesh& mesh = workspace.mesh;
    for (const int t : triangles) {
        for (int i = 0; i < kMostFlipsAtATriangle && mesh.alive(t); ++i) {
            if (!isAtOutline(mesh, t) || !flipBeside(workspace, t)) {
                break;
            }
            ++flips;
        }
    }
    return flips;
}

}  // namespace kerf::cut
