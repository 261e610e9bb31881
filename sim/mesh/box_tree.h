#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "sim/base/math.h"

namespace kerf {

/// A bounding-volume tree over numbered things with boxes: built by a binned surface-area
/// heuristic, edited by inserting and erasing. What it finds does not depend on its shape.
/// (Insertion: Goldsmith and Salmon 1987; balance: Galperin and Rivest 1993.) Things that move are
/// for LazyBoxTree.
class BoxTree {
  public:
    /// The box of a thing.
    using BoundsOf = std::function<Bounds(int id)>;

    /// As large as a cache line. Boxes may be larger than needed, never smaller.
    struct alignas(64) Node {
        Bounds bounds;
        int parent = -1;
        int child = -1;  ///< the left one, the right one follows it; -1 for a leaf
        int leaf = -1;   ///< where its ids lie; -1 for an inner node
        int count = 0;   ///< things below
    };

    BoxTree() = default;
    BoxTree(std::span<const int> ids, const BoundsOf& boundsOf);

    /// What the first edit does otherwise: notes where each id lies. O(n), and memory up to the
    /// largest id, which a small tree that nobody edits does without.
    void prepareToEdit();
    /// `id` must not be in the tree.
    void insert(int id, const BoundsOf& boundsOf);
    /// Does nothing where `id` is not in the tree.
    void erase(int id);

    /// Calls visit(id) for everything in leaves whose box meets(box); may find more than needed.
    template <class Meets, class Visit>
    void find(Meets&& meets, Visit&& visit) const;

    /// For other ways through the tree: node 0 is the root; empty where nothing was ever put in.
    const std::vector<Node>& nodes() const { return nodes_; }
    std::span<const int> idsOf(const Node& leaf) const {
        return {leaves_[leaf.leaf].data(), static_cast<std::size_t>(leaf.count)};
    }
    /// No node lies deeper.
    static constexpr int kMaxDepth = 120;

  private:
    static constexpr int kLeafCapacity = 8;

    struct Item {
        int id = -1;
        Bounds bounds;
        Vec3 center;
    };
    class Builder;

    bool contains(int id) const {
        return id < static_cast<int>(nodeOf_.size()) && nodeOf_[id] >= 0;
    }
    void noteLeaf(int id, int node);
    static Item itemOf(int id, const BoundsOf& boundsOf);
    static std::size_t halveItems(std::span<Item> items);
    void fillLeaf(int node, std::span<const Item> items);
    int newLeaf();
    int newPair();
    int chooseChild(const Node& node, const Bounds& bounds) const;
    void splitLeaf(int node, int id, const BoundsOf& boundsOf);
    void replaceBySibling(int emptyLeaf);
    void keepBalanced(int node, int depth, const BoundsOf& boundsOf);
    void rebuild(int node, const BoundsOf& boundsOf);
    void collect(int node, std::vector<int>& ids);

    std::vector<Node> nodes_;
    std::vector<std::array<int, kLeafCapacity>> leaves_;
    bool canEdit_ = false;
    std::vector<int> nodeOf_;  ///< of each id: its leaf node, -1 for none; empty until edited
    std::vector<int> freePairs_;
    std::vector<int> freeLeaves_;
};

template <class Meets, class Visit>
void BoxTree::find(Meets&& meets, Visit&& visit) const {
    std::array<int, kMaxDepth + 2> stack;
    int size = 0;
    if (!nodes_.empty()) {
        stack[size++] = 0;
    }
    while (size > 0) {
        const Node& node = nodes_[stack[--size]];
        if (node.count == 0 || !meets(node.bounds)) {
            continue;
        }
        if (node.child >= 0) {
            stack[size++] = node.child + 1;
            stack[size++] = node.child;
            continue;
        }
        for (const int id : idsOf(node)) {
            visit(id);
        }
    }
}

}  // namespace kerf
