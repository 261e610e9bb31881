#include "sim/mesh/triangle_tree.h"

#include <iterator>
#include <utility>

namespace kerf {

namespace {

constexpr double kRoom = 1 + 1e-9;  // for rounding

}  // namespace

TriangleTree::TriangleTree(const SurfaceMesh& mesh) : mesh_(mesh) {
    tree_ = LazyBoxTree(
        livingTriangles(mesh), [this](int t) { return boundsOf(t); },
        LazyBoxTree::Joining::divided);
}

Bounds TriangleTree::boundsOf(int triangle) const {
    const Triangle& corners = mesh_.triangle(triangle);
    const Vec3& p = mesh_.position(corners[0]);
    const Vec3& q = mesh_.position(corners[1]);
    const Vec3& r = mesh_.position(corners[2]);
    return {p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)};
}

std::vector<int> TriangleTree::near(const OrientedBox& box) {
    // Tells most boxes apart at less cost.
    const Vec3 half = box.axes.cwiseAbs() * box.half;
    const Bounds around{box.center - kRoom * half, box.center + kRoom * half};
    return find(
        [&](const Bounds& bounds) { return bounds.overlaps(around) && mayMeet(box, bounds); });
}

void TriangleTree::catchUp() {
    if (std::exchange(lost_, false)) {
        tree_.refit([this](int t) { return boundsOf(t); });
    }
}

void TriangleTree::update(std::span<const int> triangles) {
    tree_.erase(triangles);
    std::vector<int> living;
    std::ranges::copy_if(triangles, std::back_inserter(living),
                         [this](int t) { return mesh_.alive(t); });
    tree_.insert(living, [this](int t) { return boundsOf(t); });
}

}  // namespace kerf
