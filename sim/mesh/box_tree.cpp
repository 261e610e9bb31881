#include "sim/mesh/box_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace kerf {

namespace {

constexpr int kLeafSize = 4;  // of a fresh tree: leaves room for insertion
constexpr int kBins = 16;
// Deeper nodes are halved by count, which bounds the depth.
constexpr int kSahDepth = 64;
// Weight balance: deeper than 2 log2(n) + 8, some node on the way has a child above this share.
constexpr double kHeavyShare = 0.7;
constexpr double kDepthPerDoubling = 2;
constexpr double kFreeDepth = 8;

double halfSurface(const Bounds& box) {
    if (box.empty()) {
        return 0;
    }
    const Vec3 size = box.high - box.low;
    return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

double growth(const Bounds& box, const Bounds& added) {
    Bounds both = box;
    both.add(added);
    return halfSurface(both) - halfSurface(box);
}

struct Split {
    int axis = -1;  // -1: none found
    double plane = 0;
    double cost = 1e300;
};

}  // namespace

/// Reorders them by the middle along the longest side of their centres; returns how many lie before
/// it.
std::size_t BoxTree::halveItems(std::span<Item> items) {
    Bounds centers;
    for (const Item& item : items) {
        centers.add(item.center);
    }
    int axis = 0;
    (centers.high - centers.low).maxCoeff(&axis);
    const std::size_t half = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + half, items.end(),
                     [axis](const Item& a, const Item& b) {
                         return a.center[axis] < b.center[axis] ||
                                (a.center[axis] == b.center[axis] && a.id < b.id);
                     });
    return half;
}

/// Fills a subtree with items, from a node that has neither children nor a leaf.
class BoxTree::Builder {
  public:
    enum class Rule { surfaceArea, halves };
    Builder(BoxTree& tree, std::vector<Item> items, Rule rule)
        : tree_(tree), items_(std::move(items)), rule_(rule) {}

    void build(int root) {
        tasks_.push_back({root, 0, static_cast<int>(items_.size()), 0});
        while (!tasks_.empty()) {
            const Task task = tasks_.back();
            tasks_.pop_back();
            divide(task);
        }
    }

  private:
    struct Task {
        int node, first, count, depth;
    };

    std::span<Item> itemsOf(const Task& task) {
        return {items_.data() + task.first, static_cast<std::size_t>(task.count)};
    }

    void divide(const Task& task) {
        if (task.count <= kLeafSize) {
            tree_.fillLeaf(task.node, itemsOf(task));
            return;
        }
        Bounds bounds;
        Bounds centers;
        for (const Item& item : itemsOf(task)) {
            bounds.add(item.bounds);
            centers.add(item.center);
        }
        const int half = partition(task, centers);
        const int left = tree_.newPair();
        Node& node = tree_.nodes_[task.node];
        node.bounds = bounds;
        node.count = task.count;
        node.child = left;
        tree_.nodes_[left].parent = task.node;
        tree_.nodes_[left + 1].parent = task.node;
        tasks_.push_back({left, task.first, half, task.depth + 1});
        tasks_.push_back({left + 1, task.first + half, task.count - half, task.depth + 1});
    }

    /// Reorders the task's items; returns how many go left (at least one stays on each side).
    int partition(const Task& task, const Bounds& centers) {
        const bool bySurface = rule_ == Rule::surfaceArea && task.depth < kSahDepth;
        const Split split = bySurface ? findSplit(task, centers) : Split{};
        if (split.axis < 0) {
            return static_cast<int>(halveItems(itemsOf(task)));
        }
        const std::span<Item> items = itemsOf(task);
        const auto middle = std::partition(items.begin(), items.end(), [&](const Item& item) {
            return item.center[split.axis] < split.plane;
        });
        const int half = static_cast<int>(middle - items.begin());
        return half > 0 && half < task.count ? half : static_cast<int>(halveItems(itemsOf(task)));
    }

    Split findSplit(const Task& task, const Bounds& centers) {
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            tryAxis(task, axis, centers, best);
        }
        return best;
    }

    void tryAxis(const Task& task, int axis, const Bounds& centers, Split& best) {
        const double low = centers.low[axis];
        const double extent = centers.high[axis] - low;
        if (extent <= 0) {
            return;
        }
        std::array<Bounds, kBins> boxes;
        std::array<int, kBins> counts{};
        for (const Item& item : itemsOf(task)) {
            const double share = (item.center[axis] - low) / extent;
            const int bin = std::min(kBins - 1, static_cast<int>(share * kBins));
            boxes[bin].add(item.bounds);
            ++counts[bin];
        }
        std::array<double, kBins> rightCost{};
        sweepFromRight(boxes, counts, rightCost);
        Bounds left;
        int count = 0;
        for (int bin = 0; bin + 1 < kBins; ++bin) {
            left.add(boxes[bin]);
            count += counts[bin];
            const double cost = count * halfSurface(left) + rightCost[bin + 1];
            if (count > 0 && count < task.count && cost < best.cost) {
                best = {axis, low + extent * (bin + 1) / kBins, cost};
            }
        }
    }

    static void sweepFromRight(const std::array<Bounds, kBins>& boxes,
                               const std::array<int, kBins>& counts,
                               std::array<double, kBins>& rightCost) {
        Bounds right;
        int count = 0;
        for (int bin = kBins - 1; bin > 0; --bin) {
            right.add(boxes[bin]);
            count += counts[bin];
            rightCost[bin] = count * halfSurface(right);
        }
    }

    BoxTree& tree_;
    std::vector<Item> items_;
    Rule rule_;
    std::vector<Task> tasks_;
};

BoxTree::BoxTree(std::span<const int> ids, const BoundsOf& boundsOf) {
    std::vector<Item> items;
    items.reserve(ids.size());
    for (const int id : ids) {
        items.push_back(itemOf(id, boundsOf));
    }
    nodes_.emplace_back();
    Builder(*this, std::move(items), Builder::Rule::surfaceArea).build(0);
}

BoxTree::Item BoxTree::itemOf(int id, const BoundsOf& boundsOf) {
    const Bounds bounds = boundsOf(id);
    return {id, bounds, bounds.center()};
}

int BoxTree::newLeaf() {
    if (!freeLeaves_.empty()) {
        const int leaf = freeLeaves_.back();
        freeLeaves_.pop_back();
        return leaf;
    }
    leaves_.emplace_back();
    return static_cast<int>(leaves_.size()) - 1;
}

int BoxTree::newPair() {
    if (!freePairs_.empty()) {
        const int left = freePairs_.back();
        freePairs_.pop_back();
        nodes_[left] = {};
        nodes_[left + 1] = {};
        return left;
    }
    const int left = static_cast<int>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    return left;
}

void BoxTree::fillLeaf(int index, std::span<const Item> items) {
    Node& node = nodes_[index];
    node.bounds = {};
    node.child = -1;
    node.leaf = newLeaf();
    node.count = static_cast<int>(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        leaves_[node.leaf][i] = items[i].id;
        node.bounds.add(items[i].bounds);
        noteLeaf(items[i].id, index);
    }
}

void BoxTree::noteLeaf(int id, int node) {
    if (!canEdit_) {
        return;
    }
    if (id >= static_cast<int>(nodeOf_.size())) {
        nodeOf_.resize(id + 1, -1);
    }
    nodeOf_[id] = node;
}

void BoxTree::prepareToEdit() {
    if (std::exchange(canEdit_, true)) {
        return;
    }
    for (int index = 0; index < static_cast<int>(nodes_.size()); ++index) {
        if (nodes_[index].child < 0) {
            for (const int id : idsOf(nodes_[index])) {
                noteLeaf(id, index);
            }
        }
    }
}

int BoxTree::chooseChild(const Node& node, const Bounds& bounds) const {
    const Node& left = nodes_[node.child];
    const Node& right = nodes_[node.child + 1];
    const double toLeft = growth(left.bounds, bounds);
    const double toRight = growth(right.bounds, bounds);
    const bool goesLeft = toLeft < toRight || (toLeft == toRight && left.count <= right.count);
    return node.child + (goesLeft ? 0 : 1);
}

void BoxTree::insert(int id, const BoundsOf& boundsOf) {
    prepareToEdit();
    assert(!contains(id));
    if (nodes_.empty()) {
        nodes_.emplace_back();
        fillLeaf(0, {});
    }
    const Bounds bounds = boundsOf(id);
    int index = 0;
    int depth = 0;
    for (; nodes_[index].child >= 0; ++depth) {
        nodes_[index].bounds.add(bounds);
        ++nodes_[index].count;
        index = chooseChild(nodes_[index], bounds);
    }
    Node& leaf = nodes_[index];
    if (leaf.count == kLeafCapacity) {
        splitLeaf(index, id, boundsOf);
    } else {
        leaf.bounds.add(bounds);
        leaves_[leaf.leaf][leaf.count++] = id;
        noteLeaf(id, index);
    }
    keepBalanced(index, depth, boundsOf);
}

// Two leaves, each at least half full: divided at the middle of the longest side of the centres.
void BoxTree::splitLeaf(int index, int id, const BoundsOf& boundsOf) {
    std::array<Item, kLeafCapacity + 1> items;
    items[0] = itemOf(id, boundsOf);
    for (int i = 0; i < kLeafCapacity; ++i) {
        items[i + 1] = itemOf(leaves_[nodes_[index].leaf][i], boundsOf);
    }
    freeLeaves_.push_back(std::exchange(nodes_[index].leaf, -1));
    const std::size_t half = halveItems(items);
    const int left = newPair();
    nodes_[left].parent = nodes_[left + 1].parent = index;
    fillLeaf(left, std::span(items).first(half));
    fillLeaf(left + 1, std::span(items).subspan(half));
    Node& node = nodes_[index];
    node.bounds = nodes_[left].bounds;
    node.bounds.add(nodes_[left + 1].bounds);
    node.count = static_cast<int>(items.size());
    node.child = left;
}

void BoxTree::erase(int id) {
    prepareToEdit();
    if (!contains(id)) {
        return;
    }
    const int index = std::exchange(nodeOf_[id], -1);
    Node& leaf = nodes_[index];
    const auto begin = leaves_[leaf.leaf].begin();
    const auto end = begin + leaf.count;
    std::copy(std::find(begin, end, id) + 1, end, std::find(begin, end, id));
    for (int i = index; i >= 0; i = nodes_[i].parent) {
        --nodes_[i].count;
    }
    if (leaf.count == 0 && index != 0) {
        replaceBySibling(index);
    }
}

/// The parent of a leaf that has become empty takes over what its other child holds.
void BoxTree::replaceBySibling(int emptyLeaf) {
    const int parent = nodes_[emptyLeaf].parent;
    const int left = nodes_[parent].child;
    const Node sibling = nodes_[emptyLeaf == left ? left + 1 : left];
    freeLeaves_.push_back(nodes_[emptyLeaf].leaf);
    freePairs_.push_back(left);
    const int grandparent = nodes_[parent].parent;
    nodes_[parent] = sibling;
    nodes_[parent].parent = grandparent;
    if (sibling.child >= 0) {
        nodes_[sibling.child].parent = parent;
        nodes_[sibling.child + 1].parent = parent;
        return;
    }
    for (const int id : idsOf(sibling)) {
        noteLeaf(id, parent);
    }
}

void BoxTree::keepBalanced(int index, int depth, const BoundsOf& boundsOf) {
    if (depth <= kDepthPerDoubling * std::log2(nodes_[0].count) + kFreeDepth) {
        return;
    }
    for (int i = nodes_[index].parent; i >= 0; i = nodes_[i].parent) {
        const int child = nodes_[i].child;
        const int heavier = std::max(nodes_[child].count, nodes_[child + 1].count);
        if (heavier > kHeavyShare * nodes_[i].count && nodes_[i].count > kLeafCapacity) {
            rebuild(i, boundsOf);
            return;
        }
    }
}

void BoxTree::rebuild(int index, const BoundsOf& boundsOf) {
    std::vector<int> ids;
    const int child = nodes_[index].child;
    collect(child, ids);
    collect(child + 1, ids);
    freePairs_.push_back(child);
    nodes_[index].child = -1;
    std::vector<Item> items;
    items.reserve(ids.size());
    for (const int id : ids) {
        items.push_back(itemOf(id, boundsOf));
    }
    Builder(*this, std::move(items), Builder::Rule::halves).build(index);
}

/// Appends the ids below a node and frees what it holds, not the node itself.
void BoxTree::collect(int index, std::vector<int>& ids) {
    const Node node = nodes_[index];
    if (node.child < 0) {
        const std::span<const int> below = idsOf(node);
        ids.insert(ids.end(), below.begin(), below.end());
        freeLeaves_.push_back(node.leaf);
        return;
    }
    collect(node.child, ids);
    collect(node.child + 1, ids);
    freePairs_.push_back(node.child);
}

}  // namespace kerf
