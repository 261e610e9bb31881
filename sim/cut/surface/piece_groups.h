#pragma once

#include "sim/mesh/piece_labels.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Finds the groups of pieces that the blade cuts as one: pieces still in contact where a cut
/// separated them, so that a step divides the walls on both sides alike. Pieces that moved apart by
/// more than `tolerance` [m] are cut separately: they may overlap. Returns the group of each piece.
/// `before`: the groups so far, which are divided but never joined; empty for none. Reads vertices
/// only while a group has several pieces.
std::vector<int> groupPieces(const SurfaceMesh& mesh, const PieceLabels& pieces, double tolerance,
                             const std::vector<int>& before);

/// The pieces of a body, and the groups of those that are cut together (groupPieces). They follow
/// each change of the mesh within a step, unlike a BodyUpdater: so the two may number pieces
/// differently.
class GroupedPieces {
  public:
    /// The mesh must outlive the object and its copies. O(n).
    explicit GroupedPieces(const SurfaceMesh& mesh)
        : mesh_(mesh), labels_(mesh, PieceLabels::Measures::none) {}

    /// The pieces; their volumes are known once measureVolumes() was called.
    const PieceLabels& labels() const { return labels_; }
    void measureVolumes() { labels_.measureVolumes(mesh_); }

    /// Remakes all groups, of pieces within `tolerance` [m] of each other.
    void group(double tolerance);
    /// Divides groups whose pieces are now apart by more than `tolerance` [m]. Returns the group
    /// that each piece had; nothing if no vertex has moved and no triangle changed since the groups
    /// were made.
    std::optional<std::vector<int>> divide(double tolerance);
    /// Vertices may have moved.
    void noteMotion() { hold_ = false; }
    /// Follows a change of the mesh. `changed`: each once. Separated pieces stay in the group until
    /// they move apart; entirely new ones get the group `groupOfNewPieces`.
    void update(std::span<const int> changed, int groupOfNewPieces);

    /// The numbers of all groups.
    std::set<int> groups() const { return {groupOfPiece_.begin(), groupOfPiece_.end()}; }
    /// The number of the group of a vertex, -1 for none.
    int groupOf(int vertex) const;
    /// The lowest vertex of each of these groups, ascending. O(n), where there is one.
    std::vector<int> lowestVertices(std::set<int> numbers) const;

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(labels_, groupOfPiece_, hold_);
    }

  private:
    const SurfaceMesh& mesh_;
    PieceLabels labels_;
    std::vector<int> groupOfPiece_;  ///< the number of the group of each piece
    bool hold_ = false;              ///< nothing has moved or been cut since they were made
};

}  // namespace kerf::cut
