#pragma once

#include <map>
#include <set>
#include <vector>

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/surface/broad_phase.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The part of a step that does not change from try to try: how the blade moves from the rung.
struct SweepStep {
    const std::vector<RungNode>& rung;  ///< positions up to date, s along `blade`
    Blade blade;
    double h = 0;  ///< edge length of walls [m]
    int stroke = 0;
    int firstVertexOfPass = 0;     ///< vertices from here on were made in the pass
    const std::set<int>& onSeams;  ///< those of them on walls that it did not make (addSeams)
    /// By vertex: the way in which it opens, a unit vector; zero where it stays. Found when the
    /// sweep first comes near, and kept for the pass: what the front has left open stays open.
    std::map<int, Vec3>& sides;
    double opening = 0;            ///< how far from the sweep walls are seen, share of h
    bool takesSeamsAlong = false;  ///< new vertices in open walls (onSeams) open with them
};

/// Slits of earlier strokes along which the blade runs: the sweep lies within a tenth of an edge
/// and five degrees of their walls. Cut again, they would leave a slab thinner than any useful
/// triangle; instead the predicates see them open, and the blade runs in their gap. Nothing real
/// moves.
class SlitOpening {
  public:
    SlitOpening() = default;
    SlitOpening(const SurfaceMesh& mesh, const BroadPhase& broadPhase, const SweepStep& step);

    bool empty() const { return displacements_.empty(); }
    /// By vertex: how far it is seen away from where it is [m].
    const std::map<int, Vec3>& displacements() const { return displacements_; }
    /// That of v, zero where it has none.
    Vec3 displacement(int v) const;
    /// The largest displacement [m].
    double reach() const { return reach_; }

  private:
    std::map<int, Vec3> displacements_;
    double reach_ = 0;
};

}  // namespace kerf::cut
