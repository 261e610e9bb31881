#pragma once

#include <cstdint>

#include "gpu/buffer.h"
#include "gpu/program.h"

namespace kerf {

/// The hierarchical hash grid over the triangles of a body on the GPU (shaders/sim/contact/
/// grid.glsl), refilled for each search.
class TriangleGrid {
  public:
    /// Compiles the kernels. Throws gpu::ShaderError.
    TriangleGrid();

    /// The number of buckets for this many triangles, a power of two.
    static std::uint32_t bucketsFor(std::uint32_t triangles);

    /// Makes room for `triangles` triangles. Throws gpu::OutOfMemory.
    void resize(std::uint32_t triangles);
    /// Enters the triangles where `positions` has their corners. ContactUniforms, triangles and
    /// ContactState, of which `levels` and `largest` are 0, are bound. What a search reads is bound
    /// then.
    void fill(const gpu::Buffer& positions);

  private:
    gpu::Program boxesKernel_, scan_, scanBlocks_, fill_, summarize_;
    std::uint32_t triangles_ = 0;
    gpu::Buffer boxes_, homes_, counts_, starts_, blocks_, entries_, buckets_;
};

}  // namespace kerf
