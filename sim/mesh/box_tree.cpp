#include "sim/mesh/box_tree.h"

namespace kerf {

namespace {

// Deeper nodes are halved by count, which bounds the depth.
constexpr int kMiddleDepth = 56;
constexpr float kFar = 1e30F;

}  // namespace

Bounds BoxTree::boundsOfPlaces(int first, int end) const {
    using Four = Eigen::Array4f;
    Four low = Four::Constant(kFar);
    Four high = Four::Constant(-kFar);
    for (const Item& item : std::span(items_).subspan(first, end - first)) {
        const Four cube = Eigen::Map<const Four>(item.cube.data());
        low = low.min(cube - item.cube[3]);
        high = high.max(cube + item.cube[3]);
    }
    std::array<float, 4> l;  // the sums themselves stay in registers
    std::array<float, 4> h;
    Eigen::Map<Four>(l.data()) = low;
    Eigen::Map<Four>(h.data()) = high;
    return l[0] <= h[0] ? Bounds{{l[0], l[1], l[2]}, {h[0], h[1], h[2]}} : Bounds{};
}

void BoxTree::prepareToEdit() {
    if (std::exchange(canEdit_, true)) {
        return;
    }
    placeOf_.reserve(withGrowthRoom(items_.size()));
    for (int place = 0; place < static_cast<int>(items_.size()); ++place) {
        notePlace(place);
    }
}

/// Once for all divisions of a search.
void BoxTree::notePlaces() {
    for (const int index : reordered_) {
        const Node& node = nodes_[index];
        for (int place = node.first; node.child < 0 && place < node.end; ++place) {
            notePlace(place);
        }
    }
    reordered_.clear();
}

/// A tree of the items from this place on.
void BoxTree::plantFrom(int first) {
    Node root;
    root.first = first;
    root.end = static_cast<int>(items_.size());
    root.count = root.end - first;
    root.bounds = boundsOfPlaces(first, root.end);
    root.stamp = motion_;
    roots_.push_back(newPair());
    nodes_[roots_.back()] = root;
    while (roots_.size() > 1 &&
           nodes_[roots_[roots_.size() - 2]].count <= 2 * nodes_[roots_.back()].count) {
        joinLastTwo();
    }
}

void BoxTree::joinLastTwo() {
    const int last = roots_.back();
    roots_.pop_back();
    const int first = roots_.back();
    Node joined = nodes_[first];
    joined.bounds.add(nodes_[last].bounds);
    joined.stamp = std::min(joined.stamp, nodes_[last].stamp);
    joined.count += nodes_[last].count;
    joined.end = nodes_[last].end;
    joined.joins = std::max(joined.joins, nodes_[last].joins) + 1;
    const bool mostlyEmpty = 2 * joined.count < joined.end - joined.first;
    if (joining_ == Joining::anew || mostlyEmpty || joined.joins > kMostJoins) {
        makeUndivided(joined, first, last);
    } else {
        becomeChildren(joined, first, last);
    }
    roots_.back() = newPair();
    nodes_[roots_.back()] = joined;
}

/// One node without empty places in place of the trees of these roots, which are the last two.
void BoxTree::makeUndivided(Node& joined, int first, int last) {
    forget(first);
    forget(last);
    joined.child = -1;
    joined.joins = 0;
    joined.end = closeRanks(joined.first, joined.end);
    items_.resize(joined.end);
}

void BoxTree::becomeChildren(Node& joined, int first, int last) {
    const int left = newPair();
    nodes_[left] = nodes_[first];
    nodes_[left + 1] = nodes_[last];
    freePairs_.insert(freePairs_.end(), {first, last});
    joined.child = left;
}

void BoxTree::erase(std::span<const int> ids) {
    for (const int id : ids) {
        if (!contains(id)) {
            continue;
        }
        const int place = std::exchange(placeOf_[id], -1);
        items_[place] = {{0, 0, 0, -kFar}, -1};
        const auto behind = std::ranges::upper_bound(
            roots_, place, {}, [this](int root) { return nodes_[root].first; });
        int index = *(behind - 1);
        while (true) {
            --nodes_[index].count;
            const int child = nodes_[index].child;
            if (child < 0) {
                break;
            }
            index = place < nodes_[child + 1].first ? child : child + 1;
        }
    }
}

Bounds BoxTree::bounds() const {
    Bounds all;
    for (const int root : roots_) {
        if (nodes_[root].count > 0) {
            all.add(widened(nodes_[root]));
        }
    }
    return all;
}

int BoxTree::newPair() {
    if (!freePairs_.empty()) {
        const int left = freePairs_.back();
        freePairs_.pop_back();
        return left;
    }
    const int left = static_cast<int>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    return left;
}

/// Frees a root and all below.
void BoxTree::forget(int index) {
    freePairs_.push_back(index);
    std::vector<int> stack{nodes_[index].child};
    while (!stack.empty()) {
        const int left = stack.back();
        stack.pop_back();
        if (left >= 0) {
            stack.insert(stack.end(), {nodes_[left].child, nodes_[left + 1].child});
            freePairs_.push_back(left);
        }
    }
}

void BoxTree::setPlace(int place, const Item& item) {
    items_[place] = item;
    notePlace(place);
}

/// Moves what is there to the front; returns where the empty places begin.
int BoxTree::closeRanks(int first, int end) {
    int to = first;
    for (int place = first; place < end; ++place) {
        if (items_[place].id < 0) {
            continue;
        }
        if (place != to) {
            setPlace(to, items_[place]);
            items_[place] = {{0, 0, 0, -kFar}, -1};
        }
        ++to;
    }
    return to;
}

int BoxTree::divide(int index) {
    Node node = nodes_[index];
    if (node.end - node.first > node.count) {
        node.end = nodes_[index].end = closeRanks(node.first, node.end);
    }
    if (node.count <= kLeafSize) {
        return -1;
    }
    const int middle = partition(node);
    const int left = newPair();
    if (canEdit_) {
        reordered_.insert(reordered_.end(), {left, left + 1});
    }
    nodes_[index].child = left;
    const std::array<int, 3> cuts{node.first, middle, node.end};
    for (int i = 0; i < 2; ++i) {
        Node& child = nodes_[left + i];
        child.first = cuts[i];
        child.end = cuts[i + 1];
        child.count = child.end - child.first;
        child.bounds = boundsOfPlaces(child.first, child.end);
        child.stamp = node.stamp;
        child.child = -1;
        child.depth = node.depth + 1;
    }
    return left;
}

/// Reorders the items of a node without empty places, which then do not know their places; returns
/// where the right half begins.
int BoxTree::partition(const Node& node) {
    const auto longest = [](const Bounds& box) {
        int axis = 0;
        (box.high - box.low).maxCoeff(&axis);
        return axis;
    };
    const int axis = longest(node.bounds);
    if (node.depth >= kMiddleDepth) {
        return halve(node, axis);
    }
    const auto dividesAt = [&node](int place) { return place > node.first && place < node.end; };
    if (const int at = partitionAt(node, axis, node.bounds.center()[axis]); dividesAt(at)) {
        return at;
    }
    Bounds centers;
    for (int place = node.first; place < node.end; ++place) {
        const auto& c = items_[place].cube;
        centers.add(Vec3(c[0], c[1], c[2]));
    }
    const int across = longest(centers);
    const int at = partitionAt(node, across, centers.center()[across]);
    return dividesAt(at) ? at : halve(node, across);
}

/// Those below the plane come first; returns where the others begin. Without branches: on which
/// side an item lies can't be foreseen.
int BoxTree::partitionAt(const Node& node, int axis, double plane) {
    Item* const items = items_.data();
    Item* low = items + node.first;
    for (Item* item = low; item != items + node.end; ++item) {
        const bool isLow = item->cube[axis] < plane;
        std::swap(*item, *low);
        low += isLow ? 1 : 0;
    }
    return static_cast<int>(low - items);
}

int BoxTree::halve(const Node& node, int axis) {
    const auto begin = items_.begin() + node.first;
    std::sort(begin, items_.begin() + node.end, [axis](const Item& a, const Item& b) {
        return a.cube[axis] != b.cube[axis] ? a.cube[axis] < b.cube[axis] : a.id < b.id;
    });
    return node.first + node.count / 2;
}

void BoxTree::divideAll() {
    std::vector<int> stack = roots_;
    while (!stack.empty()) {
        const int index = stack.back();
        stack.pop_back();
        if (const int child = childrenOf(index); child >= 0) {
            stack.insert(stack.end(), {child, child + 1});
        }
    }
}

void BoxTree::refit(const BoundsOf& boundsOf) {
    motion_ += 1;  // every stamp is too old
    for (const int root : roots_) {
        refitWithin(root, 0, boundsOf);
    }
}

/// Leaves every box below at most `tolerance` too wide.
void BoxTree::refitWithin(int index, double tolerance, const BoundsOf& boundsOf) {
    if (motion_ - nodes_[index].stamp <= tolerance) {
        return;
    }
    const int child = nodes_[index].child;
    if (child < 0) {
        makeAnew(nodes_[index], boundsOf);
        return;
    }
    Bounds bounds;
    for (const int c : {child, child + 1}) {
        refitWithin(c, tolerance, boundsOf);
        if (nodes_[c].count > 0) {
            bounds.add(widened(nodes_[c]));
        }
    }
    nodes_[index].bounds = bounds;
    nodes_[index].stamp = motion_;
}

void BoxTree::makeAnew(Node& node, const BoundsOf& boundsOf) {
    for (int place = node.first; place < node.end; ++place) {
        if (const int id = items_[place].id; id >= 0) {
            items_[place] = itemOf(id, boundsOf(id));
        }
    }
    node.bounds = boundsOfPlaces(node.first, node.end);
    node.stamp = motion_;
}

}  // namespace kerf
