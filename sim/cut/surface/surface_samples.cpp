#include "sim/cut/surface/surface_samples.h"

#include <algorithm>
#include <utility>

#include "sim/base/boxes.h"

namespace kerf::cut {

namespace {

// A node of the tree is one sample where it is smaller than this share of its distance, or of h.
constexpr double kOpening = 0.5;
constexpr double kFinest = 0.5;
// The places are gathered into boxes, not more than so many, not smaller than so many h.
constexpr std::size_t kMostBoxes = 8;
constexpr double kSmallBox = 6;
constexpr double kRoom = 3;

struct Cluster {
    std::vector<Vec3> places;
    Bounds box;
};

Cluster clusterOf(std::vector<Vec3> places) {
    const Bounds box = boxOf(places);
    return {std::move(places), box};
}

/// The half on the low side leaves it.
Cluster takeHalf(Cluster& cluster) {
    int axis = 0;
    (cluster.box.high - cluster.box.low).maxCoeff(&axis);
    const double middle = cluster.box.center()[axis];
    std::vector<Vec3>& all = cluster.places;
    const auto from = std::stable_partition(all.begin(), all.end(),
                                            [&](const Vec3& p) { return p[axis] > middle; });
    Cluster low = clusterOf({from, all.end()});
    all.erase(from, all.end());
    cluster = clusterOf(std::move(all));
    return low;
}

double distance(const Bounds& a, const Bounds& b) {
    return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0.0).norm();
}

class Thinning {
  public:
    Thinning(BoxTree& tree, const std::function<const Triangle&(int)>& cornersOf,
             const std::vector<Bounds>& boxes, double h, std::vector<int>& slots)
        : tree_(tree), cornersOf_(cornersOf), boxes_(boxes), h_(h), slots_(slots) {}

    std::vector<SurfaceSample> run() {
        std::vector<int> stack = tree_.roots();
        while (!stack.empty()) {
            const int index = stack.back();
            stack.pop_back();
            const BoxTree::Node& node = tree_.node(index);
            if (node.count == 0) {
                continue;
            }
            if (node.bounds.diagonal() <= mostSizeOfSample(node.bounds)) {
                addOne(node);
            } else if (const int child = tree_.childrenOf(index); child >= 0) {
                stack.insert(stack.end(), {child + 1, child});
            } else {
                addAll(tree_.node(index));
            }
        }
        for (const SurfaceSample& sample : samples_) {
            slots_[sample.vertex] = -1;
        }
        return std::move(samples_);
    }

  private:
    double mostSizeOfSample(const Bounds& bounds) const {
        double size = 1e300;
        for (const Bounds& box : boxes_) {
            const double spare = std::max(0.0, box.diagonal() - (kSmallBox + 4 * kRoom) * h_);
            size = std::min(size, kOpening * (distance(box, bounds) + spare));
        }
        return std::max(size, kFinest * h_);
    }

    void addOne(const BoxTree::Node& node) {
        add(cornersOf_(tree_.firstOf(node))[0], static_cast<double>(node.count));
    }

    void addAll(const BoxTree::Node& node) {
        tree_.forEach(node, [this](int id) {
            for (const int v : cornersOf_(id)) {
                add(v, 1.0 / 3);
            }
        });
    }

    void add(int vertex, double weight) {
        int& slot = slots_[vertex];
        if (slot < 0) {
            slot = static_cast<int>(samples_.size());
            samples_.push_back({vertex, 0});
        }
        samples_[slot].weight += weight;
    }

    BoxTree& tree_;
    const std::function<const Triangle&(int)>& cornersOf_;
    const std::vector<Bounds>& boxes_;
    double h_;
    std::vector<int>& slots_;  ///< of each vertex: its sample, -1 for none
    std::vector<SurfaceSample> samples_;
};

}  // namespace

std::vector<Bounds> boxesAround(std::vector<Vec3> places, double h) {
    std::vector<Cluster> clusters{clusterOf(std::move(places))};
    while (clusters.size() < kMostBoxes) {
        const auto largest = std::ranges::max_element(
            clusters, {}, [](const Cluster& c) { return c.box.diagonal(); });
        if (largest->box.diagonal() <= kSmallBox * h) {
            break;
        }
        clusters.push_back(takeHalf(*largest));
    }
    std::vector<Bounds> boxes;
    for (const Cluster& cluster : clusters) {
        boxes.push_back(cluster.box);
        boxes.back().widen(kRoom * h);
    }
    return boxes;
}

std::vector<SurfaceSample> thinByDistance(BoxTree& tree,
                                          const std::function<const Triangle&(int id)>& cornersOf,
                                          const std::vector<Bounds>& boxes, double h,
                                          std::vector<int>& slots) {
    return Thinning(tree, cornersOf, boxes, h, slots).run();
}

}  // namespace kerf::cut
