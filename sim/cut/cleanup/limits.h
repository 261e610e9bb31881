#pragma once

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

}  // namespace kerf::cut
