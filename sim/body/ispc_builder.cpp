#include "sim/body/ispc_builder.h"

#include <algorithm>

#include "sim/body/rest_geometry.h"

namespace kerf {

namespace {

constexpr double kLeastFlatness = 0.3;  // below: a slit front, whose normal means nothing
constexpr double kLeastLength = 1e-3;   // of the mean edge
constexpr double kLeastArea = 1e-3;     // of the squared mean edge
constexpr int kRaysPerVertex = 1;

bool touches(const Triangle& triangle, int vertex) {
    return std::ranges::find(triangle, vertex) != triangle.end();
}

}  // namespace

IspcCaster::IspcCaster(const SurfaceMesh& mesh, const RayTree& tree,
                       const std::vector<int>& pieceOfVertex, double edgeLength)
    : mesh_(mesh), tree_(tree), pieceOfVertex_(pieceOfVertex), edgeLength_(edgeLength) {}

std::optional<CastIspc> IspcCaster::cast(int vertex, double vertexArea) const {
    const int piece = pieceOfVertex_[vertex];
    if (piece < 0) {
        return std::nullopt;
    }
    const VertexNormal normal = restNormal(mesh_, vertex);
    if (normal.flatness < kLeastFlatness) {
        return std::nullopt;
    }
    const RayHit hit = tree_.castToBackFace(
        mesh_.restPosition(vertex), -normal.direction, kLeastLength * edgeLength_, [&](int slot) {
            const Triangle& t = mesh_.triangle(slot);
            const bool inTheWay = pieceOfVertex_[t[0]] == piece || mesh_.absent(slot);
            return inTheWay && !touches(t, vertex);
        });
    if (hit.triangle < 0) {
        return std::nullopt;
    }
    const double area = std::max(vertexArea, kLeastArea * edgeLength_ * edgeLength_);
    const Triangle& t = mesh_.triangle(hit.triangle);
    return CastIspc{
        {static_cast<std::uint32_t>(vertex), static_cast<std::uint32_t>(t[0]),
         static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2]),
         static_cast<float>(hit.b1), static_cast<float>(hit.b2), static_cast<float>(hit.distance),
         static_cast<float>(2 * kRaysPerVertex * hit.distance / area)},
        hit.triangle};
}

Vec3 restEnd(const SurfaceMesh& mesh, const shared::IspcConstraint& c) {
    const double b1 = c.b1;
    const double b2 = c.b2;
    return (1 - b1 - b2) * mesh.restPosition(static_cast<int>(c.t0)) +
           b1 * mesh.restPosition(static_cast<int>(c.t1)) +
           b2 * mesh.restPosition(static_cast<int>(c.t2));
}

}  // namespace kerf
