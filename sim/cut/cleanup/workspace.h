#pragma once

#include "sim/cut/cleanup/one_ring.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/surface/edge_length_field.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

// Bounds of what the clean-up calls a sliver, and of how far it may go. Lengths are shares of the
// edge length there.

/// Height over longest edge from which a triangle is good.
inline constexpr double kGoodQuality = 0.05;
/// Shortest edge from which a triangle is good.
inline constexpr double kGoodEdge = 0.06;
/// Shortest edge from which a triangle is good where skin stays folded.
inline constexpr double kGoodEdgeOfFold = 0.3;
/// Longest edge that is collapsed.
inline constexpr double kLongestCollapse = 0.6;
/// How far surface and rim may move, summed over all operations at one place.
inline constexpr double kMostDeviation = 0.014;
/// How far a wall may move at rest where its other side does not.
inline constexpr double kMostUnfaced = 2e-4;
/// How far the surface may move where skin stays folded: less than the fold shows.
inline constexpr double kMostDeviationOfFold = 0.1;
/// Volume that one operation may change, as a share of the body.
inline constexpr double kVolumePerOperation = 3e-9;
/// Times as much for operations on walls only, whose two sides cancel.
inline constexpr double kWallsCancel = 10;
/// Volume that a whole stroke may change, summed by amount, as a share of the body.
inline constexpr double kVolumePerStroke = 3e-7;
/// Times as much current volume where the rest shape is judged: the body is crumpled there, and the
/// volume constraint compensates.
inline constexpr double kCrumpled = 100;
/// Copies closer than this coincide and move together: the slit is closed, except for solver noise.
inline constexpr double kCoincident = 1e-3;

/// The volume that an operation changes, by amount [m^3].
struct VolumeDefect {
    double current = 0;  ///< volume of the current shape
    double rest = 0;     ///< volume of the rest shape
};

/// The state of the clean-up of a stroke: the mesh, the rung, how far each place has moved, how
/// much volume may still change, and the changes.
class Workspace {
  public:
    /// Starts with nothing changed; both arguments must outlive the workspace.
    Workspace(SurfaceMesh& mesh, const EdgeLengthField& edgeLengths);

    SurfaceMesh& mesh;  ///< the mesh to clean

    /// Exchanges current and rest positions of the mesh, until the next call: then the rest shape
    /// is judged and keeps its volume. Limits are those of folds.
    void exchangeShapes();
    /// Whether current and rest positions are exchanged.
    bool judgesAtRest() const { return judgesAtRest_; }
    /// Whether one of these copies is a vertex of the uncut skin away from all cuts, which must
    /// stay.
    bool isKept(const std::vector<int>& copies) const;
    /// The edge length wanted about a triangle [m].
    double edgeLengthAt(int triangle) const;
    /// Makes the edge length about a triangle the unit of all lengths from now on.
    void workAt(int triangle) { edgeLength_ = edgeLengthAt(triangle); }
    /// The unit of all lengths of an operation [m].
    double edgeLength() const { return edgeLength_; }
    /// The distance that surface and rim may move, all operations at one place together [m].
    double mostDeviation() const {
        return (judgesAtRest_ ? kMostDeviationOfFold : kMostDeviation) * edgeLength_;
    }
    /// The shortest edge of a good triangle [m].
    double goodEdgeLength() const { return goodEdge() * edgeLength_; }
    /// The shortest edge of a good triangle there, whatever the unit is [m].
    double goodEdgeLengthAt(int triangle) const { return goodEdge() * edgeLengthAt(triangle); }

    /// Keeps the surroundings of `rung` from now on, instead of those kept before: where the body
    /// is cut next, and beside the blade in the air, nothing must move.
    void keepAround(const std::vector<RungNode>& rung);
    /// Whether a triangle has a copy of a vertex of the rung as corner, or the rung comes near it.
    bool trianglesTouchRung(const std::vector<int>& triangles) const;
    /// Whether a triangle of the rings touches the rung.
    bool touchesRung(const std::vector<OneRing>& rings) const;

    /// The distance that the surface at these vertices has moved in this stroke [m].
    double deviationAt(const std::vector<int>& copies) const;
    /// Records how far the surface at these vertices has moved in this stroke [m].
    void setDeviation(const std::vector<int>& copies, double deviation);

    /// The volume that one operation may change.
    VolumeDefect mostPerOperation() const;
    /// Whether an operation, and with it the stroke, may change this volume.
    bool allows(const VolumeDefect& defect, bool wallsOnly) const;
    /// Adds the volume that an operation has changed.
    void spend(const VolumeDefect& defect);
    /// The share of the body's volume and of its rest volume that the stroke's clean-up has
    /// changed, both together: an upper bound.
    double volumeSpent() const;

    // Changes go through these, so that they are remembered.
    /// Records that a triangle has changed.
    void noteChanged(int triangle) { changed_.push_back(triangle); }
    /// Moves the ring's vertex as planned; all its triangles count as changed.
    void moveVertex(const OneRing& ring);
    /// Removes a triangle from the mesh.
    void removeTriangle(int triangle);
    /// Removes a vertex without triangles from the mesh.
    void removeVertex(int vertex);
    /// The sum of all moves of vertices at rest since the last call [m].
    double takeRestMotion() { return std::exchange(restMotion_, 0.0); }
    /// The triangles changed since the last call; some may be dead by now.
    std::vector<int> takeChanged();

    /// Adds all changes since the last call to `delta`, which holds what a step did before.
    void moveChangesTo(CutDelta& delta);
    /// Allocates for vertices that a step has added.
    void followMesh();

  private:
    /// Whether geometry of a cut lies within the shortest good edge of v.
    bool isBesideCut(int v) const;
    VolumeDefect most(double share) const;
    /// The shortest edge of a good triangle, as a share of edgeLength().
    double goodEdge() const { return judgesAtRest_ ? kGoodEdgeOfFold : kGoodEdge; }

    const EdgeLengthField& edgeLengths_;
    double edgeLength_;
    bool judgesAtRest_ = false;
    double bodyVolume_;
    double restVolume_;
    VolumeDefect spent_;
    double restMotion_ = 0;
    std::vector<double> deviation_;  ///< motion of the surface by vertex [m]
    std::vector<Vec3> rung_;         ///< nodes from A to B
    std::vector<int> onRungIn_;      ///< round in which each vertex was on the rung
    int round_ = 0;
    std::vector<int> changed_;
    std::vector<int> allChanged_;
    std::vector<int> moved_;
    std::vector<int> removedTriangles_;
    std::vector<int> deadVertices_;
};

}  // namespace kerf::cut
