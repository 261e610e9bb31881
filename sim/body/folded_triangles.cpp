#include "sim/body/folded_triangles.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "sim/base/sort_unique.h"
#include "sim/body/dihedral.h"
#include "sim/body/rest_geometry.h"

namespace kerf {

namespace {

constexpr double kFold = 0.5 * std::numbers::pi;

bool isFolded(const SurfaceMesh& mesh, int h) {
    const std::optional<double> now = edgeAngle(mesh, h);
    const std::optional<double> rest = restEdgeAngle(mesh, h);
    return now && rest && std::fabs(wrapAngle(*now - *rest)) > kFold;
}

/// Between both walls of a stroke: it opens without being folded.
bool isSlitEnd(const SurfaceMesh& mesh, int h) {
    const int label = mesh.wallLabel(h / 3);
    const int other = mesh.wallLabel(mesh.twin(h) / 3);
    return label >= 0 && other >= 0 && label != other && label / 2 == other / 2;
}

bool mayFold(const SurfaceMesh& mesh, int h) {
    return mesh.present(h / 3) && mesh.present(mesh.twin(h) / 3) && !isSlitEnd(mesh, h);
}

void bringFrom(const SurfaceMesh& mesh, int first) {
    std::vector<int> vertices;
    for (int t = first; t < mesh.triangleSlots(); ++t) {
        if (mesh.present(t)) {
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                vertices.insert(vertices.end(), {mesh.origin(h), mesh.apex(mesh.twin(h))});
            }
        }
    }
    sortUnique(vertices);
    mesh.bring(vertices);
}

void addAround(const SurfaceMesh& mesh, int vertex, int first, std::vector<int>& triangles) {
    mesh.forEachOutgoing(vertex, [&](int h) {
        if (h / 3 >= first) {
            triangles.push_back(h / 3);
        }
    });
}

}  // namespace

std::vector<int> foldedTriangles(const SurfaceMesh& mesh, int first) {
    bringFrom(mesh, first);
    std::vector<int> triangles;
    for (int h = 3 * first; h < 3 * mesh.triangleSlots(); ++h) {
        if (mayFold(mesh, h) && isFolded(mesh, h)) {
            addAround(mesh, mesh.origin(h), first, triangles);
            addAround(mesh, mesh.target(h), first, triangles);
        }
    }
    sortUnique(triangles);
    return triangles;
}

}  // namespace kerf
