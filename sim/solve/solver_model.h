#pragma once

#include "gpu/buffer.h"
#include "shaders/shared/bindings.h"
#include "sim/body/body_updater.h"
#include "sim/solve/scatter.h"

namespace kerf {

/// The elements that touch each vertex, on the GPU: see Incidence.
struct IncidenceBuffers {
    gpu::Buffer ranges;
    gpu::Buffer entries;

    void assign(const Incidence& incidence);
    /// Follows the lists of these vertices.
    void update(const Incidence& incidence, const std::vector<std::uint32_t>& vertices,
                Scatter& scatter);
};

/// The constraints of one type on the GPU, as its kernels read them: as texels, since there are
/// several for each triangle. Edges have no records.
struct ConstraintBuffers {
    gpu::Buffer records{gpu::Buffer::Readers::texels};
    gpu::Buffer ranges{gpu::Buffer::Readers::texels};
    gpu::Buffer entries{gpu::Buffer::Readers::texels};
    gpu::TexelFormat rangeTexels = gpu::TexelFormat::uint32x2;
    gpu::TexelFormat entryTexels = gpu::TexelFormat::uint32x2;
};

/// Calls bind(buffer, unit, texels) for all that kernels with all types of constraints read.
template <class Bind>
void bindAllConstraints(std::span<const ConstraintBuffers> constraints, Bind&& bind) {
    std::uint32_t unit = 0;
    for (const ConstraintBuffers& buffers : constraints) {
        if (unit > 0) {  // edges have no records
            bind(buffers.records, shared::kAllRecordsUnit + unit, gpu::TexelFormat::uint32x4);
        }
        bind(buffers.ranges, shared::kAllRangesUnit + unit, buffers.rangeTexels);
        bind(buffers.entries, shared::kAllEntriesUnit + unit, buffers.entryTexels);
        unit += 3;
    }
}

/// The rest shape and the constraints of a body on the GPU: constant between cuts. All that
/// allocates throws gpu::OutOfMemory.
struct SolverModel {
    /// Shape [vertexCount].
    std::vector<float> areas;  ///< rest area of each vertex [m^2]
    std::vector<int> pieceOf;  ///< of each vertex, -1 for none
    double diagonal = 0;       ///< of the body at rest [m]
    double wallEdge = 0;       ///< edge length of walls [m]

    gpu::Buffer restPositions, cutSkinNormals, links, areaBuffer;
    gpu::Buffer triangles;
    std::array<ConstraintBuffers, kConstraintTypes> constraints;
    IncidenceBuffers triangleIncidence, neighbours;

    // A new body, in portions of about the same size.
    void takeVertices(const BodyModel& model);
    void uploadRestShape(const BodyModel& model);
    void uploadTriangles(const BodyModel& model) { triangles.assign(model.triangles); }
    void uploadRecords(const BodyModel& model, std::uint32_t type);
    void uploadLists(const BodyModel& model, std::uint32_t type);
    void uploadTriangleLists(const BodyModel& model);

    /// Uploads the constraints again after a change of materials.
    void uploadConstraints(const BodyModel& model);
    /// Follows a change, at the cost of what changed.
    void update(const BodyModel& model, const BodyChange& change, Scatter& scatter);

  private:
    void updateVertices(const BodyModel& model, const BodyChange& change, Scatter& scatter);
    void updateConstraints(const BodyModel& model, const BodyChange& change, Scatter& scatter);
};

}  // namespace kerf
