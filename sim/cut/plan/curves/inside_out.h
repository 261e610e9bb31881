#pragma once

#include "sim/cut/plan/curves/cut_curves.h"
#include "sim/cut/plan/input/step.h"
#include "sim/cut/plan/strip/strip.h"

namespace kerf::cut {

/// The link from one point of the strip's border to the next.
enum class Link {
    stripEdge,  ///< a piece of a strip edge
    none,       ///< nothing: both points are one strip node, seen from two sides of a gap
    zeroFront   ///< a front edge of length zero inside a cluster
};

/// A point on the border of the strip.
struct BorderPoint {
    int node = -1;       ///< node of the curves, -1 where there is none yet
    int vertex = -1;     ///< mesh vertex that it stands for, -1 for none
    int stripNode = -1;  ///< -1: between two strip nodes
    int event = 0;       ///< +1: the body is entered here, -1: left
    Link link = Link::stripEdge;
    int edge = -1;        ///< strip edge that follows, for Link::stripEdge
    double u = 0;         ///< parameter along that edge
    bool inside = false;  ///< of the piece that follows (tellInsideOut)

    /// Whether a front edge follows.
    bool isOnFront(const Strip& strip) const {
        return link == Link::zeroFront ||
               (link == Link::stripEdge && strip.edges[edge].frontOf >= 0);
    }
    /// Its parameter along the blade.
    double parameter(const Strip& strip) const;
};

/// The pieces of the body that the curves or the front in a strip belong to.
std::set<int> piecesInStrip(const StepInput& in, const Strip& strip, const CutCurves& curves);

/// The points of the border of a strip in order, for one piece of the body: its nodes, and the ends
/// of the piece's curves (`segments`) between them. Throws StepFailure.
std::vector<BorderPoint> borderPoints(const StepInput& in, const Strip& strip, int piece,
                                      const CutCurves& curves,
                                      const std::vector<Segment>& segments);

/// Finds which parts of a strip's border are inside the body, from the ends of curves on it
/// (BorderPoint::inside). Two such ends in an impossible order are swapped if close together.
/// Throws StepFailure where inside and outside contradict each other.
std::vector<BorderPoint> tellInsideOut(const StepInput& in, const Strip& strip,
                                       std::vector<BorderPoint> points);

}  // namespace kerf::cut
