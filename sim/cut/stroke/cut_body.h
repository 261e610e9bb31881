#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/stroke/triangle_lookup.h"
#include "sim/cut/surface/edge_length_field.h"
#include "sim/cut/surface/piece_groups.h"
#include "sim/cut/surface/stroke_surface.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The largest distance from the strip at which a triangle can matter, as a share of the edge
/// length about the rung: predicates see vertices elsewhere, and the rung is led around skin that
/// moved across it.
inline constexpr double kBroadPhaseMargin = 3;

/// The reason for which the blade waits.
enum class Gate {
    shareOfEdge,  ///< it has moved less than CutSettings::gate
    flush,        ///< it has hardly moved
};

/// One change of the mesh, of which a step may make several.
struct MeshChange {
    /// The slots that were added or removed, or of which a corner changed; each once.
    std::span<const int> triangles;
    int groupOfNewPieces = -1;             ///< the group of pieces that are all new
    std::span<const int> movedVertices{};  ///< old ones that were moved, or got another velocity
    double restMotion = 0;                 ///< how far a vertex was moved at rest at most [m]
};

/// A body as the strokes of a blade see it: its mesh, how finely that is cut, and what is looked up
/// in it.
struct CutBody {
    /// The mesh must outlive the object and its copies. O(n).
    CutBody(SurfaceMesh& ofBody, const CutSettings& howFinely);

    /// Lets everything that is looked up in the mesh follow a change of it. After each change,
    /// before anything is looked up.
    void follow(const MeshChange& change);
    /// Takes note of what the solver moved since the last call.
    void noteMotion();
    /// Takes the body as it is when a stroke begins. O(n).
    void beginStroke();
    /// The part of a blade that may reach the body.
    Blade nearBody(const Blade& whole);

    /// The mean edge length h [m].
    double h() const { return edgeLengths->mean(); }
    /// The edge length about the nodes of a rung [m].
    double edgeLengthAbout(const std::vector<RungNode>& nodes) const;
    /// The way below which a group waits, for an edge length about its rung [m].
    double gateLength(Gate gate, double edge) const;
    /// The distance from the strip within which a step looks, for an edge length there [m].
    double margin(double edge) const;

    SurfaceMesh& mesh;
    CutSettings settings;
    std::shared_ptr<const EdgeLengthField> edgeLengths;  ///< by rest position
    TriangleLookup triangles{mesh};
    GroupedPieces pieces{mesh};
    StrokeSurface surface{mesh};  ///< the surface before the stroke
    bool atRest = false;          ///< all of the body is known to lie still where it rests
    SearchWork searchWork{};      ///< what searches took since that was last taken

  private:
    bool liesAtRest(int v) const;
};

}  // namespace kerf::cut
