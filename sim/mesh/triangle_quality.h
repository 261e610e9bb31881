#pragma once

#include "sim/mesh/triangle.h"
#include "sim/mesh/triangle_soup.h"

namespace kerf {

/// Whether a triangle with an area is a needle or a flap: lower than a tenth of its longest edge.
bool isNeedle(const Corners& corners);

/// The smallest angle of a triangle [degrees]: 60 at best, 0 without an area.
double smallestAngle(const Corners& corners);

/// Heights of a triangle over its longest edge: below the first it is a sliver, below the second a
/// degenerate one.
inline constexpr double kSliver = 0.02;
inline constexpr double kBareSliver = 0.001;

/// How well triangles are shaped.
struct ShapeFigures {
    int triangles = 0;
    double worstAngle = 60;  ///< the smallest of all [degrees]
    double angleSum = 0;     ///< of the smallest angle of each [degrees]
    int slivers = 0;         ///< see kSliver
    int bareSlivers = 0;     ///< of these: see kBareSliver

    void add(const Corners& corners);
    void add(const ShapeFigures& others);
    /// The mean of the smallest angle of each [degrees], 0 where there is none.
    double meanAngle() const { return triangles > 0 ? angleSum / triangles : 0; }
};

/// The suitability of triangles for a soft body: even ones of one size are best.
struct TriangleFigures {
    int triangles = 0;
    int needles = 0;          ///< see isNeedle()
    double area = 0;          ///< [m^2]
    double shortestEdge = 0;  ///< [m]
    double longestEdge = 0;   ///< [m]
    double edgeSum = 0;       ///< over all corners, so that each edge between two counts twice [m]
    double evenEdgeSum = 0;   ///< of the edges of even triangles with the same areas, one each [m]

    void add(const Corners& corners);
    /// The mean edge [m], 0 where there is none.
    double meanEdge() const { return triangles > 0 ? edgeSum / (3.0 * triangles) : 0; }
};

/// Figures of all triangles of a soup, whose indices must be in range.
TriangleFigures figuresOf(const TriangleSoup& soup);

/// The edge length for even triangles [m]: the mean for even triangles of the same areas, since
/// needles have long edges for their area; or longer if that made more than four times as many
/// triangles, as with tiny ones beside giant ones.
double evenEdge(const TriangleFigures& figures);
/// Whether a body with such a skin hardly bends and is cut into shards: its longest edge is more
/// than an eighth of its diagonal [m].
bool isCoarse(const TriangleFigures& figures, double diagonal);
/// The edge length to propose for a body [m]: evenEdge(), of a coarse one a 25th of its diagonal at
/// most.
double proposedEdge(const TriangleFigures& figures, double diagonal);
/// About how many triangles the surface has with this edge length [m].
double trianglesOf(const TriangleFigures& figures, double edge);
/// The edge length with which the surface has about so many triangles [m].
double edgeOf(const TriangleFigures& figures, double triangles);

/// The principal strain of a triangle of larger magnitude: the change of a length over that length
/// at rest; 0 at rest, and without rest area. The editor colours bodies by it.
double largestStrain(const Corners& rest, const Corners& now);

}  // namespace kerf
