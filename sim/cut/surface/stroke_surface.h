#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/cut/surface/surface_samples.h"
#include "sim/mesh/box_tree.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The surface of the body as it was when a stroke began, before its triangles were divided: the
/// skin and the walls of earlier strokes, found by where they rest.
class StrokeSurface {
  public:
    /// Takes the surface as it is; the mesh must outlive the object. O(n). Each look-up divides a
    /// tree over the surface further.
    explicit StrokeSurface(const SurfaceMesh& mesh);
    /// Divides the tree ahead, which look-ups would do on the way. O(n log n).
    void prepare();

    /// Takes the surface of the mesh as it is now, at the cost of what follow() told of.
    void beginStroke();
    /// Notes the triangle slots that were added or removed, or of which a corner changed, since the
    /// last call, and how far a vertex was moved at rest at most [m].
    void follow(std::span<const int> triangles, double restMotion);

    /// The vertex count of the mesh when the stroke began.
    int vertexCount() const { return vertexCount_; }

    /// Samples of the surface around these places at rest, all at vertices in use (thinByDistance).
    /// `edge`: the edge length that matters there [m].
    std::vector<SurfaceSample> samplesAround(std::vector<Vec3> restPlaces, double edge) const;

    /// Appends what the last samplesAround() found; a step reads positions and velocities of these
    /// however far off they are.
    void addVertices(std::vector<int>& vertices) const;

    /// The position that vertex v, made since, would have now on the undivided surface: by the
    /// barycentric coordinates of its rest position. A vertex that the stroke puts on the surface
    /// is light; it slips aside and folds the slivers around it over. Nothing for older vertices,
    /// and for those that rest farther than `reach` [m] from the surface beside them.
    std::optional<Vec3> flatPosition(int v, double reach) const;

    /// The position that a vertex at `position`, which rests at `rest` inside the body, would have
    /// if it had kept at least half of its depth below the undivided surface. Nothing where it has,
    /// and where it rests deeper than `reach` [m].
    std::optional<Vec3> insidePosition(const Vec3& rest, const Vec3& position, double reach) const;

  private:
    /// A triangle of the surface when the stroke began.
    struct FormerTriangle {
        Triangle corners{-1, -1, -1};
        int wallLabel = -1;
    };
    /// The samples last looked up; they serve until the blade has left the boxes.
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
    /// The tree of the triangles that were alive; made when it is first asked, divided and refit by
    /// finding.
    mutable std::optional<BoxTree> tree_;
    mutable std::vector<int> slots_;  ///< room for thinByDistance
};

}  // namespace kerf::cut
