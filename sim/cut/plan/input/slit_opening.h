#pragma once

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/surface/broad_phase.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Vertices of a mesh by number, from the first to before the end.
struct VertexRange {
    int first = 0;
    int end = 0;

    bool contains(int v) const { return first <= v && v < end; }
};

/// The inputs of SlitOpening: the blade's path from the rung, and the state of the transit.
struct OpeningInput {
    const std::vector<RungNode>& rung;  ///< positions up to date, s along `blade`
    Blade blade;                        ///< the blade to which the step goes
    double h = 0;                       ///< edge length of walls [m]
    int stroke = 0;                     ///< number of the stroke, as in wall labels
    int firstVertexOfTransit = 0;       ///< vertices from here on were made in the transit
    const std::set<int>& onSeams;       ///< those of them on walls that it did not make (addSeams)
    /// The direction in which each vertex opens, a unit vector; zero where it stays. Found when the
    /// strip first comes near, and kept for the transit: what the front has left open stays open.
    std::map<int, Vec3>& sides;
    double opening = 0;            ///< distance from the strip at which walls are seen, share of h
    bool takesSeamsAlong = false;  ///< new vertices in open walls (onSeams) open with them
    VertexRange past{};            ///< made in the transit, on walls that count as old (OwnPast)
};

/// Whether a vertex lies where the two walls of a stroke meet: at the end of its slit in the body,
/// or on its front. False for a dead one.
bool isEndOfSlit(const SurfaceMesh& mesh, int v, int stroke);

/// The slits of earlier strokes, and of the stroke's own past, along which the blade runs: the
/// strip is within a tenth of an edge and five degrees of their walls. Cut again, they would leave
/// a slab thinner than any useful triangle; instead the predicates see them open, and the blade
/// runs in their gap.
class SlitOpening {
  public:
    /// Opens nothing.
    SlitOpening() = default;
    /// Finds the slits near the strip and the side to which each of their vertices opens.
    SlitOpening(const SurfaceMesh& mesh, const BroadPhase& broadPhase, const OpeningInput& step);

    /// Whether no vertex is displaced.
    bool empty() const { return displacements_.empty(); }
    /// Whether some of them are of the stroke's own past: the blade has come round to it.
    bool opensPast() const { return opensPast_; }
    /// The vertices that are seen displaced, with their displacements [m].
    const std::map<int, Vec3>& displacements() const { return displacements_; }
    /// The displacement of v [m], zero for none.
    Vec3 displacement(int v) const;
    /// The largest displacement [m].
    double reach() const { return reach_; }

  private:
    std::map<int, Vec3> displacements_;
    double reach_ = 0;
    bool opensPast_ = false;
};

}  // namespace kerf::cut
