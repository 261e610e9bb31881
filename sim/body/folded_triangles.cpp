#include "sim/body/folded_triangles.h"

#include "sim/base/containers.h"
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

/// Whether each column of material leaves through the skin of its own vertex.
std::vector<bool> turnedColumns(const BodyModel& model, const SurfaceMesh& mesh,
                                std::span<const Vec3> positions) {
    std::vector<Vec3> normals(positions.size(), Vec3::Zero());
    for (const int t : model.meshTriangle) {
        const auto [a, b, c] = mesh.triangle(t);
        const Vec3 normal = areaNormal({positions[a], positions[b], positions[c]});
        for (const int v : {a, b, c}) {
            normals[v] += normal;
        }
    }
    std::vector<bool> turned;
    for (const IspcConstraint& c : model.ispcs) {
        const auto [own, w0, w1, w2] = weightsOf(c);
        const Vec3 end = -(w0 * positions[c.t0] + w1 * positions[c.t1] + w2 * positions[c.t2]);
        turned.push_back((end - positions[c.vertex]).dot(normals[c.vertex]) > 0);
    }
    return turned;
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
    const std::vector<bool> now = turnedColumns(model, mesh, mesh.positions());
    const std::vector<bool> rest = turnedColumns(model, mesh, mesh.restPositions());
    std::vector<double> all(model.pieces.size(), 0.0);
    std::vector<double> turned(model.pieces.size(), 0.0);
    for (std::size_t i = 0; i < model.ispcs.size(); ++i) {
        const IspcConstraint& c = model.ispcs[i];
        const int piece = model.pieceOfVertex[c.vertex];
        const double volume = model.vertexAreas[c.vertex] * static_cast<double>(c.rest_length);
        all[piece] += volume;
        turned[piece] += now[i] && !rest[i] ? volume : 0.0;
    }
    for (std::size_t p = 0; p < all.size(); ++p) {
        turned[p] = all[p] > 0 ? turned[p] / all[p] : 0.0;
    }
    return turned;
}

}  // namespace kerf
