#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_finder.h"

namespace kerf {

namespace cut {
class StrokeSurface;
}

/// Cuts a mesh by strokes of a blade. Each step is one transaction: a closed mesh and the strip
/// that the blade swept become a closed mesh, or the step is refused and nothing changes. Every
/// piece of the body has its own step: where several are swept, some may be cut and some refused,
/// and pieces that overlap do not disturb each other.
class Cutter {
  public:
    /// The mesh must outlive the cutter and be changed by nobody else during a stroke, except for
    /// positions and velocities.
    Cutter(SurfaceMesh& mesh, const CutSettings& settings);
    ~Cutter();
    Cutter(Cutter&&) noexcept;
    Cutter& operator=(Cutter&&) noexcept;
    /// A copy goes on for the same mesh, as it was when the copy was made: bit for bit.
    Cutter(const Cutter& other);
    Cutter& operator=(const Cutter&) = delete;

    /// Does ahead what the first steps would otherwise do on the way, so that none of them takes
    /// long. O(n log n).
    void prepare();
    /// Looks triangles up by `finder`, which must outlive the cutter and its copies and know how
    /// the mesh moves. Null: by a tree of the cutter's own, as at the start.
    void useFinder(TriangleFinder* finder);
    /// Promises that since the previous call of this, begin(), advance() or finish() no vertex has
    /// moved farther than `distance` [m]. A step that was promised nothing looks at the whole mesh.
    void boundMotion(double distance);
    /// How finely it cuts. wallCoarsening, debrisVolume and search may be set at any time, openCut
    /// for the next stroke; the others must stay as they are.
    CutSettings& settings();
    /// What searches took since this was last asked.
    SearchWork takeSearchWork();

    /// Places the blade without cutting and starts a stroke.
    void begin(const Blade& blade);
    /// Cuts from where the last successful step ended to `blade`. Where that lies behind the cut
    /// the cut stays, and goes on once the blade is ahead of it again. Where a step does not
    /// succeed the front in that piece is let go, and the cut starts anew behind it (in a body
    /// that moves only after two refusals in a row, since the next step may succeed); after three
    /// refusals it starts anew at the blade, and the front stays as a slit.
    CutResult advance(const Blade& blade);
    /// Ends the stroke: cuts what the gate held back, lets go of the front, cleans up, closes the
    /// wounds of the open course, removes debris.
    CutResult finish();

    /// Removes short edges of these triangles, where the body stays folded; between strokes only.
    /// They are judged by how they rest, however crumpled they are. Does nothing without
    /// CutSettings::cleanUp.
    CutDelta mend(const std::vector<int>& triangles);

    /// Whether a stroke has begun and not finished.
    bool inStroke() const;
    /// Whether the running stroke has made walls.
    bool hasCut() const;
    /// The number of the stroke, or of the last one, as in SurfaceMesh::wallLabel. A stroke that
    /// has not cut leaves its number to the next.
    int strokeNumber() const;
    /// The old rungs of all pieces, each from A to B, one after the other: empty outside a stroke.
    /// Positions are those after the last step that moved them; vertices follow the mesh.
    const std::vector<RungNode>& rung() const;
    /// The box into which a step to the poses of `path` (at least one) will look, if what the rung
    /// is tied to goes on for `time` [s] as it moves now; with room for what goes otherwise.
    OrientedBox reach(std::span<const Blade> path, double time) const;
    /// The vertices that a step reads wherever they are, besides those in reach().
    std::vector<int> followedVertices() const;
    /// The body's surface as it was when the stroke began.
    const cut::StrokeSurface& strokeSurface() const;
    /// The edge length about the rung, by which a step maps new walls from that surface [m].
    double edgeLengthAtFront() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kerf
