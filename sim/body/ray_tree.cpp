#include "sim/body/ray_tree.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "sim/base/boxes.h"
#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

constexpr double kLeastCosine = 1e-6;  // rays closer to a triangle's plane miss it

}  // namespace

RayTree::RayTree(const SurfaceMesh& mesh, std::span<const int> triangles)
    : mesh_(mesh), tree_(triangles, [this](int t) { return boundsOf(t); }) {}

void RayTree::update(std::span<const int> triangles) {
    tree_.erase(triangles);
    std::vector<int> alive;
    std::ranges::copy_if(triangles, std::back_inserter(alive),
                         [this](int t) { return mesh_.alive(t); });
    tree_.insert(alive, [this](int t) { return boundsOf(t); });
}

Bounds RayTree::boundsOf(int triangle) const {
    const Bounds box = boxOf(restCornersOf(mesh_, triangle));
    return widened(box, 4 * kHitBorder * box.diagonal());
}

RayHit RayTree::intersect(const BoxRay& ray, int triangle) const {
    const std::optional<LineHit> hit =
        hitOf(restCornersOf(mesh_, triangle), ray.origin, ray.direction, kLeastCosine);
    return hit ? RayHit{triangle, hit->distance, hit->b1, hit->b2} : RayHit{};
}

bool RayTree::facesAway(int triangle, const Vec3& direction) const {
    return areaNormal(restCornersOf(mesh_, triangle)).dot(direction) > 0;
}

bool RayTree::crosses(const Vec3& from, const Vec3& to) const {
    const BoxRay ray(from, to - from);
    double farthest = 1;
    bool crossed = false;
    traverse(ray, farthest, [&](int slot) {
        const RayHit hit = intersect(ray, slot);
        if (hit.triangle >= 0 && hit.distance > 0 && hit.distance < 1) {
            crossed = true;
            farthest = -1;
        }
    });
    return crossed;
}

}  // namespace kerf
