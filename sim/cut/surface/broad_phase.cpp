#include "sim/cut/surface/broad_phase.h"

#include <Eigen/Geometry>

#include "sim/base/math.h"
#include "sim/base/stopwatch.h"

namespace kerf::cut {

namespace {

/// One search for the triangles near a strip.
struct CandidateSearch {
    const SurfaceMesh& mesh;  ///< the body
    TriangleFinder& finder;   ///< for CutSearch::tree
    CutSearch way;            ///< how to search
    OrientedBox reach;        ///< no triangle outside it is near
    /// Whether a triangle is near. Called once for each; must store those that are.
    std::function<bool(int)> isNear;
};

long askFinder(const CandidateSearch& search) {
    const std::vector<int> near = search.finder.near(search.reach);
    for (const int t : near) {
        search.isNear(t);
    }
    return static_cast<long>(near.size());
}

long askAll(const CandidateSearch& search) {
    const std::vector<int> living = livingTriangles(search.mesh);
    for (const int t : living) {
        search.isNear(t);
    }
    return static_cast<long>(living.size());
}

/// The paper's search over adjacent triangles.
class Walk {
  public:
    explicit Walk(const CandidateSearch& search)
        : search_(search), visited_(static_cast<std::size_t>(search.mesh.triangleSlots())) {}

    SearchWork run() {
        const Stopwatch watch;
        for (int t = 0; t < search_.mesh.triangleSlots(); ++t) {
            if (search_.mesh.alive(t) && visit(t)) {
                walkFrom(t);
                if (++work_.seeds == 1) {
                    work_.walkMilliseconds = watch.milliseconds();
                }
            }
        }
        return work_;
    }

  private:
    /// Whether a triangle is met now, and near.
    bool visit(int t) {
        if (visited_[t]) {
            return false;
        }
        visited_[t] = true;
        ++work_.tests;
        return search_.isNear(t);
    }

    void walkFrom(int seed) {
        std::vector<int> toTraverse{seed};
        while (!toTraverse.empty()) {
            const int t = toTraverse.back();
            toTraverse.pop_back();
            for (const int twin : search_.mesh.twins(t)) {
                if (const int neighbour = SurfaceMesh::triangleOf(twin); visit(neighbour)) {
                    toTraverse.push_back(neighbour);
                }
            }
        }
    }

    const CandidateSearch& search_;
    std::vector<bool> visited_;
    SearchWork work_;
};

SearchWork searchBy(const CandidateSearch& search) {
    SearchWork work;
    switch (search.way) {
        case CutSearch::tree:
            work.tests = askFinder(search);
            break;
        case CutSearch::adjacency:
            work = Walk(search).run();
            break;
        case CutSearch::all:
            work.tests = askAll(search);
            break;
    }
    return work;
}

/// Calls isNear until all near triangles have been found, in an order that depends on the search.
/// The walk is the paper's algorithm A1 from its first seed on. That misses groups without a seed,
/// such as a second arm: so the list of triangles is scanned to its end for more seeds. O(n) except
/// for CutSearch::tree.
SearchWork searchCandidates(const CandidateSearch& search) {
    const Stopwatch watch;
    SearchWork work = searchBy(search);
    work.milliseconds = watch.milliseconds();
    return work;
}

constexpr int kMostBins = 4096;
constexpr double kRotationRounding = 1e-6;  // of the bins: what turning into the frame may move
// Of a bin: what is taken around the strip at first. Older slits are looked for within 0.1, the
// walls of a stroke's own past within 0.25.
constexpr double kFirstMargin = 0.3;

// Whether two boxes overlap, as overlaps() says. Along the strip most boxes of a bin are told
// apart.
bool meet(const Bounds& a, const Bounds& b) {
    return a.low.y() <= b.high.y() && b.low.y() <= a.high.y() && a.low.x() <= b.high.x() &&
           b.low.x() <= a.high.x() && a.low.z() <= b.high.z() && b.low.z() <= a.high.z();
}

}  // namespace

Eigen::Matrix3d sweptAxes(const Blade& blade, const std::vector<Vec3>& points) {
    const Vec3 along = (blade.b - blade.a).normalized();
    Vec3 farthest = Vec3::Zero();
    for (const Vec3& p : points) {
        const Vec3 fromBlade = p - blade.a;
        const Vec3 aside = fromBlade - along * along.dot(fromBlade);
        if (aside.squaredNorm() > farthest.squaredNorm()) {
            farthest = aside;
        }
    }
    farthest = farthest.squaredNorm() > 0 ? farthest.normalized() : along.unitOrthogonal();
    Eigen::Matrix3d axes;
    axes.col(0) = along;
    axes.col(1) = farthest;
    axes.col(2) = along.cross(farthest);
    return axes;
}

BroadPhase::BroadPhase(const SurfaceMesh& mesh, TriangleFinder& finder, const Blade& blade,
                       const std::vector<Vec3>& points, double margin, double binSize,
                       std::function<bool(int)> counts, SearchOrder order)
    : mesh_(mesh),
      finder_(finder),
      counts_(std::move(counts)),
      order_(order),
      frame_(sweptAxes(blade, points).transpose()),
      points_(points),
      margin_(margin),
      leastBinSize_(binSize) {
    take(std::min(margin, kFirstMargin * binSize));
}

/// Everything within `margin` of the strip, in place of what was taken before.
void BroadPhase::take(double margin) const {
    tookAll_ = margin >= margin_;
    box_ = boxOf(points_, [this](const Vec3& p) { return toFrame(p); });
    box_.widen(margin);
    binSize_ = std::max(leastBinSize_, (box_.high.x() - box_.low.x()) / kMostBins);
    OrientedBox reach = orientedBoxAlong(frame_.transpose(), points_);
    reach.widen(margin + kRotationRounding * binSize_);
    entries_.clear();
    const SearchWork work = searchCandidates(
        {mesh_, finder_, order_.way, reach, [this](int t) { return counts_(t) && add(t); }});
    if (order_.work != nullptr) {
        order_.work->add(work);
    }
    if (order_.way == CutSearch::adjacency) {
        std::ranges::sort(entries_, {}, &Entry::triangle);
    }
    std::vector<int> all(entries_.size());
    std::iota(all.begin(), all.end(), 0);
    bins_ = binsOf(all);
}

/// Whether the triangle is near.
bool BroadPhase::add(int triangle) const {
    const Bounds bounds =
        boxOf(mesh_.triangle(triangle), [this](int v) { return toFrame(mesh_.position(v)); });
    const bool near = bounds.overlaps(box_);
    if (near) {
        entries_.push_back({triangle, bounds, binOf(bounds.low.x())});
    }
    return near;
}

BroadPhase::Bins BroadPhase::binsOf(std::span<const int> places) const {
    Bins bins;
    bins.first.assign(binOf(box_.high.x()) + 2, 0);
    const auto forEachBin = [this](const Entry& entry, auto&& visit) {
        for (int bin = entry.firstBin; bin <= binOf(entry.bounds.high.x()); ++bin) {
            visit(bin);
        }
    };
    for (const int place : places) {
        forEachBin(entries_[place], [&](int bin) { ++bins.first[bin + 1]; });
    }
    std::partial_sum(bins.first.begin(), bins.first.end(), bins.first.begin());
    bins.places.resize(bins.first.back());
    std::vector<int> next(bins.first.begin(), bins.first.end() - 1);
    for (const int place : places) {
        forEachBin(entries_[place], [&](int bin) { bins.places[next[bin]++] = place; });
    }
    return bins;
}

int BroadPhase::binOf(double x) const {
    const double inside = std::clamp(x, box_.low.x(), box_.high.x());
    return static_cast<int>((inside - box_.low.x()) / binSize_);
}

/// What meets `bounds` is among the entries then, as far as it is within the margin.
void BroadPhase::require(const Bounds& bounds) const {
    const bool inside = (bounds.low.array() >= box_.low.array()).all() &&
                        (bounds.high.array() <= box_.high.array()).all();
    if (!inside && !tookAll_) {
        take(margin_);
    }
}

std::vector<int> BroadPhase::cover(std::span<const Vec3> points, double pad) const {
    const Bounds bounds = reachOf(points, pad);
    require(bounds);
    std::vector<int> places;
    places.reserve(entries_.size());
    for (int i = 0; i < static_cast<int>(entries_.size()); ++i) {
        if (meet(entries_[i].bounds, bounds)) {
            places.push_back(i);
        }
    }
    return places;
}

Bounds BroadPhase::reachOf(std::span<const Vec3> points, double pad) const {
    return widened(boxOf(points, [this](const Vec3& p) { return toFrame(p); }), pad);
}

Bounds BroadPhase::widened(Bounds box, double pad) const {
    box.widen(pad + kRotationRounding * binSize_);
    return box;
}

void BroadPhase::findIn(const Bounds& bounds, const Bins& bins, std::vector<int>& found) const {
    found.clear();
    const int first = binOf(bounds.low.x());
    const int last = binOf(bounds.high.x());
    for (int bin = first; bin <= last; ++bin) {
        for (int i = bins.first[bin]; i < bins.first[bin + 1]; ++i) {
            const Entry& entry = entries_[bins.places[i]];
            if (bin == std::max(first, entry.firstBin) && meet(entry.bounds, bounds)) {
                found.push_back(bins.places[i]);
            }
        }
    }
    std::ranges::sort(found);
}

void BroadPhase::findEntries(const Bounds& box, double pad, const Bins& bins,
                             std::vector<int>& found) const {
    findIn(widened(box, pad), bins, found);
}

std::vector<int> BroadPhase::query(const Vec3& a, const Vec3& b, const Vec3& c, double pad) const {
    std::vector<int> found;
    const Bounds bounds = reachOf(std::array{a, b, c}, pad);
    require(bounds);
    findIn(bounds, bins_, found);
    for (int& place : found) {
        place = entries_[place].triangle;
    }
    return found;
}

}  // namespace kerf::cut
