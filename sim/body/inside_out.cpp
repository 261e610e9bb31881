#include "sim/body/inside_out.h"

#include <cstddef>

#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

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
