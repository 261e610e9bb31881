#pragma once

#include <cstdint>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/program.h"

namespace kerf {

struct ContactBody;

/// A tree of boxes over the triangles of a body on the GPU (shaders/sim/contact/tree.glsl), of
/// where they are and how fast they move. Its order is kept while a body is cut; nothing but speed
/// hangs on it.
class ContactTree {
  public:
    /// Compiles the kernels. Throws gpu::ShaderError.
    ContactTree();

    /// Another body comes.
    void forget() { ordered_ = 0; }
    /// A new body, or one with changed triangles. Orders triangles and vertices: waits for the GPU
    /// where all are ordered anew. Throws gpu::OutOfMemory.
    void take(const ContactBody& body);
    /// Fits the boxes to the corners of triangles.
    void fit(const ContactBody& body, const gpu::Buffer& positions,
             const gpu::Buffer& velocities) const;
    /// Binds what a search reads besides; it begins with the nodes from roots() on.
    void bind() const;
    /// The order of vertices, padded to whole search groups.
    const gpu::Buffer& vertices() const { return vertexOrder_; }
    std::uint32_t vertexPlaces() const { return static_cast<std::uint32_t>(vertices_.size()); }
    /// The first of the kTreeFan topmost nodes.
    std::uint32_t roots() const;
    /// Nodes before this one hold triangles.
    std::uint32_t leaves() const;

  private:
    void orderAnew(const ContactBody& body);

    gpu::Program fitLeaves_, fitNodes_;
    std::vector<std::uint32_t> triangles_, vertices_;  ///< in order
    std::uint32_t ordered_ = 0, pieces_ = 0;           ///< of the body that was ordered
    gpu::Buffer triangleOrder_, vertexOrder_, boxes_, nodes_;
};

}  // namespace kerf
