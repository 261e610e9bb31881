#include "sim/cut/surface/stroke_surface.h"

#include "sim/base/containers.h"
#include "sim/base/math.h"
#include "sim/mesh/triangle.h"

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

constexpr double kKeptDepth = 0.5;  // of the depth at rest

Vec3 mixed(const Vec3& weights, const Vec3& a, const Vec3& b, const Vec3& c) {
    return weights[0] * a + weights[1] * b + weights[2] * c;
}

bool isNear(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, double reach) {
    return ((a.cwiseMin(b).cwiseMin(c) - p).array() <= reach).all() &&
           ((p - a.cwiseMax(b).cwiseMax(c)).array() <= reach).all();
}

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

StrokeSurface::StrokeSurface(const SurfaceMesh& mesh)
    : mesh_(mesh), vertexCount_(mesh.vertexCount()), triangles_(mesh.triangleSlots()) {
    for (const int t : livingTriangles(mesh)) {
        triangles_[t] = {mesh.triangle(t), mesh.wallLabel(t)};
    }
}

BoxTree& StrokeSurface::tree() const {
    if (!tree_) {
        std::vector<int> living;
        for (int slot = 0; slot < static_cast<int>(triangles_.size()); ++slot) {
            if (triangles_[slot].corners[0] >= 0) {
                living.push_back(slot);
            }
        }
        tree_.emplace(living, [this](int slot) { return restBounds(slot); });
        tree_->prepareToEdit();
    }
    return *tree_;
}

void StrokeSurface::prepare() {
    tree().divideAll();
}

void StrokeSurface::beginStroke() {
    std::vector<int> changed = std::exchange(changed_, {});
    sortUnique(changed);
    triangles_.resize(mesh_.triangleSlots());
    for (const int t : changed) {
        triangles_[t] = mesh_.alive(t) ? FormerTriangle{mesh_.triangle(t), mesh_.wallLabel(t)}
                                       : FormerTriangle{};
    }
    if (tree_) {
        tree_->erase(changed);
        std::erase_if(changed, [this](int t) { return !mesh_.alive(t); });
        tree_->insert(changed, [this](int slot) { return restBounds(slot); });
    }
    vertexCount_ = mesh_.vertexCount();
    thinned_ = {};
}

void StrokeSurface::follow(std::span<const int> triangles, double restMotion) {
    changed_.insert(changed_.end(), triangles.begin(), triangles.end());
    if (tree_) {
        tree_->moved(restMotion);
    }
}

Bounds StrokeSurface::restBounds(int slot) const {
    return boxOf(triangles_[slot].corners, [this](int v) { return mesh_.restPosition(v); });
}

/// Ascending.
std::vector<int> StrokeSurface::trianglesNear(const Vec3& rest, double reach) const {
    const Bounds around = widened(Bounds{rest, rest}, reach);
    std::vector<int> found;
    tree().find([this](int slot) { return restBounds(slot); },
                [&](const Bounds& box) { return box.overlaps(around); },
                [&](int slot) { found.push_back(slot); });
    std::sort(found.begin(), found.end());
    return found;
}

bool StrokeSurface::Thinned::covers(const std::vector<Vec3>& places) const {
    return std::ranges::all_of(places, [this](const Vec3& p) {
        return std::ranges::any_of(boxes, [&](const Bounds& box) { return box.overlaps({p, p}); });
    });
}

std::vector<SurfaceSample> StrokeSurface::samplesAround(std::vector<Vec3> restPlaces,
                                                        double edge) const {
    if (edge != thinned_.edge || !thinned_.covers(restPlaces)) {
        thinned_.edge = edge;
        thinned_.boxes = boxesAround(std::move(restPlaces), edge);
        slots_.resize(mesh_.vertexCount(), -1);
        thinned_.samples = thinByDistance(
            tree(), [this](int slot) -> const Triangle& { return triangles_[slot].corners; },
            thinned_.boxes, edge, slots_);
    }
    std::vector<SurfaceSample> used;
    std::ranges::copy_if(
        thinned_.samples, std::back_inserter(used),
        [this](const SurfaceSample& sample) { return mesh_.outgoing(sample.vertex) >= 0; });
    std::vector<int> vertices;
    addVertices(vertices);
    mesh_.bring(vertices);
    return used;
}

void StrokeSurface::addVertices(std::vector<int>& vertices) const {
    for (const SurfaceSample& sample : thinned_.samples) {
        if (mesh_.outgoing(sample.vertex) >= 0) {
            vertices.push_back(sample.vertex);
        }
    }
}

// A clean-up may have taken a corner away; what is left of it moves no more.
bool StrokeSurface::isWhole(const Triangle& corners) const {
    return std::all_of(corners.begin(), corners.end(),
                       [&](int v) { return mesh_.outgoing(v) >= 0; });
}

// The two walls of an older slit rest at the same place.
bool StrokeSurface::isBeside(int v, int wallLabel) const {
    bool beside = false;
    mesh_.forEachOutgoing(v, [&](int h) { beside |= mesh_.wallLabel(h / 3) == wallLabel; });
    return beside;
}

std::optional<Vec3> StrokeSurface::flatPosition(int v, double reach) const {
    if (v < vertexCount_) {
        return std::nullopt;
    }
    const Vec3& rest = mesh_.restPosition(v);
    std::optional<Vec3> nearest;
    double least = reach;
    for (const int id : trianglesNear(rest, reach)) {
        const Triangle& t = triangles_[id].corners;
        const Vec3& a = mesh_.restPosition(t[0]);
        const Vec3& b = mesh_.restPosition(t[1]);
        const Vec3& c = mesh_.restPosition(t[2]);
        if (!isNear(rest, a, b, c, least) || !isWhole(t) ||
            !isBeside(v, triangles_[id].wallLabel)) {
            continue;
        }
        const Vec3 weights = closestWeights(rest, a, b, c);
        const double distance = (mixed(weights, a, b, c) - rest).norm();
        if (distance <= least) {
            least = distance;
            nearest =
                mixed(weights, mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2]));
        }
    }
    return nearest;
}

std::optional<Vec3> StrokeSurface::insidePosition(const Vec3& rest, const Vec3& position,
                                                  double reach) const {
    double depth = reach;
    std::optional<Vec3> onSurface;
    Vec3 outward = Vec3::Zero();
    for (const int id : trianglesNear(rest, reach)) {
        const Triangle& t = triangles_[id].corners;
        const Vec3& a = mesh_.restPosition(t[0]);
        const Vec3& b = mesh_.restPosition(t[1]);
        const Vec3& c = mesh_.restPosition(t[2]);
        // The far side of a thin part, or the other wall of an older slit, faces the other way.
        if (!isNear(rest, a, b, c, depth) || !isWhole(t) ||
            areaNormal(a, b, c).dot(rest - a) >= 0) {
            continue;
        }
        const Vec3 weights = closestWeights(rest, a, b, c);
        const double distance = (mixed(weights, a, b, c) - rest).norm();
        if (distance < depth) {
            depth = distance;
            const Vec3& p = mesh_.position(t[0]);
            const Vec3& q = mesh_.position(t[1]);
            const Vec3& r = mesh_.position(t[2]);
            onSurface = mixed(weights, p, q, r);
            outward = unitNormal(p, q, r);
        }
    }
    if (!onSurface) {
        return std::nullopt;
    }
    const double excess = outward.dot(position - *onSurface) + kKeptDepth * depth;
    return excess > 0 ? std::optional(Vec3(position - excess * outward)) : std::nullopt;
}

}  // namespace kerf::cut
