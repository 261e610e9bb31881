#pragma once

#include <vector>

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/plan/slit_opening.h"
#include "sim/cut/surface/broad_phase.h"
#include "sim/cut/surface/edge_length_field.h"
#include "sim/cut/surface/stroke_surface.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Which vertices predicates see on the undivided surface (StrokeSurface) instead of where they
/// are.
enum class Unfold {
    nothing,
    front,  ///< those of the old rung
    around  ///< also those around the front's ends
};

/// One level of the retry ladder. Lengths are shares of h.
struct Attempt {
    int index = 0;
    double offsetScale = 1;  ///< length of the blade's offset, in units of the setting
    /// Predicates see mates that lie within this of their mean there (commonPosition).
    double closing = 0;
    Unfold unfold = Unfold::nothing;
    bool touching = false;      ///< vertices of other pieces on a front node belong to it
    double tolerance = 0;       ///< nodes closer than this are one
    double shake = 0;           ///< virtual displacement of the front in the predicates
    double gap = 0;             ///< front ends closer than this across a slit are one node
    bool ignoreFringe = false;  ///< walls next to the front are not cut
};

/// Which part of the blade goes on, by its parameters.
struct BladeSpan {
    double from = 0;
    double to = 1;
    /// The ends stay where the old rung ends: beyond them the front stays.
    bool holdsFrom = false;
    bool holdsTo = false;
};

/// All that one try of a step reads; nothing here changes during the try.
struct StepInput {
    const SurfaceMesh& mesh;
    const BroadPhase& broadPhase;
    const std::vector<int>& pieceOfVertex;
    const StrokeSurface& surface;
    const SlitOpening& opening;
    const std::vector<RungNode>& rung;  ///< positions up to date, s along `blade`
    Blade blade;
    BladeSpan span;
    double h = 0;       ///< edge length about the rung [m]
    double offset = 0;  ///< length of the blade's offset at scale 1, share of h
    const EdgeLengthField& edgeLengths;
    std::uint64_t seed = 0;
    int stroke = 0;
    int pass = 0;               ///< of the blade through the body, counted over all strokes
    int firstVertexOfPass = 0;  ///< vertices from here on were made in the pass
    Attempt attempt;
    Bounds body{};  ///< what lies outside of this box is in the air; empty where nothing is known
    bool atRest = false;  ///< every vertex lies still where it rests
};

/// Attempt::closing where older slits are to close, share of h.
inline constexpr double kCloseDistance = 1.0;
/// The same where only the noise of positions that were rounded is to go.
inline constexpr double kCloseNoise = 1e-4;

}  // namespace kerf::cut
