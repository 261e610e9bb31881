#include "tests/support/reference/octree.h"

namespace kerf {

namespace {

constexpr std::size_t kItemsPerLeaf = 8;
constexpr int kDeepest = 16;

}  // namespace

Octree::Octree(std::vector<Bounds> boxes) : boxes_(std::move(boxes)) {
    std::vector<int> all(boxes_.size());
    std::iota(all.begin(), all.end(), 0);
    root_ = build(all, 0);
}

int Octree::build(const std::vector<int>& items, int depth) {
    Node node;
    for (const int item : items) {
        node.box.add(boxes_[item]);
    }
    if (items.size() <= kItemsPerLeaf || depth == kDeepest) {
        node.items = items;
    } else {
        for (const std::vector<int>& octant : octants(items)) {
            if (!octant.empty()) {
                node.children.push_back(build(octant, depth + 1));
            }
        }
    }
    nodes_.push_back(std::move(node));
    return static_cast<int>(nodes_.size()) - 1;
}

std::array<std::vector<int>, 8> Octree::octants(const std::vector<int>& items) const {
    Bounds middles;
    for (const int item : items) {
        middles.add(boxes_[item].center());
    }
    const Vec3 center = middles.center();
    std::array<std::vector<int>, 8> out;
    for (const int item : items) {
        const Vec3 at = boxes_[item].center();
        const int octant = (at.x() > center.x() ? 1 : 0) + (at.y() > center.y() ? 2 : 0) +
                           (at.z() > center.z() ? 4 : 0);
        out[octant].push_back(item);
    }
    return out;
}

void Octree::query(const Bounds& box, const std::function<void(int)>& visit) const {
    query(root_, box, visit);
}

void Octree::query(int at, const Bounds& box, const std::function<void(int)>& visit) const {
    const Node& node = nodes_[at];
    if (!node.box.overlaps(box)) {
        return;
    }
    for (const int item : node.items) {
        if (boxes_[item].overlaps(box)) {
            visit(item);
        }
    }
    for (const int child : node.children) {
        query(child, box, visit);
    }
}

}  // namespace kerf
