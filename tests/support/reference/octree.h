#pragma once

#include "sim/base/math.h"

namespace kerf {

/// An octree of boxes: each item is in the octant of the middle of its box, and a node's box bounds
/// its items. Rebuilt after motion.
class Octree {
  public:
    /// Items are identified by their place in `boxes`.
    explicit Octree(std::vector<Bounds> boxes);

    /// Calls `visit` with each item whose box touches `box`; the order is that of the tree.
    void query(const Bounds& box, const std::function<void(int)>& visit) const;

  private:
    struct Node {
        Bounds box;
        std::vector<int> items;     ///< of a leaf
        std::vector<int> children;  ///< nodes, at most eight
    };

    int build(const std::vector<int>& items, int depth);
    std::array<std::vector<int>, 8> octants(const std::vector<int>& items) const;
    void query(int node, const Bounds& box, const std::function<void(int)>& visit) const;

    std::vector<Bounds> boxes_;
    std::vector<Node> nodes_;
    int root_ = 0;
};

}  // namespace kerf
