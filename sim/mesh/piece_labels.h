#pragma once

#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/union_find.h"

namespace kerf {

/// The measures of a piece in the rest shape.
struct PieceContent {
    int triangles = 0;
    int vertices = 0;
    double restVolume = 0;  ///< signed [m^3]; 0 if not measured
    double restArea = 0;    ///< [m^2]; 0 if not measured
};

/// A vertex that moved to another piece; -1 is none.
struct LabelMove {
    int vertex = -1;
    int from = -1;
    int to = -1;
};

/// The outcome of an update.
struct LabelChange {
    /// Vertices that are new, dead, or in another piece now, each once.
    std::vector<LabelMove> moves;
    /// Per piece: its origin before the update; -1 if all its vertices are new.
    std::vector<int> source;
    /// Whether a piece separated, vanished, or was joined to another.
    bool piecesChanged = false;
};

/// The pieces of a mesh: its shells, those of cavities merged with the shells around them (see
/// cavities.h). They are updated while the mesh is cut: an update costs what the change touched,
/// and the smaller part of a piece that separates. The largest part keeps the label, so labels are
/// ordered by age; they are dense. With cavities, all are relabelled when a shell separates.
class PieceLabels {
  public:
    /// Which measures are maintained.
    enum class Measures { none, volumes, volumesAndAreas };

    /// Labels in the order of the pieces' lowest vertices. O(n).
    explicit PieceLabels(const SurfaceMesh& mesh, Measures measures = Measures::volumesAndAreas);

    /// Maintains at least volumes from now on. O(n) the first time. The labels must be up to date.
    void measureVolumes(const SurfaceMesh& mesh);

    /// Follows a change of the mesh. `triangles`: the slots that were added or removed, or of which
    /// a corner or its rest position changed; each once. If pieces were joined, or one vanished
    /// that is not the youngest, all are relabelled in the same order, O(n).
    LabelChange update(const SurfaceMesh& mesh, std::span<const int> triangles);

    const std::vector<int>& ofVertex() const { return ofVertex_; }  ///< -1 for unused vertices
    const std::vector<PieceContent>& pieces() const { return pieces_; }
    /// Whether a piece had several shells when the labels were made.
    bool hasCavities() const { return hasCavities_; }

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(ofVertex_, pieces_, counted_, measures_, hasCavities_, shares_, placeOfVertex_,
           partOfTriangle_);
    }

  private:
    /// A triangle as it was counted.
    struct Counted {
        Triangle corners{-1, -1, -1};
        bool counted = false;
    };
    /// The volume and the area that a triangle adds to its piece.
    struct Share {
        double volume = 0;
        double area = 0;
    };
    class Splitter;

    void labelAll(const SurfaceMesh& mesh, UnionFind sets);
    UnionFind piecesOf(const SurfaceMesh& mesh) const;
    int firstEmptyPiece() const;
    bool onlyEmptyFrom(int label) const;
    void keepOrder(LabelChange& change);
    std::vector<int> labelsBefore(const LabelChange& change, std::size_t vertices) const;
    LabelChange labelAnew(const SurfaceMesh& mesh, const std::vector<int>& before);
    std::vector<int> touchedVertices(const SurfaceMesh& mesh, std::span<const int> triangles,
                                     std::vector<LabelMove>& moves);
    void comeOff(const SurfaceMesh& mesh, const std::vector<int>& triangles, int from,
                 std::vector<LabelMove>& moves);
    void labelNewVertices(const std::vector<int>& vertices, int label,
                          std::vector<LabelMove>& moves);
    void setLabel(int vertex, int label, std::vector<LabelMove>& moves);
    void count(const SurfaceMesh& mesh, int triangle);
    void discount(int triangle);
    void moveShares(const std::vector<int>& triangles, int from, int to);
    void addShare(int triangle, int sign, PieceContent& piece) const;
    Share shareOf(const SurfaceMesh& mesh, int triangle) const;
    bool measures() const { return measures_ != Measures::none; }

    std::vector<int> ofVertex_;
    std::vector<PieceContent> pieces_;
    std::vector<Counted> counted_;  ///< by triangle slot
    Measures measures_;
    bool hasCavities_ = false;
    std::vector<Share> shares_;  ///< by triangle slot; empty where nothing is measured
    // Room for searches, -1 between them.
    std::vector<int> placeOfVertex_;   ///< among the touched ones
    std::vector<int> partOfTriangle_;  ///< empty until a piece may have separated
};

}  // namespace kerf
