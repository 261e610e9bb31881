#pragma once

#include <cstdint>

#include "sim/base/params.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The memory that a body needs [bytes].
struct MemoryNeed {
    std::uint64_t memory = 0;         ///< of the process, for this body
    std::uint64_t program = 0;        ///< of a process that has just begun, for all bodies alike
    std::uint64_t graphics = 0;       ///< of the driver, which software drivers take from the same
    std::uint64_t largestBuffer = 0;  ///< in one piece, that shaders write to
};

/// The size of a closed body.
struct BodySize {
    double vertices = 0;
    double triangles = 0;

    static BodySize ofMesh(const SurfaceMesh& mesh) {
        return {static_cast<double>(mesh.vertexCount()), static_cast<double>(mesh.triangleSlots())};
    }
    /// As far as it is known from its triangles alone.
    static BodySize ofTriangles(double triangles) { return {0.5 * triangles, triangles}; }
};

/// What of the settings memory depends on.
struct MemorySettings {
    bool contact = true;             ///< parts of the body meet one another
    int ispcsPerVertex = 1;          ///< three with a true modulus
    bool obstacles = false;          ///< boxes, or a blade that pushes
    std::uint64_t undoBudget = 0;    ///< for changes that can be undone [bytes]
    std::uint64_t courseBudget = 0;  ///< for moments of the course to go back to [bytes]
};
MemorySettings memorySettings(const Params& params, bool hasBoxes);

/// What a copy of a body takes, as a snapshot has one [bytes].
std::uint64_t bytesOfSnapshot(const BodySize& size, int ispcsPerVertex = 1);
/// What a body takes while it is prepared: see PreparedBody [bytes].
std::uint64_t bytesPrepared(const BodySize& size, int ispcsPerVertex = 1);
/// What a body takes of the driver when it has been uploaded and has run a step [bytes].
std::uint64_t bytesOnGpu(const BodySize& size, const MemorySettings& settings);

/// What a program needs to open a body, cut it once right through, run a step and take the cut
/// back: an upper estimate from the sizes of the records, known before any of it is taken. It
/// counts what is touched, not what is reserved to grow.
MemoryNeed memoryNeedOf(const BodySize& size, const MemorySettings& settings);

}  // namespace kerf
