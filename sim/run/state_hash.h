#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "sim/contact/static_box.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// 64-bit FNV-1a over 32-bit words, least significant byte first: the same on every machine.
class StateHash {
  public:
    /// Four bytes.
    void add(std::uint32_t word);
    /// The bits of the number as a float.
    void add(const Vec3& value);
    std::uint64_t value() const { return value_; }
    std::string hexadecimal() const;  ///< 16 digits

  private:
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

/// Corners and kinds of the living triangles, then positions and velocities of all vertices.
StateHash hashMesh(const SurfaceMesh& mesh);
/// The mesh, then the boxes that it collides with; without boxes that of the mesh alone.
StateHash hashScene(const SurfaceMesh& mesh, std::span<const StaticBox> boxes);

}  // namespace kerf
