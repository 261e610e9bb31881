#pragma once

#include "sim/mesh/box_tree.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// A vertex that represents a part of the surface.
struct SurfaceSample {
    int vertex = -1;    ///< vertex of the mesh
    double weight = 0;  ///< how many triangles it represents
};

/// Calls visit(sample) for those of the samples whose vertices belong to `piece`, in their order.
template <class Visit>
void forEachOfPiece(const std::vector<SurfaceSample>& samples,
                    const std::vector<int>& pieceOfVertex, int piece, Visit visit) {
    for (const SurfaceSample& sample : samples) {
        if (pieceOfVertex[sample.vertex] == piece) {
            visit(sample);
        }
    }
}

/// Boxes around a few clusters of `places` (at least one), with room for a blade that advances by
/// some `h`.
std::vector<Bounds> boxesAround(std::vector<Vec3> places, double h);

/// The vertices around `boxes` (rest space), each once: all near them, fewer with distance relative
/// to `h`, so that their number grows with the logarithm of the body. `tree` holds triangles by
/// their box at rest, `cornersOf(id)` gives their corners. `slots`: -1 for each vertex, before and
/// after. (Thinned by distance as in Barnes and Hut 1986.)
std::vector<SurfaceSample> thinByDistance(BoxTree& tree,
                                          const std::function<const Triangle&(int id)>& cornersOf,
                                          const std::vector<Bounds>& boxes, double h,
                                          std::vector<int>& slots);

/// The surface of the body when a stroke began, before its triangles were divided: the skin and the
/// walls of earlier strokes, searched by rest position.
class StrokeSurface {
  public:
    /// Takes the present surface; the mesh must outlive the object. O(n). Each look-up refines a
    /// tree over the surface.
    explicit StrokeSurface(const SurfaceMesh& mesh);
    /// Refines the tree in advance, which look-ups would do lazily. O(n log n).
    void prepare();

    /// Takes the present surface of the mesh, at the cost of the changes passed to follow().
    void beginStroke();
    /// Records the triangle slots that were added, removed or changed since the last call, and the
    /// largest motion of a vertex at rest [m].
    void follow(std::span<const int> triangles, double restMotion);

    /// The vertex count of the mesh when the stroke began.
    int vertexCount() const { return vertexCount_; }

    /// Samples of the surface around these places at rest, all at vertices in use (thinByDistance).
    /// `edge`: the edge length that matters there [m].
    std::vector<SurfaceSample> samplesAround(std::vector<Vec3> restPlaces, double edge) const;

    /// Appends what the last samplesAround() found; a step reads their positions and velocities,
    /// however distant.
    void addVertices(std::vector<int>& vertices) const;

    /// The present position of vertex v, made since, on the undivided surface: by the barycentric
    /// coordinates of its rest position. A vertex that the stroke puts on the surface is light; it
    /// slips sideways and folds the slivers around it over. Nothing for older vertices, and for
    /// those that rest farther than `reach` [m] from the surface.
    std::optional<Vec3> flatPosition(int v, double reach) const;

    /// The position of a vertex at `position`, which rests at `rest` inside the body, if moved to
    /// at least half of its depth below the undivided surface. Nothing if it has that, or rests
    /// deeper than `reach` [m].
    std::optional<Vec3> insidePosition(const Vec3& rest, const Vec3& position, double reach) const;

    /// Writes or reads all of it (ByteArchive): samples depend on how the tree is divided.
    template <class Archive>
    void archive(Archive& io) {
        io(vertexCount_, triangles_, changed_, tree_);
    }

  private:
    /// A triangle of the surface when the stroke began.
    struct FormerTriangle {
        Triangle corners{-1, -1, -1};
        int wallLabel = -1;
    };
    /// The samples of the last look-up; valid until the blade has left the boxes.
    struct Thinned {
        std::vector<Bounds> boxes;
        double edge = 0;
        std::vector<SurfaceSample> samples;
        bool covers(const std::vector<Vec3>& places) const;
    };
    BoxTree& tree() const;
    Bounds restBounds(int slot) const;
    std::vector<int> trianglesNear(const Vec3& rest, double reach) const;
    bool isWhole(const Triangle& corners) const;
    bool isBeside(int v, int wallLabel) const;

    const SurfaceMesh& mesh_;
    int vertexCount_ = 0;
    std::vector<FormerTriangle> triangles_;  ///< by their slots in the mesh
    std::vector<int> changed_;
    mutable Thinned thinned_;
    /// The tree of the triangles that were alive; made on first use, refined and refit by searches.
    mutable std::optional<BoxTree> tree_;
    mutable std::vector<int> slots_;  ///< room for thinByDistance
};

}  // namespace kerf::cut
