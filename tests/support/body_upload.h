#pragma once

#include "gpu/buffer.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/solve/body_view.h"

namespace kerf::test {

/// The buffers behind a BodyView, uploaded from a mesh: what the solver does, for tests of the
/// renderer alone. Mass is 1 everywhere, the piece 0.
struct UploadedBody {
    /// `cutSkinNormals`: see BodyModel; none where empty.
    explicit UploadedBody(const SurfaceMesh& mesh, std::vector<Vec3> cutSkinNormals = {});
    BodyView view() const;

    gpu::Buffer positions;
    gpu::Buffer restPositions;
    gpu::Buffer cutSkinNormals;
    gpu::Buffer triangles;
    gpu::Buffer incidenceRanges;
    gpu::Buffer incidence;
    std::uint32_t vertexCount = 0;
    std::uint32_t triangleCount = 0;
    Bounds bounds;  ///< current
    Bounds restBounds;
};

/// A sphere of radius 1 in two halves of a shared rest shape: cut by the plane z = 0 in rest space
/// with walls of `rings` rings on both sides, each half turned by `angle` [rad] about its lowest
/// point and moved `gap` away from the other [m].
SurfaceMesh openedSphere(int rings, double gap, double angle);

}  // namespace kerf::test
