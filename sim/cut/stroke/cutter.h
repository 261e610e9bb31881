#pragma once

#include "sim/base/byte_archive.h"
#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

namespace cut {
class StrokeSurface;
}

/// Cuts a mesh by strokes of a blade. Each step is one transaction: a closed mesh and the strip
/// that the blade swept become a closed mesh, or the step is refused and nothing changes. Every
/// piece of the body has its own step: if several are swept, some may be cut and some refused, and
/// overlapping pieces are independent.
class Cutter {
  public:
    /// The mesh must outlive the cutter. During a stroke nobody else may change it, except
    /// positions and velocities.
    Cutter(SurfaceMesh& mesh, const CutSettings& settings);
    ~Cutter();
    Cutter(Cutter&&) noexcept;
    Cutter& operator=(Cutter&&) noexcept;
    /// A copy continues on the same mesh, in its state at the time of the copy, bit for bit.
    Cutter(const Cutter& other);
    Cutter& operator=(const Cutter&) = delete;

    /// Writes what the mesh does not tell of a cutter between two strokes.
    void write(ByteWriter& to) const;
    /// A cutter of the present mesh between two strokes, which reads that. `uncut`: of the uncut
    /// body.
    Cutter(const Cutter& uncut, ByteReader& from);

    /// Does in advance what the first steps would do, so that none of them takes long. O(n log n).
    void prepare();
    /// Finds triangles with `finder`, which must outlive the cutter and its copies and follow the
    /// motion of the mesh. Null: with the cutter's own tree, the default.
    void useFinder(TriangleFinder* finder);
    /// Promises that since the previous call of this, begin(), advance() or finish() no vertex has
    /// moved farther than `distance` [m]. Without a promise a step examines the whole mesh.
    void boundMotion(double distance);
    /// The settings. wallCoarsening, debrisVolume and search may be set at any time, openCut for
    /// the next stroke; the others must not change.
    CutSettings& settings();
    /// The cost of searches since the last call.
    SearchWork takeSearchWork();

    /// Places the blade without cutting and starts a stroke.
    void begin(const Blade& blade);
    /// Goes on with the stroke that made a slit, from its end; `blade` lies along that. No other
    /// may be in progress.
    void goOnFrom(const SlitFront& front, const Blade& blade);
    /// Cuts from the end of the last successful step to `blade`. Where the blade is behind the cut,
    /// the cut stays, and continues once the blade is ahead of it again. If a step fails, the front
    /// in that piece is dropped, and the cut restarts behind it (in a moving body only after two
    /// refusals in a row, since the next step may succeed); after three refusals it restarts at the
    /// blade, and the front stays as a slit.
    CutResult advance(const Blade& blade);
    /// Ends the stroke: cuts what the gate delayed, drops the front, cleans up, closes the wounds
    /// of the open cut, removes debris.
    CutResult finish();

    /// Removes short edges of these triangles, where the body stays folded; only between strokes.
    /// Judges by the rest shape, however crumpled they are. Does nothing without
    /// CutSettings::cleanUp.
    CutDelta mend(const std::vector<int>& triangles);

    /// Removes the piece of a vertex; only between strokes.
    CutDelta removePieceAt(int vertex);

    /// Whether a stroke is in progress.
    bool inStroke() const;
    /// Whether the running stroke has made walls.
    bool hasCut() const;
    /// The number of the stroke, or of the last one, as in SurfaceMesh::wallLabel. A stroke that
    /// has not cut leaves its number to the next.
    int strokeNumber() const;
    /// The old rungs of all pieces, each from A to B, one after the other: empty outside a stroke.
    /// Positions are those after the last step that moved them; vertices follow the mesh.
    const std::vector<RungNode>& rung() const;
    /// The box that a step to the poses of `path` (at least one) will search, if what the rung is
    /// tied to keeps its velocity for `time` [s]; with a margin.
    OrientedBox reach(std::span<const Blade> path, double time) const;
    /// The vertices that a step reads besides those in reach().
    std::vector<int> followedVertices() const;
    /// The body's surface as it was when the stroke began.
    const cut::StrokeSurface& strokeSurface() const;
    /// The edge length about the rung, used to map new walls from that surface [m].
    double edgeLengthAtFront() const;
    /// How far the front may lag behind the blade, in edge lengths: CutSettings::gate, or more
    /// where walls are graded.
    double gateAtFront() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kerf
