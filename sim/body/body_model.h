#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shaders/shared/constraints.h"
#include "sim/cut/cutter.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// What touches each vertex, in a fixed order: entries[offsets[v] .. offsets[v+1]) are
/// 4 * element + slot (slot: which of the element's vertices v is).
struct Incidence {
    std::vector<std::uint32_t> offsets;  ///< vertexCount + 1
    std::vector<std::uint32_t> entries;
};

/// A closed piece: its triangles lie together in BodyModel::triangles.
struct PieceModel {
    std::uint32_t firstTriangle = 0;
    std::uint32_t triangleCount = 0;
    std::uint32_t vertexCount = 0;
    double restVolume = 0;  ///< [m^3]
    double restArea = 0;    ///< [m^2]
    /// False for debris (less than 1e-4 of the uncut body, or less than a tetrahedron): a volume
    /// constraint would throw it about.
    bool holdsVolume = true;
};

/// The constant set-up of a soft body: rest shape, constraints, masses. Built from a mesh in rest
/// space; a cut makes a new one from the old (updateBodyModel). Vertex indices are the mesh's.
struct BodyModel {
    std::vector<Vec3f> restPositions;  ///< [m], shape [vertexCount]
    /// Mass at density 1 [m^3]: the piece's rest volume, shared in proportion to
    /// max(A_v / S, 0.05 / N); 0 for unused vertices. Multiply by the density for kg.
    std::vector<float> unitMass;
    /// Living triangles ordered by piece: three vertices, then kind | piece << 8 (see BodyView).
    std::vector<std::array<std::uint32_t, 4>> triangles;
    std::vector<int> meshTriangle;   ///< mesh slot of each entry of `triangles`
    std::vector<int> pieceOfVertex;  ///< -1 for unused vertices
    std::vector<PieceModel> pieces;
    std::vector<shared::EdgeConstraint> edges;
    std::vector<shared::BendConstraint> bends;
    std::vector<shared::IspcConstraint> ispcs;
    std::vector<int> ispcMeshTriangle;  ///< mesh slot of the triangle each ISPC ends on
    Incidence triangleIncidence;
    Incidence edgeIncidence;
    Incidence bendIncidence;
    Incidence ispcIncidence;
    // Fixed at load, carried along by cuts.
    double thickness = 0;        ///< shell thickness t = V0 / S of the uncut body [m]
    double edgeLength = 0;       ///< mean rest edge length of the uncut body [m]
    double uncutRestVolume = 0;  ///< [m^3]
};

/// The running state on the CPU, shape [vertexCount].
struct BodyState {
    std::vector<Vec3f> positions;   ///< [m]
    std::vector<Vec3f> velocities;  ///< [m/s]
};

/// Everything from the rest shape of `mesh`.
BodyModel buildBodyModel(const SurfaceMesh& mesh);

/// The model after a cut: edges and bends are built anew; an ISPC is kept, bit for bit, unless its
/// vertex is a corner of a new or changed triangle, its triangle died or changed, its
/// rest segment crosses a new wall, or its ends fell into two pieces. Those vertices get a new one,
/// cast in rest space.
BodyModel updateBodyModel(const BodyModel& before, const SurfaceMesh& mesh, const CutDelta& delta);

}  // namespace kerf
