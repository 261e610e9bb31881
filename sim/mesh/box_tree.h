#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "sim/math.h"

namespace kerf {

/// A bounding-volume tree over numbered things with boxes: built by a binned surface-area
/// heuristic, edited by inserting and erasing, and refit lazily as the things move. What it finds
/// does not depend on its shape. (Insertion: Goldsmith and Salmon 1987; balance: Galperin and
/// Rivest 1993.)
///
/// Boxes of nodes may be larger than needed, never smaller. Each remembers how far things had moved
/// when it was made, so that after moved(d) it counts as wider by d.
class BoxTree {
  public:
    /// The box of a thing now.
    using BoundsOf = std::function<Bounds(int id)>;

    struct Node {
        Bounds bounds;
        double stamp = 0;  ///< motion() when the bounds were made
        int parent = -1;
        int child = -1;  ///< the left one, the right one follows it; -1 for a leaf
        int leaf = -1;   ///< where its ids lie; -1 for an inner node
        int count = 0;   ///< things below
    };

    BoxTree() = default;
    BoxTree(std::span<const int> ids, const BoundsOf& boundsOf);

    /// `id` must not be in the tree.
    void insert(int id, const BoundsOf& boundsOf);
    /// Does nothing where `id` is not in the tree.
    void erase(int id);
    bool contains(int id) const {
        return id < static_cast<int>(nodeOf_.size()) && nodeOf_[id] >= 0;
    }

    /// Nothing has moved farther than `distance` [m] since the last call.
    void moved(double distance) { motion_ += distance; }
    /// Makes every box anew. O(n).
    void refit(const BoundsOf& boundsOf);

    /// Calls visit(id) for everything in leaves whose box meets(box); may find more than needed.
    /// Boxes that have become much too wide are made anew on the way.
    template <class Meets, class Visit>
    void find(const BoundsOf& boundsOf, Meets&& meets, Visit&& visit);

    /// Holds all things; larger than needed by as much as they may have moved. Empty where there is
    /// nothing.
    Bounds bounds() const {
        return nodes_.empty() || nodes_[0].count == 0 ? Bounds{} : widened(nodes_[0]);
    }

    /// For other ways through the tree: node 0 is the root; empty where nothing was ever put in.
    const std::vector<Node>& nodes() const { return nodes_; }
    std::span<const int> idsOf(const Node& leaf) const {
        return {leaves_[leaf.leaf].data(), static_cast<std::size_t>(leaf.count)};
    }
    /// No node lies deeper.
    static constexpr int kMaxDepth = 120;

  private:
    static constexpr int kLeafCapacity = 8;
    // A box may be wider than needed by this share of its diagonal.
    static constexpr double kSlack = 0.1;

    struct Item {
        int id = -1;
        Bounds bounds;
        Vec3 center;
    };
    class Builder;

    static Item itemOf(int id, const BoundsOf& boundsOf);
    static std::size_t halveItems(std::span<Item> items);
    Bounds widened(const Node& node) const;
    void refitWithin(int node, double tolerance, const BoundsOf& boundsOf);
    Bounds boundsOfLeaf(const Node& leaf, const BoundsOf& boundsOf) const;
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
    std::vector<int> nodeOf_;  ///< leaf node of each id, -1 for none
    std::vector<int> freePairs_;
    std::vector<int> freeLeaves_;
    double motion_ = 0;
};

template <class Meets, class Visit>
void BoxTree::find(const BoundsOf& boundsOf, Meets&& meets, Visit&& visit) {
    std::array<int, kMaxDepth + 2> stack;
    int size = 0;
    if (!nodes_.empty()) {
        stack[size++] = 0;
    }
    while (size > 0) {
        const int index = stack[--size];
        if (nodes_[index].count == 0 || !meets(widened(nodes_[index]))) {
            continue;
        }
        const double slack = motion_ - nodes_[index].stamp;
        if (const double most = kSlack * nodes_[index].bounds.diagonal(); slack > most) {
            refitWithin(index, most, boundsOf);
            if (!meets(nodes_[index].bounds)) {
                continue;
            }
        }
        const Node& node = nodes_[index];
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
