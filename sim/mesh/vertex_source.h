#pragma once

#include <span>

namespace kerf {

/// Has the present positions and velocities of a mesh whose own numbers have grown old, and brings
/// them by SurfaceMesh::setState().
class VertexSource {
  public:
    VertexSource() = default;
    virtual ~VertexSource() = default;
    VertexSource(const VertexSource&) = delete;
    VertexSource& operator=(const VertexSource&) = delete;

    /// Brings the state of at least these vertices, in one go.
    virtual void bring(std::span<const int> vertices) = 0;
    /// Brings the state of all vertices that are old.
    virtual void bringAll() = 0;
};

}  // namespace kerf
