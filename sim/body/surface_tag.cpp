#include "sim/body/surface_tag.h"

namespace kerf {

std::uint32_t surfaceTag(const SurfaceMesh& mesh, int triangle) {
    const SurfaceKind kind = mesh.kind(triangle);
    auto tag = static_cast<std::uint32_t>(kind);
    for (int i = 0; i < 3; ++i) {
        const bool onRim = mesh.kind(mesh.twin(3 * triangle + i) / 3) != kind;
        tag |= (onRim ? 1u : 0u) << (1 + i);
        tag |= (mesh.isTorn(mesh.triangle(triangle)[i]) ? 1u : 0u) << (4 + i);
    }
    return tag;
}

}  // namespace kerf
