#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "render/camera.h"
#include "sim/cut/blade.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// Where a blade would meet the surface of a mesh on its way.
struct CutPreview {
    std::vector<std::array<Vec3, 2>> wound;  ///< lines on the surface [m]
    std::vector<int> touched;                ///< triangles, ascending
};
/// The way goes from pose to pose in straight lines. O(triangles * poses), of boxes that meet.
CutPreview previewCut(const SurfaceMesh& mesh, std::span<const Blade> way);

/// A point of the surface.
struct SurfacePoint {
    int triangle = -1;
    Vec3 position = Vec3::Zero();
    Vec3 normal = Vec3::UnitY();  ///< outwards, smooth over the same kind of surface
};
/// The first one that a ray meets from outside. O(triangles).
std::optional<SurfacePoint> pickSurface(const SurfaceMesh& mesh, const render::Ray& ray);

}  // namespace kerf::app
