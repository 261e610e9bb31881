#pragma once

#include <utility>
#include <vector>

#include "sim/cut/cleanup/limits.h"
#include "sim/cut/cleanup/local_patch.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/surface/edge_length_field.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Volume change of the current and of the rest shape, by amount [m^3].
struct VolumeDefect {
    double current = 0;
    double rest = 0;
};

/// What the clean-up of a stroke carries from operation to operation: the mesh, where the rung
/// is, how far each place has moved, how much volume may still change, and what it changed.
class Workspace {
  public:
    /// Both must outlive it.
    Workspace(SurfaceMesh& mesh, const EdgeLengthField& edgeLengths);

    SurfaceMesh& mesh;

    /// Exchanges current and rest positions of the mesh, until the same again: what is judged, and
    /// must keep its volume, is the rest shape then. Limits are those of folds.
    void exchangeShapes();
    bool judgesAtRest() const { return judgesAtRest_; }
    /// Of edges about a triangle [m].
    double edgeLengthAt(int triangle) const;
    /// What edgeLength() is from now on: that about a triangle.
    void workAt(int triangle) { edgeLength_ = edgeLengthAt(triangle); }
    /// The unit of all lengths of an operation [m].
    double edgeLength() const { return edgeLength_; }
    /// How far surface and rim may move, all operations at one place together [m].
    double mostDeviation() const {
        return (judgesAtRest_ ? kMostDeviationOfFold : kMostDeviation) * edgeLength_;
    }
    /// The shortest edge of a good triangle [m].
    double goodEdgeLength() const { return goodEdge() * edgeLength_; }
    double goodEdgeLengthAt(int triangle) const { return goodEdge() * edgeLengthAt(triangle); }

    /// Keeps the surroundings of the rung as they are, and of nothing else: where the body is cut
    /// next, and what the blade's air meets, must not move.
    void keepAround(const std::vector<RungNode>& rung);
    /// A triangle has a copy of a vertex of the rung as corner, or the rung comes near them.
    bool trianglesTouchRung(const std::vector<int>& triangles) const;
    bool touchesRung(const std::vector<Patch>& patches) const;

    /// How far the surface at these vertices has moved in this stroke [m].
    double deviationAt(const std::vector<int>& copies) const;
    void setDeviation(const std::vector<int>& copies, double deviation);

    /// What one operation may change.
    VolumeDefect mostPerOperation() const;
    bool allows(const VolumeDefect& defect, bool wallsOnly) const;
    void spend(const VolumeDefect& defect);
    /// Share of the body's volume and of its rest volume that the stroke's clean-up has changed,
    /// both together, an upper bound.
    double volumeSpent() const;

    // Changes go through these, so that they are remembered.
    void noteChanged(int triangle) { changed_.push_back(triangle); }
    /// To where the patch plans it; all its triangles have changed then.
    void moveVertex(const Patch& patch);
    void removeTriangle(int triangle);
    void removeVertex(int vertex);
    /// How far a vertex was moved at rest since the last call, all moves together [m].
    double takeRestMotion() { return std::exchange(restMotion_, 0.0); }
    /// Triangles changed since the last call; some may be dead by now.
    std::vector<int> takeChanged();

    /// Adds all changes since the last call to `delta`, which holds what a step did before.
    void moveChangesTo(CutDelta& delta);
    /// Makes room for vertices that a step has added.
    void followMesh();

  private:
    VolumeDefect most(double share) const;
    /// As a share of edgeLength().
    double goodEdge() const { return judgesAtRest_ ? kGoodEdgeOfFold : kGoodEdge; }

    const EdgeLengthField& edgeLengths_;
    double edgeLength_;
    bool judgesAtRest_ = false;
    double bodyVolume_;
    double restVolume_;
    VolumeDefect spent_;
    double restMotion_ = 0;
    std::vector<double> deviation_;  ///< by vertex [m]
    std::vector<Vec3> rung_;         ///< from A to B
    std::vector<int> onRungIn_;      ///< by vertex: the round in which it was on the rung
    int round_ = 0;
    std::vector<int> changed_;
    std::vector<int> allChanged_;
    std::vector<int> moved_;
    std::vector<int> removedTriangles_;
    std::vector<int> deadVertices_;
};

}  // namespace kerf::cut
