#include "sim/body/folded_triangles.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "sim/base/sort_unique.h"
#include "sim/body/dihedral.h"
#include "sim/body/rest_geometry.h"
#include "sim/mesh/triangle.h"

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

/// As long as twice the area around each vertex.
std::vector<Vec3> skinNormals(const BodyModel& model, const SurfaceMesh& mesh) {
    std::vector<Vec3> normals(model.restPositions.size(), Vec3::Zero());
    for (const int t : model.meshTriangle) {
        const Vec3 normal = areaNormal(cornersOf(mesh, t));
        for (const int v : mesh.triangle(t)) {
            normals[v] += normal;
        }
    }
    return normals;
}

/// From the vertex of an ISPC to where it ends.
Vec3 columnOf(const IspcConstraint& c, const SurfaceMesh& mesh) {
    const auto at = [&](std::uint32_t v) { return mesh.position(static_cast<int>(v)); };
    const auto [own, w0, w1, w2] = weightsOf(c);
    return -(w0 * at(c.t0) + w1 * at(c.t1) + w2 * at(c.t2)) - at(c.vertex);
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

std::vector<double> sharesInsideOut(const BodyModel& model, const SurfaceMesh& mesh) {
    const std::vector<Vec3> normals = skinNormals(model, mesh);
    std::vector<double> all(model.pieces.size(), 0.0);
    std::vector<double> turned(model.pieces.size(), 0.0);
    for (const IspcConstraint& c : model.ispcs) {
        const int piece = model.pieceOfVertex[c.vertex];
        const double volume = model.vertexAreas[c.vertex] * static_cast<double>(c.rest_length);
        all[piece] += volume;
        turned[piece] += columnOf(c, mesh).dot(normals[c.vertex]) > 0 ? volume : 0.0;
    }
    for (std::size_t p = 0; p < all.size(); ++p) {
        turned[p] = all[p] > 0 ? turned[p] / all[p] : 0.0;
    }
    return turned;
}

}  // namespace kerf
