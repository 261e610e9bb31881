#pragma once

#include "sim/mesh/triangle.h"
#include "sim/mesh/triangle_soup.h"

namespace kerf::repair {

/// One side of one triangle: half-edge 3 * triangle + corner runs from that corner to the next.
struct Side {
    int low = 0;
    int high = 0;
    int halfEdge = 0;
    bool upward = false;  ///< runs from low to high

    int triangle() const { return halfEdge / 3; }
};

/// The sides of all triangles, those of one edge in a row.
std::vector<Side> sidesByEdge(const std::vector<Triangle>& triangles);

/// Calls f(begin, end) for the sides of each edge.
template <class F>
void forEachEdge(const std::vector<Side>& sides, F&& f) {
    for (std::size_t begin = 0; begin < sides.size();) {
        std::size_t end = begin + 1;
        while (end < sides.size() && sides[end].low == sides[begin].low &&
               sides[end].high == sides[begin].high) {
            ++end;
        }
        f(sides.data() + begin, sides.data() + end);
        begin = end;
    }
}

/// The sides of edges that have one alone.
std::vector<Side> openSides(const TriangleSoup& soup);

/// The opposite half-edge of each, -1 if the edge does not have two sides.
using Partners = std::vector<int>;
Partners partnersOf(const std::vector<Side>& sides, std::size_t triangles);
/// The vertex where a half-edge begins.
int originOf(const TriangleSoup& soup, int halfEdge);
/// The corner across from a half-edge in its triangle.
int apexOf(const TriangleSoup& soup, int halfEdge);

/// The corners of a triangle, which must all exist.
Corners cornersOf(const TriangleSoup& soup, int triangle);
/// The box of a triangle, whose corners must all exist.
Bounds boundsOf(const TriangleSoup& soup, int triangle);
/// Whether all corners of a triangle exist and are finite.
bool isUsable(const TriangleSoup& soup, const Triangle& t);
/// Whether two corners of a triangle are one vertex.
bool repeatsCorner(const Triangle& t);
/// The vertices of a triangle in ascending order, to identify duplicates.
Triangle sortedCorners(Triangle t);

/// Adds a triangle with these attributes.
void addTriangle(TriangleSoup& soup, const Triangle& corners, const TriangleAttributes& attributes);
/// Removes the triangles that `keeps` does not name, in their order. Returns how many.
int keepTriangles(TriangleSoup& soup, const std::function<bool(int t)>& keeps);

/// Removes vertices without triangles.
void dropUnusedVertices(TriangleSoup& soup);

/// Numbers of connected parts by triangle, in the order of their lowest ones; parts are connected
/// by common vertices.
std::vector<int> partsOf(const TriangleSoup& soup);

/// The signed volume of each part [m^3], about a corner of it.
std::vector<double> volumesOf(const TriangleSoup& soup, const std::vector<int>& parts);
/// The area of each part [m^2].
std::vector<double> areasOf(const TriangleSoup& soup, const std::vector<int>& parts);

}  // namespace kerf::repair
