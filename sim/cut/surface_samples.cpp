#include "sim/cut/surface_samples.h"

#include <algorithm>
#include <array>
#include <utility>

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
    Cluster cluster{std::move(places), {}};
    for (const Vec3& p : cluster.places) {
        cluster.box.add(p);
    }
    return cluster;
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
    Thinning(const BoxTree& tree, const std::function<const Triangle&(int)>& cornersOf,
             const std::vector<Bounds>& boxes, double h)
        : tree_(tree), cornersOf_(cornersOf), boxes_(boxes), h_(h) {}

    std::vector<SurfaceSample> run() {
        std::vector<int> stack{0};
        while (!stack.empty()) {
            const BoxTree::Node& node = tree_.nodes()[stack.back()];
            stack.pop_back();
            if (node.count == 0) {
                continue;
            }
            if (node.bounds.diagonal() <= mostSizeOfSample(node.bounds)) {
                addOne(node);
            } else if (node.child >= 0) {
                stack.push_back(node.child + 1);
                stack.push_back(node.child);
            } else {
                addAll(node);
            }
        }
        return merged();
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
        const BoxTree::Node* below = &node;
        while (below->child >= 0) {
            const BoxTree::Node& left = tree_.nodes()[below->child];
            below = left.count > 0 ? &left : &left + 1;
        }
        const int vertex = cornersOf_(tree_.idsOf(*below).front())[0];
        samples_.push_back({vertex, static_cast<double>(node.count)});
    }

    void addAll(const BoxTree::Node& leaf) {
        for (const int id : tree_.idsOf(leaf)) {
            for (const int v : cornersOf_(id)) {
                samples_.push_back({v, 1.0 / 3});
            }
        }
    }

    std::vector<SurfaceSample> merged() {
        std::ranges::stable_sort(samples_, {}, &SurfaceSample::vertex);
        std::vector<SurfaceSample> out;
        for (const SurfaceSample& sample : samples_) {
            if (!out.empty() && out.back().vertex == sample.vertex) {
                out.back().weight += sample.weight;
            } else {
                out.push_back(sample);
            }
        }
        return out;
    }

    const BoxTree& tree_;
    const std::function<const Triangle&(int)>& cornersOf_;
    const std::vector<Bounds>& boxes_;
    double h_;
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

std::vector<SurfaceSample> thinByDistance(const BoxTree& tree,
                                          const std::function<const Triangle&(int id)>& cornersOf,
                                          const std::vector<Bounds>& boxes, double h) {
    return Thinning(tree, cornersOf, boxes, h).run();
}

}  // namespace kerf::cut
