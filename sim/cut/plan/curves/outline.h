#pragma once

#include <Eigen/Core>

#include "sim/cut/plan/curves/cut_curves.h"
#include "sim/cut/plan/input/step.h"
#include "sim/cut/plan/strip/strip.h"

namespace kerf::cut {

/// A rough estimate of the rest positions of places of the strip inside the body, for looking up
/// edge lengths: the best affine fit to the curves and the old front. New wall vertices get their
/// rest positions by mapFromSkin.
class RestGuess {
  public:
    /// Fits the map.
    RestGuess(const StepInput& in, const Strip& strip, const CutCurves& curves);
    /// The estimated rest position of a place [m].
    Vec3 at(const Vec3& position) const {
        return position + offset_ + change_ * (position - center_);
    }

  private:
    // Zero where the body lies at rest, or has one edge length everywhere.
    Vec3 center_ = Vec3::Zero();
    Vec3 offset_ = Vec3::Zero();
    Eigen::Matrix3d change_ = Eigen::Matrix3d::Zero();
};

/// The kind of a border edge of the new wall: what lies across it.
enum class OutlineKind {
    cut,    ///< a curve segment: surface on both sides opens here
    free,   ///< inside the body: the new front, the path of the tip, the start of a stroke
    front,  ///< an edge of the old front, where the slit continues
};

/// A directed border edge of the new wall, wall on its left in the layout plane.
struct OutlineEdge {
    int from;          ///< node of CutCurves
    int to;            ///< node of CutCurves
    OutlineKind kind;  ///< kind of what lies across
    int piece;         ///< piece of the body in which the wall lies
};

/// A node of the new rung, in the order from B to A.
struct FrontPoint {
    double s;       ///< parameter along the blade
    int node;       ///< node of CutCurves
    bool attached;  ///< the edge to the next point lies inside the body
};

/// The border of that part of the strip that lies inside the body.
struct Outline {
    std::vector<CutNode> nodes;      ///< added to those of the curves, and numbered after them
    std::vector<OutlineEdge> edges;  ///< all border edges; empty where the blade met only air
    std::vector<FrontPoint> front;   ///< the new rung inside the body, from B to A
    bool endAInside = false;         ///< the blade's end A lies inside: the front starts there
    bool endBInside = false;         ///< the blade's end B lies inside: the front ends there
};

/// Walks the border of the strip, distinguishes inside from outside, and collects the border of the
/// wall; for each piece separately, so that pieces may touch or overlap. Its own nodes are free
/// samples and front vertices. Empty if the blade swept only air. Throws StepFailure if inside and
/// outside contradict each other.
Outline traceOutline(const StepInput& in, const Strip& strip, const RestGuess& guess,
                     const CutCurves& curves);

}  // namespace kerf::cut
