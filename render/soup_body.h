#pragma once

#include "gpu/buffer.h"
#include "sim/mesh/triangle_soup.h"
#include "sim/solve/body_view.h"

namespace kerf::render {

/// A soup of triangles as a body that can be drawn, whatever is wrong with it: no simulation has
/// to know it. Every triangle is flat and seen from both sides. The vertices of the soup keep their
/// numbers, for marks. Triangles with bad indices or without a place are left out.
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
