#pragma once

#include "gpu/buffer.h"
#include "sim/mesh/triangle_soup.h"
#include "sim/solve/body_view.h"

namespace kerf::render {

/// A soup of triangles as a drawable body, with any faults and without a simulation. Every triangle
/// is flat and two-sided. The vertices of the soup keep their numbers, for marks. Triangles with
/// bad indices or invalid positions are skipped.
class SoupBody {
  public:
    /// Needs a current OpenGL 4.5 context. Throws gpu::OutOfMemory.
    explicit SoupBody(const TriangleSoup& soup);
    /// Valid as long as this is.
    BodyView view() const;

  private:
    gpu::Buffer positions_;
    gpu::Buffer cutSkinNormals_;
    gpu::Buffer triangles_;
    gpu::Buffer incidenceRanges_;
    gpu::Buffer incidence_;
    std::uint32_t vertexCount_ = 0;
    std::uint32_t triangleCount_ = 0;
};

}  // namespace kerf::render
