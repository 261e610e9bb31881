#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"

namespace kerf {

struct BodyModel;
struct ContactBody;

/// An order in which triangles, and vertices, that lie together come together. It is kept while a
/// body is cut; nothing but speed hangs on it.
class ContactOrder {
  public:
    /// Orders a new body, or one that was cut where that has changed much.
    void follow(const BodyModel& model, bool isNew);
    /// Numbers in order; what has come since is missing.
    const std::vector<std::uint32_t>& triangles() const { return triangles_; }
    const std::vector<std::uint32_t>& vertices() const { return vertices_; }
    /// Grows whenever all are ordered anew.
    int revision() const { return revision_; }

  private:
    std::vector<std::uint32_t> triangles_, vertices_;
    std::size_t pieces_ = 0;
    int revision_ = 0;
};

/// Where the outward normals of vertices go, a vec4 each (shaders/sim/contact/normals.glsl).
struct ContactNormals {
    const gpu::Buffer* current = nullptr;  ///< null: none are wanted
    const gpu::Buffer* rest = nullptr;     ///< those of the rest shape; null: they are known
};

/// A tree of boxes over the triangles of a body on the GPU (shaders/sim/contact/tree.glsl), of
/// where they are and how fast they move.
class ContactTree {
  public:
    /// Compiles the kernel. Throws gpu::ShaderError.
    ContactTree();

    /// A new body, or one with changed triangles. Throws gpu::OutOfMemory.
    void take(const ContactBody& body);
    /// Fits the boxes to the corners of triangles, and finds normals. Uniforms and counts must be
    /// bound; the counts start anew.
    void fit(const ContactBody& body, const gpu::Buffer& positions, const gpu::Buffer& velocities,
             const ContactNormals& normals = {}) const;
    /// Binds what a search reads besides; it begins with the nodes from roots() on.
    void bind() const;
    /// How many vertices there are in the order, padded to whole search groups.
    std::uint32_t vertexPlaces() const { return static_cast<std::uint32_t>(vertices_.size()); }
    /// The first of the kTreeFan topmost nodes.
    std::uint32_t roots() const;
    /// Nodes before this one hold triangles.
    std::uint32_t leaves() const;

  private:
    gpu::Program fit_;
    std::vector<std::uint32_t> triangles_, vertices_;  ///< in order
    int revision_ = -1;                                ///< of the order that they begin with
    gpu::Buffer triangleOrder_, vertexOrder_, boxes_, nodes_;
    gpu::Buffer groupLeaves_;  ///< of each group that searches: nodes near it, and a range
};

}  // namespace kerf
