#include "sim/body/edge_angle.h"

#include "sim/body/dihedral.h"

namespace kerf {

namespace {

template <class Places>
std::optional<double> angleAt(const SurfaceMesh& mesh, int h, const Places& places) {
    const Vec3& x0 = places(mesh.origin(h));
    const Vec3 edge = places(mesh.target(h)) - x0;
    const Vec3 left = places(mesh.apex(h)) - x0;
    const Vec3 right = places(mesh.apex(mesh.twin(h))) - x0;
    const Dihedral<double> found = dihedral<double>(edge, left, right);
    return found.valid ? std::optional(found.angle) : std::nullopt;
}

}  // namespace

std::optional<double> edgeAngle(const SurfaceMesh& mesh, int h) {
    return angleAt(mesh, h, [&](int v) -> const Vec3& { return mesh.position(v); });
}

std::optional<double> restEdgeAngle(const SurfaceMesh& mesh, int h) {
    return angleAt(mesh, h, [&](int v) -> const Vec3& { return mesh.restPosition(v); });
}

}  // namespace kerf
