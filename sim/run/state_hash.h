#pragma once

#include "sim/base/params.h"
#include "sim/contact/static_box.h"
#include "sim/cut/blade.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// 64-bit FNV-1a over 32-bit words, least significant byte first: the same on every machine.
class StateHash {
  public:
    /// Four bytes.
    void add(std::uint32_t word);
    /// The bits of the number as a float.
    void add(const Vec3& value);
    /// All bits of the number.
    void addExactly(double value);
    /// The text with its length.
    void add(std::string_view text);
    std::uint64_t value() const { return value_; }
    std::string hexadecimal() const;  ///< 16 digits

  private:
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

/// Corners and kinds of the living triangles, then positions and velocities of all vertices.
StateHash hashMesh(const SurfaceMesh& mesh);
/// The mesh, then the boxes that it collides with; without boxes that of the mesh alone.
StateHash hashScene(const SurfaceMesh& mesh, std::span<const StaticBox> boxes);

/// The parts in which two runs can differ, each with its hash. The first four make the state hash.
enum class StatePart { topology, positions, velocities, boxes, parameters, blade };
/// Their names, in that order, as hashes.csv and messages have them.
inline constexpr std::array<std::string_view, 6> kStatePartNames = {
    "topology", "positions", "velocities", "boxes", "parameters", "blade"};

/// The hashes of a simulation after a step, as 16 hexadecimal digits each.
struct StateHashes {
    std::string state;  ///< see Simulation::stateHash
    std::array<std::string, kStatePartNames.size()> parts;

    const std::string& of(StatePart part) const { return parts[static_cast<std::size_t>(part)]; }
};
StateHashes hashParts(const SurfaceMesh& mesh, std::span<const StaticBox> boxes,
                      const Params& params, const std::optional<Blade>& blade);

}  // namespace kerf
