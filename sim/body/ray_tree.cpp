#include "sim/body/ray_tree.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

constexpr double kBorder = 2e-5;       // tolerance on barycentric coordinates
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
    Bounds box;
    for (const int v : mesh_.triangle(triangle)) {
        box.add(mesh_.restPosition(v));
    }
    box.widen(4 * kBorder * box.diagonal());
    return box;
}

RayHit RayTree::intersect(const BoxRay& ray, int triangle) const {
    // Moeller and Trumbore 1997.
    const Triangle& t = mesh_.triangle(triangle);
    const Vec3& a = mesh_.restPosition(t[0]);
    const Vec3 e1 = mesh_.restPosition(t[1]) - a;
    const Vec3 e2 = mesh_.restPosition(t[2]) - a;
    const Vec3 p = ray.direction.cross(e2);
    const double determinant = e1.dot(p);
    const double scale = e1.cross(e2).norm() * ray.direction.norm();
    if (std::abs(determinant) <= kLeastCosine * scale) {
        return {};
    }
    const Vec3 s = ray.origin - a;
    const Vec3 q = s.cross(e1);
    const double b1 = s.dot(p) / determinant;
    const double b2 = ray.direction.dot(q) / determinant;
    if (b1 < -kBorder || b2 < -kBorder || b1 + b2 > 1 + kBorder) {
        return {};
    }
    return {triangle, e2.dot(q) / determinant, b1, b2};
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
