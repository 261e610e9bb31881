#pragma once

#include <array>
#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Where a ray leaves the body: p = (1 - b1 - b2) t0 + b1 t1 + b2 t2.
struct RayHit {
    int triangle = -1;  ///< mesh slot, -1 for none
    double distance = 0;
    double b1 = 0;
    double b2 = 0;
};

/// A bounding-volume tree over triangles of the rest shape, for rays: binned surface-area
/// heuristic, iterative build and traversal. Answers do not depend on the shape of the tree.
///
/// A triangle reaches 2e-5 of its edges beyond its border, so that a ray aimed at an edge or a
/// corner (the rule on symmetric meshes) hits something.
class RayTree {
  public:
    /// `triangles`: living mesh slots. The mesh must outlive the tree and keep its rest shape.
    RayTree(const SurfaceMesh& mesh, std::vector<int> triangles);

    /// The first back face along `direction` (unit) at `minDistance` or farther of which
    /// accept(slot) holds; of equal distances the lowest slot.
    template <class Accept>
    RayHit castToBackFace(const Vec3& origin, const Vec3& direction, double minDistance,
                          Accept&& accept) const;

    /// Whether the open segment crosses a triangle, from either side.
    bool crosses(const Vec3& from, const Vec3& to) const;

  private:
    struct Node {
        Bounds bounds;
        int first = 0;  ///< of its triangles, or the left child (the right one follows it)
        int count = 0;  ///< triangles; 0 for an inner node
    };
    struct Ray {
        Ray(const Vec3& from, const Vec3& along);
        Vec3 origin;
        Vec3 direction;
        Vec3 inverse;
    };
    /// Deeper nodes are halved by count, which bounds the depth and with it the stack.
    static constexpr int kSahDepth = 64;
    static constexpr int kStackSize = kSahDepth + 34;

    struct Builder;

    static double entry(const Bounds& box, const Ray& ray, double farthest);
    /// Intersection with the plane of a triangle, within its widened border; triangle -1 if none.
    RayHit intersect(const Ray& ray, int triangle) const;
    bool facesAway(int triangle, const Vec3& direction) const;
    /// Calls visit(slot) for triangles of boxes that the ray enters before `farthest`, which visit
    /// may shrink.
    template <class Visit>
    void traverse(const Ray& ray, const double& farthest, Visit&& visit) const;

    const SurfaceMesh& mesh_;
    std::vector<int> triangles_;
    std::vector<Node> nodes_;
};

template <class Visit>
void RayTree::traverse(const Ray& ray, const double& farthest, Visit&& visit) const {
    std::array<int, kStackSize> stack;
    int size = 0;
    if (!nodes_.empty()) {
        stack[size++] = 0;
    }
    while (size > 0) {
        const Node& node = nodes_[stack[--size]];
        if (entry(node.bounds, ray, farthest) > farthest) {
            continue;
        }
        for (int i = 0; i < node.count; ++i) {
            visit(triangles_[node.first + i]);
        }
        if (node.count > 0) {
            continue;
        }
        const bool leftFirst = entry(nodes_[node.first].bounds, ray, farthest) <=
                               entry(nodes_[node.first + 1].bounds, ray, farthest);
        stack[size++] = node.first + (leftFirst ? 1 : 0);
        stack[size++] = node.first + (leftFirst ? 0 : 1);
    }
}

template <class Accept>
RayHit RayTree::castToBackFace(const Vec3& origin, const Vec3& direction, double minDistance,
                               Accept&& accept) const {
    const Ray ray(origin, direction);
    RayHit best;
    best.distance = 1e300;
    traverse(ray, best.distance, [&](int slot) {
        if (!facesAway(slot, direction) || !accept(slot)) {
            return;
        }
        const RayHit hit = intersect(ray, slot);
        const bool nearer =
            hit.distance < best.distance || (hit.distance == best.distance && slot < best.triangle);
        if (hit.triangle >= 0 && hit.distance >= minDistance && nearer) {
            best = hit;
        }
    });
    return best;
}

}  // namespace kerf
