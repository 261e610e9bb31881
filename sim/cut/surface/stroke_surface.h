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
    /// The surface as it is; the mesh must outlive it. O(n). What is looked up divides a tree over
    /// it further.
    explicit StrokeSurface(const SurfaceMesh& mesh);
    /// Does at once what looking up would do on the way. O(n log n).
    void prepare();

    /// The surface of the mesh as it is now, at the cost of what follow() told of.
    void beginStroke();
    /// Triangle slots that were added or removed, or of which a corner changed, since the last
    /// call, and how far a vertex was moved at rest at most [m].
    void follow(std::span<const int> triangles, double restMotion);

    /// Of the mesh when the stroke began.
    int vertexCount() const { return vertexCount_; }

    /// Vertices of the surface in use around these places at rest: see thinByDistance. `edge`: the
    /// edge length that matters there [m].
    std::vector<SurfaceSample> samplesAround(std::vector<Vec3> restPlaces, double edge) const;

    /// Appends what the last samplesAround() found; a step reads positions and velocities of these
    /// however far off they are.
    void addVertices(std::vector<int>& vertices) const;

    /// Where vertex v, made since, would be now on the undivided surface: by the barycentric
    /// coordinates of its rest position. A vertex that the stroke puts on the surface is light; it
    /// slips aside and folds the slivers around it over. Nothing for older vertices, and for those
    /// that rest farther than `reach` [m] from the surface beside them.
    std::optional<Vec3> flatPosition(int v, double reach) const;

    /// `position`, of what rests at `rest` inside the body, as it would be if it had kept at least
    /// half of its depth below the undivided surface. Nothing where it has, and where it rests
    /// deeper than `reach` [m].
    std::optional<Vec3> insidePosition(const Vec3& rest, const Vec3& position, double reach) const;

  private:
    struct Part {
        Triangle corners{-1, -1, -1};
        int wallLabel = -1;
    };
    /// What was last looked up; it serves until the blade has left the boxes.
    struct Thinned {
        std::vector<Bounds> boxes;
        double edge = 0;
        std::vector<SurfaceSample> samples;
        bool covers(const std::vector<Vec3>& places) const;
    };
    BoxTree& tree() const;
    Bounds restBounds(int part) const;
    std::vector<int> partsNear(const Vec3& rest, double reach) const;
    bool isWhole(const Triangle& corners) const;
    bool isBeside(int v, int wallLabel) const;

    const SurfaceMesh& mesh_;
    int vertexCount_ = 0;
    std::vector<Part> parts_;  ///< by triangle slot of the mesh then
    std::vector<int> changed_;
    mutable Thinned thinned_;
    /// Of the parts that were alive; made when it is first asked, divided and refit by finding.
    mutable std::optional<BoxTree> tree_;
    mutable std::vector<int> slots_;  ///< room for thinByDistance
};

}  // namespace kerf::cut
