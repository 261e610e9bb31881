#pragma once

#include <cstdint>
#include <vector>

#include "gpu/buffer.h"
#include "sim/body/body_updater.h"
#include "sim/solve/gathered_records.h"
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

/// The rest shape and the constraints of a body on the GPU: constant but for cuts. All that
/// allocates throws gpu::OutOfMemory.
struct SolverModel {
    /// Shape [vertexCount].
    std::vector<float> areas;  ///< rest area of each vertex [m^2]
    std::vector<int> pieceOf;  ///< of each vertex, -1 for none
    double diagonal = 0;       ///< of the body at rest [m]

    gpu::Buffer restPositions, cutSkinNormals, links, areaBuffer;
    gpu::Buffer triangles;
    gpu::Buffer edgeRanges, spokes;
    gpu::Buffer bends, bendRanges, bendEntries;
    gpu::Buffer ispcs, ispcRanges, ispcShares;
    IncidenceBuffers triangleIncidence, neighbours;

    // A new body, in portions of about the same size.
    void takeVertices(const BodyModel& model);
    void uploadRestShape(const BodyModel& model);
    void uploadTriangles(const BodyModel& model) { triangles.assign(model.triangles); }
    void uploadSpokes(const BodyModel& model);
    void uploadBends(const BodyModel& model) { bends.assign(allBendRecords(model)); }
    void uploadIspcs(const BodyModel& model) { ispcs.assign(model.ispcs); }
    void uploadBendLists(const BodyModel& model);
    void uploadIspcShares(const BodyModel& model);
    void uploadTriangleLists(const BodyModel& model);

    /// Follows a change, at the cost of what changed.
    void update(const BodyModel& model, const BodyChange& change, Scatter& scatter);

  private:
    void updateVertices(const BodyModel& model, const BodyChange& change, Scatter& scatter);
    void updateSpokes(const BodyModel& model, const BodyChange& change, Scatter& scatter);
    void updateBends(const BodyModel& model, const BodyChange& change, Scatter& scatter);
    void updateIspcs(const BodyModel& model, const BodyChange& change, Scatter& scatter);

    BendLists bendLists_;
};

}  // namespace kerf
