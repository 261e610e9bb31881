#pragma once

#include "shaders/shared/constraints.h"
#include "sim/mesh/box_tree.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Where a ray leaves the body: p = (1 - b1 - b2) t0 + b1 t1 + b2 t2.
struct RayHit {
    int triangle = -1;  ///< mesh slot, -1 for none
    double distance = 0;
    double b1 = 0;
    double b2 = 0;
};

/// A bounding-volume tree over triangles of the rest shape, for rays, which refine it lazily.
/// Results do not depend on the shape of the tree, so an edited one gives those of a new one.
///
/// A triangle reaches 2e-5 of its edges beyond its border, so that a ray aimed at an edge or a
/// corner (the rule on symmetric meshes) hits something.
class RayTree {
  public:
    /// `triangles`: living mesh slots. The mesh must outlive the tree and keep its rest shape.
    RayTree(const SurfaceMesh& mesh, std::span<const int> triangles);

    /// Does in advance what the first update would do. O(n).
    void prepareToUpdate() { tree_.prepareToEdit(); }
    /// Follows a change of the mesh. `triangles`: the slots that were added or removed, or of which
    /// a corner or its rest position changed; each once.
    void update(std::span<const int> triangles);

    /// The first back face along `direction` (unit) at `minDistance` or farther of which
    /// accept(slot) holds; of equal distances the lowest slot.
    template <class Accept>
    RayHit castToBackFace(const Vec3& origin, const Vec3& direction, double minDistance,
                          Accept&& accept) const;

    /// Whether the open segment crosses a triangle, from either side.
    bool crosses(const Vec3& from, const Vec3& to) const;

  private:
    /// Intersection with the plane of a triangle, within its widened border; triangle -1 if none.
    RayHit intersect(const BoxRay& ray, int triangle) const;
    Bounds boundsOf(int triangle) const;
    bool facesAway(int triangle, const Vec3& direction) const;
    /// Calls visit(slot) for triangles of boxes that the ray enters before `farthest`, which visit
    /// may shrink.
    template <class Visit>
    void traverse(const BoxRay& ray, const double& farthest, Visit&& visit) const;

    const SurfaceMesh& mesh_;
    mutable BoxTree tree_;  ///< divided by rays: not for two threads at once
};

template <class Visit>
void RayTree::traverse(const BoxRay& ray, const double& farthest, Visit&& visit) const {
    struct Entered {
        int node;
        double entry;
    };
    std::array<Entered, BoxTree::kMostInSearch> stack;
    int size = 0;
    const auto enter = [&](int node) {
        return Entered{node, entryInto(tree_.node(node).bounds, ray, farthest)};
    };
    for (const int root : tree_.roots()) {
        stack[size++] = enter(root);
    }
    while (size > 0) {
        const auto [node, entry] = stack[--size];
        if (entry > farthest || tree_.node(node).count == 0) {
            continue;
        }
        const int left = tree_.childrenOf(node);
        if (left < 0) {
            tree_.forEach(tree_.node(node), visit);
            continue;
        }
        stack[size] = enter(left);
        stack[size + 1] = enter(left + 1);
        if (stack[size].entry <= stack[size + 1].entry) {
            std::swap(stack[size], stack[size + 1]);
        }
        size += 2;
    }
}

template <class Accept>
RayHit RayTree::castToBackFace(const Vec3& origin, const Vec3& direction, double minDistance,
                               Accept&& accept) const {
    const BoxRay ray(origin, direction);
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

/// An internal shape-preserving constraint and the mesh slot of the triangle that it ends on.
struct CastIspc {
    shared::IspcConstraint constraint{};
    int meshTriangle = -1;
};

/// The directions of the rays of ISPCs.
enum class IspcRays {
    alongNormal,  ///< one from each vertex, against its normal, as in the paper
    /// Three from each vertex, turned from the normal in directions that vary by vertex: so they
    /// resist shear, and are equally dense everywhere and in all directions.
    turned,
};

/// How many rays leave a vertex.
constexpr int raysPerVertex(IspcRays rays) {
    return rays == IspcRays::turned ? 3 : 1;
}

/// Casts the ISPCs of a vertex in the rest shape: from the vertex inwards to the first back face of
/// the same piece.
class IspcCaster {
  public:
    /// All must outlive the caster. `tree` holds the living triangles; `edgeLength`: mean rest edge
    /// length of the uncut body [m].
    IspcCaster(const SurfaceMesh& mesh, const RayTree& tree, const std::vector<int>& pieceOfVertex,
               double edgeLength, IspcRays rays);

    /// Nothing if the vertex is unused or on a slit front (see VertexNormal::flatness), or if the
    /// ray finds no opposite side. May end on an absent triangle, which can hold no ISPC. `ray`:
    /// its number, from 0; `vertexArea`: rest area of the vertex [m^2].
    std::optional<CastIspc> cast(int vertex, int ray, double vertexArea) const;

  private:
    Vec3 direction(int vertex, int ray, const Vec3& inwards) const;
    bool pointsInside(int vertex, const Vec3& direction) const;

    const SurfaceMesh& mesh_;
    const RayTree& tree_;
    const std::vector<int>& pieceOfVertex_;
    double edgeLength_;
    IspcRays rays_;
};

/// Rest position of the far end of an ISPC [m].
Vec3 restEnd(const SurfaceMesh& mesh, const shared::IspcConstraint& constraint);

}  // namespace kerf
