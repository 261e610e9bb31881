#pragma once

#include <array>

namespace kerf {

/// How a triangle was divided: the four patterns of the paper (its Figure 4), and others.
enum class SubdivisionPattern {
    oneToFour,    ///< the cut ends inside: one edge node, one inner node, four triangles
    oneToThreeA,  ///< two edge nodes, three triangles
    oneToTwo,     ///< from a vertex to the opposite edge, two triangles
    oneToThreeB,  ///< from a vertex to an inner node, three triangles
    twoKinks,     ///< the curve starts and ends inside the triangle
    twoSegments,  ///< two segments of curves
    more          ///< any other way
};
/// The number of enumerators of SubdivisionPattern.
inline constexpr int kSubdivisionPatterns = 7;
/// How many of them, the first ones, are the paper's.
inline constexpr int kPaperPatterns = 4;

/// The number of divided triangles, by SubdivisionPattern.
using SubdivisionCounts = std::array<int, kSubdivisionPatterns>;

/// The name of a pattern: "1-to-4", "1-to-3a", "1-to-2", "1-to-3b" as in the paper; "two kinks",
/// "two segments", "more".
const char* nameOf(SubdivisionPattern pattern);

/// Adds `part` to `sum`, pattern by pattern.
void addTo(SubdivisionCounts& sum, const SubdivisionCounts& part);
/// The number of triangles with a pattern other than the paper's four.
int otherPatterns(const SubdivisionCounts& counts);

}  // namespace kerf
