#pragma once

#include "sim/base/containers.h"
#include "sim/mesh/box_tree.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// A finder with a tree of boxes that follows the body while it deforms and is cut.
class TriangleTree : public TriangleFinder {
  public:
    /// The mesh must outlive the tree. O(n); searches refine the tree.
    explicit TriangleTree(const SurfaceMesh& mesh);

    /// No vertex has moved farther than `distance` [m] since the last call of either.
    void moved(double distance) { tree_.moved(distance); }
    /// Vertices may have moved arbitrarily: the next search costs O(n).
    void movedAnyhow() { lost_ = true; }
    void update(std::span<const int> triangles) override;
    std::vector<int> near(const OrientedBox& box) override;

    /// Triangles that may be in boxes for which meets(box) is true; none of these is missing.
    /// Ascending.
    template <class Meets>
    std::vector<int> find(Meets&& meets) {
        catchUp();
        std::vector<int> found;
        found.reserve(foundLast_);
        tree_.find([this](int t) { return boundsOf(t); }, meets,
                   [&](int t) { found.push_back(t); });
        foundLast_ = found.size();
        sortUnique(found);
        return found;
    }

    Bounds bounds() override {
        catchUp();
        return tree_.bounds();
    }

  private:
    Bounds boundsOf(int triangle) const {
        const Triangle& corners = mesh_.triangle(triangle);
        const Vec3& p = mesh_.position(corners[0]);
        const Vec3& q = mesh_.position(corners[1]);
        const Vec3& r = mesh_.position(corners[2]);
        return {p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)};
    }
    void catchUp();

    const SurfaceMesh& mesh_;
    BoxTree tree_;
    bool lost_ = false;
    std::size_t foundLast_ = 0;  ///< as many may be found again
};

}  // namespace kerf
