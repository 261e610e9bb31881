#pragma once

#include "sim/base/params.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The memory that a body needs [bytes].
struct MemoryNeed {
    std::uint64_t memory = 0;         ///< of the process, for this body
    std::uint64_t program = 0;        ///< of a new process, for any body
    std::uint64_t graphics = 0;       ///< of the driver; software drivers use main memory
    std::uint64_t largestBuffer = 0;  ///< of those that shaders write to
};

/// The size of a closed body.
struct BodySize {
    double vertices = 0;
    double triangles = 0;

    static BodySize ofMesh(const SurfaceMesh& mesh) {
        return {static_cast<double>(mesh.vertexCount()), static_cast<double>(mesh.triangleSlots())};
    }
    /// Estimated from its triangles.
    static BodySize ofTriangles(double triangles) { return {0.5 * triangles, triangles}; }
};

/// The settings that affect memory.
struct MemorySettings {
    bool contact = true;                 ///< parts of the body collide
    int ispcsPerVertex = 1;              ///< three with the implicit solver
    bool obstacles = false;              ///< boxes, or a blade that pushes
    bool implicit = false;               ///< steps are those of SolverMode::implicit
    std::uint64_t undoBudget = 0;        ///< of the undo history [bytes]
    std::uint64_t checkpointBudget = 0;  ///< of checkpoints [bytes]
};
MemorySettings memorySettings(const Params& params, bool hasBoxes);

/// The memory of a copy of a body in a snapshot [bytes].
std::uint64_t bytesOfSnapshot(const BodySize& size, int ispcsPerVertex = 1);
/// The memory of a body during preparation: see PreparedBody [bytes].
std::uint64_t bytesPrepared(const BodySize& size, int ispcsPerVertex = 1);
/// The driver's memory for a body that was uploaded and has run a step [bytes].
std::uint64_t bytesOnGpu(const BodySize& size, const MemorySettings& settings);

/// The memory to open a body, cut it once right through, run a step and undo the cut: an upper
/// estimate from the sizes of the records. It counts touched memory, not reserved capacity.
MemoryNeed memoryNeedOf(const BodySize& size, const MemorySettings& settings);

}  // namespace kerf
