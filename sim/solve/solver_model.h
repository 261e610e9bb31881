#pragma once

#include "gpu/buffer.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/body_records.h"
#include "sim/body/body_model.h"
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

// The constraints of a body as the solver's kernels read them: their records, and what they are
// seen from their vertices, at the places of the model's incidence lists.

/// The record on the GPU: that of the CPU, except for bends. `rest`: of all vertices [m].
template <class Constraint>
const Constraint& recordOf(const Constraint& constraint, const std::vector<Vec3f>&) {
    return constraint;
}
shared::BendRecord recordOf(const BendConstraint& bend, const std::vector<Vec3f>& rest);

/// The list of a vertex. Bends with it at an end of their edge come first.
template <class Gather>
const typename Gather::Range& rangeAt(Gather, const Incidence& incidence, std::uint32_t vertex) {
    return incidence.ranges[vertex];
}
shared::BendRange rangeAt(WingPulls, const Incidence& incidence, std::uint32_t vertex);

// What lies at a place of the lists that is in use.
shared::Spoke entryAt(Spokes, const std::vector<EdgeConstraint>& edges, const Incidence& incidence,
                      std::uint32_t place);
std::uint32_t entryAt(WingPulls, const std::vector<BendConstraint>& bends,
                      const Incidence& incidence, std::uint32_t place);
template <class Constraint>
shared::ConstraintShare entryAt(Shares, const std::vector<Constraint>& constraints,
                                const Incidence& incidence, std::uint32_t place) {
    const std::uint32_t entry = incidence.entries[place];
    return {entry / 4, weightsOf(constraints[entry / 4])[entry % 4]};
}

/// Ascending: the places of `vertices` in the lists of an incidence.
std::vector<std::uint32_t> placesOf(const Incidence& incidence,
                                    const std::vector<std::uint32_t>& vertices);

/// Ascending: the places with entries that a change of the lists of `vertices` touched.
template <class Gather, class Constraint>
std::vector<std::uint32_t> changedPlaces(Gather, const std::vector<Constraint>&,
                                         const Incidence& incidence,
                                         const std::vector<std::uint32_t>& vertices) {
    return placesOf(incidence, vertices);
}
/// A spoke stores the number of spokes at its far end.
std::vector<std::uint32_t> changedPlaces(Spokes, const std::vector<EdgeConstraint>& edges,
                                         const Incidence& incidence,
                                         std::vector<std::uint32_t> vertices);

}  // namespace kerf
