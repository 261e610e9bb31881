#pragma once

#include "render/scene/camera.h"
#include "sim/cut/blade.h"
#include "sim/mesh/oriented_box.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// The intersection of a blade's path with the surface of a mesh.
struct CutPreview {
    std::vector<std::array<Vec3, 2>> wound;  ///< lines on the surface [m]
    std::vector<int> touched;                ///< triangles, ascending
};
/// The path is linear from pose to pose. `triangles`: those to test, alive and ascending.
/// O(triangles * poses), of overlapping boxes.
CutPreview previewCut(const SurfaceMesh& mesh, std::span<const int> triangles,
                      std::span<const Blade> way);
/// The box that it searches; of at least one pose.
OrientedBox boxAbout(std::span<const Blade> way);

/// A point of the surface.
struct SurfacePoint {
    int triangle = -1;
    Vec3 position = Vec3::Zero();
    Vec3 normal = Vec3::UnitY();  ///< outwards, smooth over the same kind of surface
};
/// The first hit of a ray from outside among `triangles`, alive and ascending. O(triangles).
std::optional<SurfacePoint> pickSurface(const SurfaceMesh& mesh, std::span<const int> triangles,
                                        const render::Ray& ray);
/// Reads a triangle and those around its corners back, if stale.
void bringAround(const SurfaceMesh& mesh, int triangle);
/// A thin box around the ray, as far as it can hit something in `bounds`.
OrientedBox boxAbout(const render::Ray& ray, const Bounds& bounds);

}  // namespace kerf::app
