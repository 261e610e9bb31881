#include "app/scene/section_pick.h"

#include "sim/mesh/triangle.h"
#include "sim/run/simulation.h"

namespace kerf::app {
namespace {

/// 1 where the ray leaves the body through the triangle, -1 where it enters, 0 where it misses.
int crossing(const Corners& c, const render::Ray& ray) {
    const Vec3 normal = areaNormal(c);
    const double along = normal.dot(ray.direction);
    const double distance = normal.dot(c[0] - ray.origin) / along;
    if (along == 0 || !(distance > 0)) {
        return 0;
    }
    const Vec3 at = ray.origin + distance * ray.direction;
    for (int e = 0; e < 3; ++e) {
        if (areaNormal(c[e], c[(e + 1) % 3], at).dot(normal) < 0) {
            return 0;
        }
    }
    return along > 0 ? 1 : -1;
}

bool startsInside(Simulation& simulation, const render::Ray& ray) {
    int left = 0;
    for (const int t : simulation.trianglesIn(boxAbout(ray, simulation.bounds()))) {
        if (simulation.meshAsRead().present(t)) {
            left += crossing(cornersOf(simulation.meshAsRead(), t), ray);
        }
    }
    return left != 0;
}

}  // namespace

std::optional<SurfacePoint> pickVisible(EditorScene& scene, const render::Ray& ray,
                                        const std::optional<render::SectionPlane>& section) {
    const double before = section ? section->distance(ray.origin) : -1;
    if (before <= 0) {
        const auto point = scene.pick(ray);
        return section && point && section->distance(point->position) > 0 ? std::nullopt : point;
    }
    const double along = section->normal.dot(ray.direction);
    if (along >= 0) {
        return std::nullopt;
    }
    const render::Ray behind{ray.origin - before / along * ray.direction, ray.direction};
    return startsInside(scene.simulation(), behind) ? std::nullopt : scene.pick(behind);
}

}  // namespace kerf::app
