#pragma once

#include "shaders/shared/body_records.h"
#include "sim/body/constraint_lists.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The running state on the CPU, shape [vertexCount].
struct BodyState {
    std::vector<Vec3f> positions;   ///< [m]
    std::vector<Vec3f> velocities;  ///< [m/s]
};

/// The state of these vertices of `mesh`, in this order, rounded to float.
BodyState stateOf(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& vertices);
/// The state of all vertices of `mesh`, rounded to float.
BodyState stateOf(const SurfaceMesh& mesh);

/// A piece of the body. Counts, areas and masses are those of present triangles; the volume is that
/// of the closed mesh.
struct PieceModel {
    std::uint32_t triangleCount = 0;
    std::uint32_t vertexCount = 0;
    double restVolume = 0;   ///< [m^3]
    double restArea = 0;     ///< [m^2]
    double leastArea = 0;    ///< of a vertex, as far as its mass goes [m^2]
    double massPerArea = 0;  ///< at density 1, times that of its member [m]
    /// False for debris (less than 1e-4 of the uncut body, or less than a tetrahedron), which a
    /// volume constraint would throw about, and for an open piece.
    bool holdsVolume = true;
    bool open = false;   ///< it has absent walls (SurfaceMesh::absent)
    int rimVertex = -1;  ///< of an open piece: on its border, its volume is measured about it
    int member = 0;      ///< its model, among BodyModel::members
};

/// One of the models that a body consists of. No edges join them.
struct BodyMember {
    double thickness = 0;   ///< shell thickness t = V0 / S, uncut [m]
    double restVolume = 0;  ///< uncut [m^3]
    double modulus = 1;     ///< its Young's modulus, as a multiple of that of the parameters
    double density = 1;     ///< the same of its density
    double skin = 0;        ///< thickness of flesh that is as stiff as the skin over it [m]
};

/// The constant set-up of a soft body: rest shape, constraints, masses. Built from a mesh in rest
/// space; a BodyUpdater carries it through cuts. Vertex indices are the mesh's. Arrays have no
/// gaps; their order has no meaning.
struct BodyModel : ConstraintLists {
    std::vector<Vec3f> restPositions;  ///< [m], shape [vertexCount]
    /// A third of the rest area around each vertex [m^2]; its mass follows from it (see unitMass).
    std::vector<double> vertexAreas;
    /// Normals at rest of vertices that a cut made or divided (see SkinNormals::ofCut), shape
    /// [vertexCount].
    std::vector<Vec3f> cutSkinNormals;
    /// Triangles that are present: three vertices, then surfaceTag() | piece << 8.
    std::vector<std::array<std::uint32_t, 4>> triangles;
    std::vector<int> meshTriangle;   ///< mesh slot of each entry of `triangles`
    std::vector<int> pieceOfVertex;  ///< -1 for unused and hidden vertices
    std::vector<PieceModel> pieces;
    std::vector<int> ispcMeshTriangle;  ///< mesh slot of the triangle each ISPC ends on
    Incidence triangleIncidence;
    /// The vertices around each vertex, counter-clockwise, shared::kAfterGap added to those that
    /// follow an absent triangle.
    Incidence neighbours;
    // Fixed at load, carried along by cuts.
    std::vector<BodyMember> members;  ///< one at least
    double edgeLength = 0;            ///< mean rest edge length of the uncut body [m]
    double diagonal = 0;              ///< of the uncut body's box at rest [m]
    double uncutRestVolume = 0;       ///< [m^3]

    /// The member that a vertex of a piece belongs to.
    const BodyMember& memberOf(std::uint32_t vertex) const {
        return members[pieces[pieceOfVertex[vertex]].member];
    }

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        forEachType(*this, [&](auto, auto& list) { io(list); });
        io(incidences, restPositions, vertexAreas, cutSkinNormals, triangles, meshTriangle,
           pieceOfVertex, pieces, ispcMeshTriangle, triangleIncidence, neighbours, members,
           edgeLength, diagonal, uncutRestVolume);
    }
};

/// Makes the model of a body from the rest shape of `mesh`. `firstVertices`: see BodyUpdater.
BodyModel buildBodyModel(const SurfaceMesh& mesh, std::span<const int> firstVertices = {});

}  // namespace kerf
