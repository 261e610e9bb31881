#pragma once

namespace kerf::app {

/// How near a pointer must come to take hold of a handle [px].
inline constexpr double kHandleReach = 14;
/// Previews look at all of the body up to so many triangles; with more they would slow the pictures
/// down.
inline constexpr int kMostPreviewTriangles = 50'000;

}  // namespace kerf::app
