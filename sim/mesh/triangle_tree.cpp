#include "sim/mesh/triangle_tree.h"

#include <utility>

namespace kerf {

TriangleTree::TriangleTree(const SurfaceMesh& mesh) : mesh_(mesh) {
    tree_ = BoxTree(livingTriangles(mesh), [this](int t) { return boundsOf(t); });
}

Bounds TriangleTree::boundsOf(int triangle) const {
    Bounds bounds;
    for (const int v : mesh_.triangle(triangle)) {
        bounds.add(mesh_.position(v));
    }
    return bounds;
}

void TriangleTree::catchUp() {
    if (std::exchange(lost_, false)) {
        tree_.refit([this](int t) { return boundsOf(t); });
    }
}

void TriangleTree::update(std::span<const int> triangles) {
    for (const int t : triangles) {
        tree_.erase(t);
    }
    for (const int t : triangles) {
        if (mesh_.alive(t)) {
            tree_.insert(t, [this](int id) { return boundsOf(id); });
        }
    }
}

}  // namespace kerf
