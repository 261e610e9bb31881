#pragma once

#include <cassert>

#include "sim/base/containers.h"
#include "sim/base/math.h"
#include "sim/mesh/triangle.h"

namespace kerf {

/// A forest of bounding-volume trees over numbered items with boxes that change in batches. Nodes
/// are divided lazily, at the middle of their longest side, so what is never searched costs one
/// pass. A batch is a separate tree; trees of similar size join (Bentley and Saxe 1980). Results do
/// not depend on its shape.
///
/// Boxes of nodes may be larger than needed, never smaller. Each stores the motion of items when it
/// was made, so that after moved(d) it counts as wider by d.
class BoxTree {
  public:
    /// Returns the present box of an item.
    using BoundsOf = std::function<Bounds(int id)>;

    /// How two trees join.
    enum class Joining {
        anew,    ///< one undivided tree, which separates places best
        divided  ///< as halves of a tree, each divided as it is
    };

    struct Node {
        Bounds bounds;
        double stamp = 0;  ///< motion of the items when the bounds were made
        int first = 0;     ///< of its places
        int end = 0;       ///< behind them
        int child = -1;    ///< the left one, the right one follows it; -1 while it is not divided
        int depth = 0;     ///< below the root of its batch
        int count = 0;     ///< items below; places may be empty
        int joins = 0;     ///< of a root: the most joins above its batches
    };

    explicit BoxTree(Joining joining = Joining::anew) : joining_(joining) {}
    /// O(n). `boundsOf` is a BoundsOf, or callable like one.
    template <class Of>
    BoxTree(std::span<const int> ids, const Of& boundsOf, Joining joining = Joining::anew)
        : joining_(joining) {
        insert(ids, boundsOf);
    }

    /// Does in advance what the first edit or look-up of an id would do: stores the place of each
    /// id. O(n), and memory up to the largest id, which a tree without edits does not need.
    void prepareToEdit();
    /// Adds items to the tree; none of them may be in it.
    template <class Of>
    void insert(std::span<const int> ids, const Of& boundsOf);
    /// Removes those of `ids` that are in the tree.
    void erase(std::span<const int> ids);
    bool contains(int id) {
        prepareToEdit();
        notePlaces();
        return id < static_cast<int>(placeOf_.size()) && placeOf_[id] >= 0;
    }
    /// Whether an item is in the tree with this box.
    bool holds(int id, const Bounds& bounds) {
        return contains(id) && items_[placeOf_[id]].cube == itemOf(id, bounds).cube;
    }

    /// Nothing has moved farther than `distance` [m] since the last call.
    void moved(double distance) { motion_ += distance; }
    /// Recomputes every box. O(n).
    void refit(const BoundsOf& boundsOf);

    /// Calls visit(id) for everything in undivided nodes whose box meets(box); may find more than
    /// needed. Recomputes boxes that have become much too wide.
    template <class Meets, class Visit>
    void find(const BoundsOf& boundsOf, Meets&& meets, Visit&& visit);

    /// Holds all items; larger than needed by as much as they may have moved. Empty without items.
    Bounds bounds() const;

    // For other ways through the trees.
    /// The root nodes, one a tree.
    const std::vector<int>& roots() const { return roots_; }
    const Node& node(int index) const { return nodes_[index]; }
    /// The left child, the right one follows it; -1 for a node with few items. Divides the node if
    /// needed.
    int childrenOf(int index) {
        return nodes_[index].child >= 0 ? nodes_[index].child : divide(index);
    }
    template <class Visit>
    void forEach(const Node& node, Visit&& visit) const {
        for (int place = node.first; place < node.end; ++place) {
            if (items_[place].id >= 0) {
                visit(items_[place].id);
            }
        }
    }
    /// The first item of a node, which must not be empty.
    int firstOf(const Node& node) const {
        int place = node.first;
        while (items_[place].id < 0) {
            ++place;
        }
        return items_[place].id;
    }
    /// Divides all nodes, so that no search has to. O(n log n).
    void divideAll();

    /// No node lies deeper.
    static constexpr int kMaxDepth = 98;
    /// Roots halve in size at least from one to the next.
    static constexpr int kMostRoots = 33;
    /// The most nodes that a search has on its stack.
    static constexpr int kMostInSearch = kMaxDepth + kMostRoots + 2;

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(joining_, nodes_, items_, canEdit_, placeOf_, reordered_, roots_, freePairs_, motion_);
    }

  private:
    // A box may be wider than needed by this share of its diagonal.
    static constexpr double kSlack = 0.1;
    static constexpr int kLeafSize = 8;
    // After so many joins above each other a tree is made anew.
    static constexpr int kMostJoins = 8;
    // Cubes are larger by these shares of their reach and of their distance from the origin, which
    // covers the roundings of floats.
    static constexpr double kRoundingOfReach = 1e-6;
    static constexpr double kRoundingOfCenter = 3e-7;

    /// An item by a cube that holds its box.
    struct Item {
        /// Its centre, then half its side: far below 0 where the place is empty.
        std::array<float, 4> cube{};
        int id = -1;  ///< -1: the place is empty
    };

    static Item itemOf(int id, const Bounds& bounds);
    void notePlace(int place);
    void notePlaces();
    void plantFrom(int first);
    Bounds widened(const Node& node) const {
        Bounds bounds = node.bounds;
        bounds.widen(motion_ - node.stamp);
        return bounds;
    }
    bool isTooWide(const Node& node) const {
        const double slack = motion_ - node.stamp;
        return slack > 0 && slack > kSlack * node.bounds.diagonal();
    }
    Bounds boundsOfPlaces(int first, int end) const;
    int divide(int index);
    int partition(const Node& node);
    int partitionAt(const Node& node, int axis, double plane);
    int halve(const Node& node, int axis);
    void setPlace(int place, const Item& item);
    int closeRanks(int first, int end);
    void joinLastTwo();
    void makeUndivided(Node& joined, int first, int last);
    void becomeChildren(Node& joined, int first, int last);
    int newPair();
    void forget(int index);
    void refitWithin(int index, double tolerance, const BoundsOf& boundsOf);
    void makeAnew(Node& node, const BoundsOf& boundsOf);

    Joining joining_;
    std::vector<Node> nodes_;
    std::vector<Item> items_;  ///< those of a node lie in a row
    bool canEdit_ = false;
    std::vector<int> placeOf_;    ///< of each id, -1 for none; empty until first used
    std::vector<int> reordered_;  ///< nodes whose items may not know their places
    std::vector<int> roots_;      ///< in the order of their places
    std::vector<int> freePairs_;
    double motion_ = 0;
};

template <class Of>
void BoxTree::insert(std::span<const int> ids, const Of& boundsOf) {
    if (ids.empty()) {
        return;
    }
    notePlaces();
    if (items_.empty()) {
        items_.reserve(withGrowthRoom(ids.size()));
    }
    const int first = static_cast<int>(items_.size());
    for (const int id : ids) {
        assert(!canEdit_ || !contains(id));
        items_.push_back(itemOf(id, boundsOf(id)));
        notePlace(static_cast<int>(items_.size()) - 1);
    }
    plantFrom(first);
}

inline void BoxTree::notePlace(int place) {
    if (!canEdit_) {
        return;
    }
    const int id = items_[place].id;
    if (id >= static_cast<int>(placeOf_.size())) {
        placeOf_.resize(id + 1, -1);
    }
    placeOf_[id] = place;
}

inline BoxTree::Item BoxTree::itemOf(int id, const Bounds& bounds) {
    Item item;
    double reach = 0;
    double farthest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        item.cube[axis] = static_cast<float>(0.5 * (bounds.low[axis] + bounds.high[axis]));
        const double center = item.cube[axis];
        reach = std::max({reach, bounds.high[axis] - center, center - bounds.low[axis]});
        farthest = std::max(farthest, std::fabs(center));
    }
    item.cube[3] =
        static_cast<float>(reach * (1 + kRoundingOfReach) + (farthest + reach) * kRoundingOfCenter);
    item.id = id;
    return item;
}

template <class Meets, class Visit>
void BoxTree::find(const BoundsOf& boundsOf, Meets&& meets, Visit&& visit) {
    std::array<int, kMostInSearch> stack;
    int size = 0;
    for (const int root : roots_) {
        stack[size++] = root;
    }
    while (size > 0) {
        const int index = stack[--size];
        if (nodes_[index].count == 0 || !meets(widened(nodes_[index]))) {
            continue;
        }
        if (isTooWide(nodes_[index])) {
            refitWithin(index, kSlack * nodes_[index].bounds.diagonal(), boundsOf);
            if (!meets(nodes_[index].bounds)) {
                continue;
            }
        }
        if (const int child = childrenOf(index); child >= 0) {
            stack[size++] = child + 1;
            stack[size++] = child;
        } else {
            forEach(nodes_[index], visit);
        }
    }
}

/// A ray for box tests. `direction` need not have length 1; along an axis without motion the ray
/// passes if it starts between the box's sides.
struct BoxRay {
    BoxRay(const Vec3& from, const Vec3& along) : origin(from), direction(along) {
        for (int axis = 0; axis < 3; ++axis) {
            inverse[axis] = along[axis] != 0 ? 1 / along[axis] : 1e200;
        }
    }
    Vec3 origin, direction, inverse;
};

inline constexpr double kMissesBox = 1e301;

/// The place where the ray enters the box, in lengths of its direction, at least 0; kMissesBox if
/// it does not before `farthest`. Shares of the ray between the planes of each axis (Kay and Kajiya
/// 1986).
inline double entryInto(const Bounds& box, const BoxRay& ray, double farthest) {
    const Vec3 toLow = (box.low - ray.origin).cwiseProduct(ray.inverse);
    const Vec3 toHigh = (box.high - ray.origin).cwiseProduct(ray.inverse);
    const double enter = std::max(0.0, toLow.cwiseMin(toHigh).maxCoeff());
    const double leave = std::min(farthest, toLow.cwiseMax(toHigh).minCoeff());
    return enter <= leave ? enter : kMissesBox;
}

/// Where a line meets a triangle, from either side.
struct LineHit {
    double distance = 0;  ///< along the direction, in its lengths; below 0 behind the origin
    double b1 = 0;        ///< weight of the second corner
    double b2 = 0;        ///< of the third one
};

/// Share of their edges by which triangles extend beyond their border, so that no line passes
/// between two.
inline constexpr double kHitBorder = 2e-5;

/// Möller and Trumbore (1997), with a border that is widened by kHitBorder. None for a line that
/// lies in the plane of the triangle to a cosine of `leastCosine`.
inline std::optional<LineHit> hitOf(const Corners& corners, const Vec3& origin,
                                    const Vec3& direction, double leastCosine) {
    const Vec3 e1 = corners[1] - corners[0];
    const Vec3 e2 = corners[2] - corners[0];
    const Vec3 p = direction.cross(e2);
    const double determinant = e1.dot(p);
    const double scale = e1.cross(e2).norm() * direction.norm();
    if (std::abs(determinant) <= leastCosine * scale) {
        return std::nullopt;
    }
    const Vec3 s = origin - corners[0];
    const Vec3 q = s.cross(e1);
    const double b1 = s.dot(p) / determinant;
    const double b2 = direction.dot(q) / determinant;
    if (b1 < -kHitBorder || b2 < -kHitBorder || b1 + b2 > 1 + kHitBorder) {
        return std::nullopt;
    }
    return LineHit{e2.dot(q) / determinant, b1, b2};
}

}  // namespace kerf
