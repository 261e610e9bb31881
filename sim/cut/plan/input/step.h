#pragma once

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/plan/input/slit_opening.h"
#include "sim/cut/surface/broad_phase.h"
#include "sim/cut/surface/edge_length_field.h"
#include "sim/cut/surface/stroke_surface.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The value of Attempt::closing that closes older slits, share of h.
inline constexpr double kCloseDistance = 1.0;
/// The value of Attempt::closing that only removes rounding noise, share of h.
inline constexpr double kCloseNoise = 1e-4;

/// One level of the retry ladder. Lengths are shares of h.
struct Attempt {
    int level = 0;              ///< place in the ladder, 0 for the first try
    bool staysInPlane = false;  ///< the blade's offset is ahead, not sideways
    double offsetScale = 1;     ///< length of the blade's offset, in units of the setting
    /// Predicates see copies within this distance of their mean there (commonPosition).
    double closing = kCloseNoise;
    /// Predicates see vertices of the old rung and around the front's ends that slipped over the
    /// skin at their place on the surface before the stroke (StrokeSurface).
    bool onSurface = false;
    double tolerance = 0;  ///< nodes closer than this are one
};

/// The part of the blade that advances, by the parameters of its ends.
struct BladeSpan {
    double from = 0;         ///< parameter of the first end
    double to = 1;           ///< parameter of the last end
    bool holdsFrom = false;  ///< the first end stays on the old rung: beyond it the front stays
    bool holdsTo = false;    ///< the last end stays on the old rung: beyond it the front stays
};

/// All that one try of a step reads; nothing here changes during the try.
struct StepInput {
    const SurfaceMesh& mesh;                ///< the body
    const BroadPhase& broadPhase;           ///< finds the triangles near the strip
    const std::vector<int>& pieceOfVertex;  ///< piece of the body by vertex
    const StrokeSurface& surface;           ///< the surface before the stroke
    const SlitOpening& opening;             ///< older slits that the predicates see open
    const std::vector<RungNode>& rung;      ///< positions up to date, s along `blade`
    Blade blade;                            ///< the blade to which the step goes
    BladeSpan span;                         ///< the part of the blade that advances
    double h = 0;                           ///< edge length about the rung [m]
    double offset = 0;                      ///< length of the blade's offset at scale 1, share of h
    const EdgeLengthField& edgeLengths;     ///< edge lengths by rest position
    WallGrading grading{};                  ///< how they grow inside new walls
    std::uint64_t seed = 0;                 ///< decides the blade's offset
    int stroke = 0;                         ///< number of the stroke, as in wall labels
    int transit = 0;               ///< number of the blade's way from air to air, over all strokes
    int firstVertexOfTransit = 0;  ///< vertices from here on were made in the transit
    Attempt attempt;               ///< the level of the retry ladder
    Bounds body{};                 ///< all outside this box is air; empty if unknown
    bool atRest = false;           ///< every vertex lies still where it rests
    /// The sides of the blade's plane on which vertices in it are seen; zero for those that stay.
    /// Found when the strip first comes near, and kept for the transit (seeFlushAside).
    std::map<int, Vec3>& flushSides;
};

}  // namespace kerf::cut
