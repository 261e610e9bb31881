#pragma once

#include <vector>

#include "sim/cut/plan/intersections.h"
#include "sim/cut/plan/rest_guess.h"

namespace kerf::cut {

/// What lies across a border edge of the new wall.
enum class OutlineKind {
    cut,    ///< a curve segment: surface on both sides opens here
    free,   ///< inside the body: the new front, the path of the tip, the start of a stroke
    front,  ///< an edge of the old front, where the slit grows on
};

/// A directed border edge of the new wall, wall on its left in the layout plane.
struct OutlineEdge {
    int from;
    int to;
    OutlineKind kind;
    int piece;  ///< of the body
};

/// A node of the new rung, in the order from B to A.
struct FrontPoint {
    double s;
    int node;
    bool attached;  ///< the edge to the next point lies inside the body
};

/// The border of that part of the strip that lies inside the body.
struct Outline {
    std::vector<OutlineEdge> edges;
    std::vector<FrontPoint> front;
    bool endAInside = false;  ///< the blade's end A, at which the front then starts
    bool endBInside = false;
};

/// Walks the border of the strip, tells inside from outside, and collects the border of the wall;
/// for each piece of the body apart, so that pieces may touch or overlap. Adds nodes (free samples,
/// front vertices) to `curves`. Empty where the blade swept only air. Throws StepFailure where
/// inside and outside contradict each other.
Outline traceOutline(const StepInput& in, const Strip& strip, const RestGuess& guess,
                     CutCurves& curves);

}  // namespace kerf::cut
