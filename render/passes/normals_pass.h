#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "sim/solve/body_view.h"

namespace kerf::render {

/// Vertex normals of the running body, two per vertex: over skin and over wall triangles.
class NormalsPass {
  public:
    NormalsPass();
    void run(const BodyView& body);
    /// vec4, shape [2 * vertexCount]: entry 2 * vertex + kind.
    const gpu::Buffer& normals() const { return normals_; }

  private:
    gpu::Program program_;
    gpu::Buffer normals_;
};

}  // namespace kerf::render
