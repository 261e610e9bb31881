#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "render/scene/camera.h"
#include "sim/cut/blade.h"
#include "sim/mesh/oriented_box.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// The places where a blade would meet the surface of a mesh on its way.
struct CutPreview {
    std::vector<std::array<Vec3, 2>> wound;  ///< lines on the surface [m]
    std::vector<int> touched;                ///< triangles, ascending
};
/// The way goes from pose to pose in straight lines. `triangles`: those to look at, alive and
/// ascending. O(triangles * poses), of boxes that meet.
CutPreview previewCut(const SurfaceMesh& mesh, std::span<const int> triangles,
                      std::span<const Blade> way);
/// The box about all that it looks into; of at least one pose.
OrientedBox boxAbout(std::span<const Blade> way);

/// A point of the surface.
struct SurfacePoint {
    int triangle = -1;
    Vec3 position = Vec3::Zero();
    Vec3 normal = Vec3::UnitY();  ///< outwards, smooth over the same kind of surface
};
/// The first one of `triangles`, alive and ascending, that a ray meets from outside. O(triangles).
std::optional<SurfacePoint> pickSurface(const SurfaceMesh& mesh, std::span<const int> triangles,
                                        const render::Ray& ray);
/// A hair about the ray, as far as it can meet what lies in `bounds`.
OrientedBox boxAbout(const render::Ray& ray, const Bounds& bounds);

}  // namespace kerf::app
