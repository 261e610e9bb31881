#include "sim/body/ray_tree.h"

#include <algorithm>
#include <cmath>

namespace kerf {

namespace {

constexpr double kBorder = 2e-5;       // tolerance on barycentric coordinates
constexpr double kLeastCosine = 1e-6;  // rays closer to a triangle's plane miss it
constexpr int kLeafSize = 4;
constexpr int kBins = 16;
constexpr double kMiss = 1e301;

double halfSurface(const Bounds& box) {
    if (box.empty()) {
        return 0;
    }
    const Vec3 size = box.high - box.low;
    return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

Bounds widenedBounds(const SurfaceMesh& mesh, int triangle) {
    Bounds box;
    for (const int v : mesh.triangle(triangle)) {
        box.add(mesh.restPosition(v));
    }
    box.widen(4 * kBorder * box.diagonal());
    return box;
}

struct Split {
    int axis = -1;  // -1: none found
    double plane = 0;
    double cost = 1e300;
};

}  // namespace

struct RayTree::Builder {
    struct Item {
        Bounds bounds;
        Vec3 center;
        int triangle;
    };
    struct Task {
        int node, first, count, depth;
    };

    std::vector<Item> items;
    std::vector<Node> nodes;
    std::vector<Task> tasks;

    explicit Builder(const SurfaceMesh& mesh, const std::vector<int>& triangles) {
        items.reserve(triangles.size());
        for (const int t : triangles) {
            const Bounds box = widenedBounds(mesh, t);
            items.push_back({box, box.center(), t});
        }
    }

    void build() {
        if (items.empty()) {
            return;
        }
        nodes.emplace_back();
        tasks.push_back({0, 0, static_cast<int>(items.size()), 0});
        while (!tasks.empty()) {
            const Task task = tasks.back();
            tasks.pop_back();
            divide(task);
        }
    }

    void divide(const Task& task) {
        nodes[task.node].bounds = boundsOf(task);
        if (task.count <= kLeafSize) {
            nodes[task.node].first = task.first;
            nodes[task.node].count = task.count;
            return;
        }
        const int left = static_cast<int>(nodes.size());
        const int half = partition(task);
        nodes[task.node].first = left;
        nodes.resize(nodes.size() + 2);
        tasks.push_back({left, task.first, half, task.depth + 1});
        tasks.push_back({left + 1, task.first + half, task.count - half, task.depth + 1});
    }

    Bounds boundsOf(const Task& task) const {
        Bounds box;
        for (int i = task.first; i < task.first + task.count; ++i) {
            box.add(items[i].bounds);
        }
        return box;
    }

    /// Reorders the task's items; returns how many go left (at least one stays on each side).
    int partition(const Task& task) {
        const auto begin = items.begin() + task.first;
        const auto end = begin + task.count;
        const Split split = task.depth < kSahDepth ? findSplit(task) : Split{};
        if (split.axis < 0) {
            return task.count / 2;
        }
        const auto middle = std::partition(
            begin, end, [&](const Item& item) { return item.center[split.axis] < split.plane; });
        const int half = static_cast<int>(middle - begin);
        return half > 0 && half < task.count ? half : task.count / 2;
    }

    Split findSplit(const Task& task) const {
        Bounds centers;
        for (int i = task.first; i < task.first + task.count; ++i) {
            centers.add(items[i].center);
        }
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            tryAxis(task, axis, centers, best);
        }
        return best;
    }

    void tryAxis(const Task& task, int axis, const Bounds& centers, Split& best) const {
        const double low = centers.low[axis];
        const double extent = centers.high[axis] - low;
        if (extent <= 0) {
            return;
        }
        std::array<Bounds, kBins> boxes;
        std::array<int, kBins> counts{};
        for (int i = task.first; i < task.first + task.count; ++i) {
            const double share = (items[i].center[axis] - low) / extent;
            const int bin = std::min(kBins - 1, static_cast<int>(share * kBins));
            boxes[bin].add(items[i].bounds);
            ++counts[bin];
        }
        std::array<double, kBins> rightCost{};
        sweepFromRight(boxes, counts, rightCost);
        Bounds left;
        int leftCount = 0;
        for (int bin = 0; bin + 1 < kBins; ++bin) {
            left.add(boxes[bin]);
            leftCount += counts[bin];
            const double cost = leftCount * halfSurface(left) + rightCost[bin + 1];
            if (leftCount > 0 && leftCount < task.count && cost < best.cost) {
                best = {axis, low + extent * (bin + 1) / kBins, cost};
            }
        }
    }

    /// rightCost[b]: count times surface of the bins b and above.
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
};

RayTree::RayTree(const SurfaceMesh& mesh, std::vector<int> triangles)
    : mesh_(mesh), triangles_(std::move(triangles)) {
    Builder builder(mesh_, triangles_);
    builder.build();
    nodes_ = std::move(builder.nodes);
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        triangles_[i] = builder.items[i].triangle;
    }
}

RayTree::Ray::Ray(const Vec3& from, const Vec3& along) : origin(from), direction(along) {
    for (int axis = 0; axis < 3; ++axis) {
        inverse[axis] = along[axis] != 0 ? 1 / along[axis] : 1e200;
    }
}

double RayTree::entry(const Bounds& box, const Ray& ray, double farthest) {
    const Vec3 toLow = (box.low - ray.origin).cwiseProduct(ray.inverse);
    const Vec3 toHigh = (box.high - ray.origin).cwiseProduct(ray.inverse);
    const double enter = std::max(0.0, toLow.cwiseMin(toHigh).maxCoeff());
    const double leave = std::min(farthest, toLow.cwiseMax(toHigh).minCoeff());
    return enter <= leave ? enter : kMiss;
}

RayHit RayTree::intersect(const Ray& ray, int triangle) const {
    // Moeller and Trumbore 1997.
    const Triangle& t = mesh_.triangle(triangle);
    const Vec3& a = mesh_.restPosition(t[0]);
    const Vec3 e1 = mesh_.restPosition(t[1]) - a;
    const Vec3 e2 = mesh_.restPosition(t[2]) - a;
    const Vec3 p = ray.direction.cross(e2);
    const double determinant = e1.dot(p);
    const double scale = e1.cross(e2).norm() * ray.direction.norm();
    if (std::abs(determinant) <= kLeastCosine * scale) {
        return {};
    }
    const Vec3 s = ray.origin - a;
    const Vec3 q = s.cross(e1);
    const double b1 = s.dot(p) / determinant;
    const double b2 = ray.direction.dot(q) / determinant;
    if (b1 < -kBorder || b2 < -kBorder || b1 + b2 > 1 + kBorder) {
        return {};
    }
    return {triangle, e2.dot(q) / determinant, b1, b2};
}

bool RayTree::facesAway(int triangle, const Vec3& direction) const {
    const Triangle& t = mesh_.triangle(triangle);
    const Vec3& a = mesh_.restPosition(t[0]);
    return (mesh_.restPosition(t[1]) - a).cross(mesh_.restPosition(t[2]) - a).dot(direction) > 0;
}

bool RayTree::crosses(const Vec3& from, const Vec3& to) const {
    const Ray ray(from, to - from);
    double farthest = 1;
    bool crossed = false;
    traverse(ray, farthest, [&](int slot) {
        const RayHit hit = intersect(ray, slot);
        if (hit.triangle >= 0 && hit.distance > 0 && hit.distance < 1) {
            crossed = true;
            farthest = -1;
        }
    });
    return crossed;
}

}  // namespace kerf
