#pragma once

#include "sim/base/pausing.h"
#include "sim/body/body_model.h"
#include "sim/body/ispc_set.h"
#include "sim/body/piece_masses.h"
#include "sim/body/record_editor.h"
#include "sim/body/skin_normals.h"
#include "sim/cut/cut_types.h"
#include "sim/mesh/piece_labels.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The changes of an update, so that a copy of the model can follow. Lists are ascending, each
/// entry once; arrays may have grown or shrunk besides.
struct BodyChange {
    /// Vertices that are new, dead or in another piece, and the origins of the pieces.
    LabelChange pieces;
    /// Vertices of which the area, the skin normal, the piece or the number of constraints
    /// changed.
    std::vector<std::uint32_t> vertices;
    ListChange triangles;
    std::vector<std::uint32_t> neighbourLists;  ///< vertices whose list changed
    std::array<ListChange, kConstraintTypes> constraints;
};

/// The material of a member of a body, as multiples of the parameters.
struct MemberMaterial {
    double modulus = 1;
    double density = 1;
    double skin = 0;  ///< see BodyMember::skin [m]
};

/// Updates the model of a body through cuts, at the cost of what each of them touches. As a set,
/// the result is that of buildBodyModel() for the cut mesh, except for the ISPCs: one is kept, bit
/// for bit, unless its vertex is a corner of a new or changed triangle, its triangle died or
/// changed, its rest segment crosses a new wall, or its ends are now in two pieces. Vertices whose
/// ISPC is not kept get a new one, cast in rest space.
class BodyUpdater {
  public:
    /// The mesh must outlive the updater. `firstVertices`: the first vertex of each model that the
    /// body consists of, ascending from 0; empty for one model.
    explicit BodyUpdater(const SurfaceMesh& mesh, std::span<const int> firstVertices = {});
    /// A copy is for the same mesh, in the state at the time of the copy.
    BodyUpdater(const BodyUpdater&) = default;
    BodyUpdater(BodyUpdater&&) = default;
    BodyUpdater& operator=(const BodyUpdater&) = delete;

    const BodyModel& model() const { return model_; }
    /// The piece of each vertex of the closed mesh, hidden ones too; -1 for unused ones.
    const std::vector<int>& pieceOfMeshVertex() const { return labels_.ofVertex(); }
    /// Vertices with only absent triangles, ascending.
    std::vector<int> hiddenVertices() const;
    /// Follows a step of the cutter.
    BodyChange update(const CutDelta& delta);
    /// Sets the material of each member. Returns whether any changed: then all masses and
    /// compliances do.
    bool setMaterials(std::span<const MemberMaterial> materials);
    /// How ISPCs are cast; along the normal at first.
    IspcRays ispcRays() const { return ispcs_->rays(); }
    /// Recasts all ISPCs.
    BodyChange castIspcs(IspcRays rays);

    /// Writes or reads all that cuts have changed (ByteArchive); reading needs an updater of the
    /// same uncut body, and the mesh as it was.
    template <class Archive>
    void archive(Archive& io) {
        io(model_, labels_, skinNormals_, areas_, memberOfPiece_, slotOfTriangle_, slotsOfEdge_,
           halfEdgesOfEdge_, halfEdgesOfBend_, absent_, triangleRooms_, neighbourRooms_,
           constraintRooms_);
        if constexpr (Archive::kReads) {
            ispcs_.emplace(mesh_, model_, io);
        } else {
            ispcs_->write(io);
        }
    }

  private:
    /// The records that a half-edge shares with its twin; -1 for none.
    struct EdgeSlots {
        int edge = -1;
        int bend = -1;
    };

    void buildShell(std::span<const int> firstVertices);
    void tellMembers(std::span<const int> firstVertices);
    void measureUncutBody();
    void buildTriangles();
    void buildEdgesAndBends();
    void listConstraints();
    void followMembers(std::span<const int> sources);
    int nearestOldPiece(int piece) const;
    void growVertices();
    void updateAreas(const CutDelta& delta, std::span<const int> changed, BodyChange& change);
    void updateSkinNormals(const CutDelta& delta, std::span<const int> changed,
                           std::span<const std::uint32_t> vertices);
    void followAbsent(std::span<const int> changed);
    void updateMasses();
    void updateTriangles(std::span<const int> changed, BodyChange& change);
    void updateRims(std::span<const int> changed,
                    RecordEditor<std::array<std::uint32_t, 4>>& triangles);
    void updateShell(std::span<const int> changed, BodyChange& change);
    void addEdge(int halfEdge, RecordEditor<EdgeConstraint>& edges,
                 RecordEditor<BendConstraint>& bends);
    void updateIspcs(std::span<const int> changed, BodyChange& change);
    /// Begins an edit of the constraints of a type.
    template <class Constraint>
    RecordEditor<Constraint> edit(std::vector<Constraint>& list, std::uint32_t type) {
        return {list, model_.incidences[type], constraintRooms_[type]};
    }
    void updateNeighbours(std::span<const std::uint32_t> vertices);
    std::array<std::uint32_t, 4> taggedTriangle(int triangle) const;
    int presentPieceOf(int vertex) const;
    double vertexArea(int vertex) const;
    const BodyMember& memberAt(int halfEdge) const;
    double thicknessAt(int halfEdge) const;
    double skinAt(int halfEdge) const;
    void renewEdges();

    const SurfaceMesh& mesh_;
    BodyModel model_;
    [[maybe_unused, no_unique_address]] PauseOfCopies afterModel_;
    PieceLabels labels_;
    SkinNormals skinNormals_;
    std::vector<VertexAreas> areas_;  ///< by piece
    std::vector<int> memberOfPiece_;
    [[maybe_unused, no_unique_address]] PauseOfCopies afterPieces_;
    std::vector<int> slotOfTriangle_;     ///< in model_.triangles, by mesh slot; -1 for dead ones
    std::vector<EdgeSlots> slotsOfEdge_;  ///< by half-edge
    std::vector<std::pair<int, int>> halfEdgesOfEdge_;  ///< by edge record
    std::vector<std::pair<int, int>> halfEdgesOfBend_;  ///< by bend record
    std::vector<int> absent_;                           ///< mesh slots, ascending
    IncidenceRooms triangleRooms_, neighbourRooms_;
    std::array<IncidenceRooms, kConstraintTypes> constraintRooms_;
    [[maybe_unused, no_unique_address]] PauseOfCopies afterRooms_;
    std::optional<IspcSet> ispcs_;
};

}  // namespace kerf
