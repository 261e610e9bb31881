#include "sim/cut/broad_phase.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace kerf::cut {

namespace {

constexpr int kMostBins = 4096;
constexpr double kRotationRounding = 1e-6;  // of the bins: what turning into the frame may move

}  // namespace

Eigen::Matrix3d sweepAxes(const Blade& blade, const std::vector<Vec3>& points) {
    const Vec3 along = (blade.b - blade.a).normalized();
    Vec3 sweep = Vec3::Zero();
    for (const Vec3& p : points) {
        const Vec3 fromBlade = p - blade.a;
        const Vec3 aside = fromBlade - along * along.dot(fromBlade);
        if (aside.squaredNorm() > sweep.squaredNorm()) {
            sweep = aside;
        }
    }
    sweep = sweep.squaredNorm() > 0 ? sweep.normalized() : along.unitOrthogonal();
    Eigen::Matrix3d axes;
    axes.col(0) = along;
    axes.col(1) = sweep;
    axes.col(2) = along.cross(sweep);
    return axes;
}

BroadPhase::BroadPhase(const SurfaceMesh& mesh, TriangleFinder& finder, const Blade& blade,
                       const std::vector<Vec3>& points, double margin, double binSize,
                       const std::function<bool(int)>& counts)
    : frame_(sweepAxes(blade, points).transpose()) {
    for (const Vec3& p : points) {
        box_.add(toFrame(p));
    }
    box_.widen(margin);
    binSize_ = std::max(binSize, (box_.high.x() - box_.low.x()) / kMostBins);
    bins_.resize(binOf(box_.high.x()) + 1);
    OrientedBox reach = orientedBoxAlong(frame_.transpose(), points);
    reach.widen(margin + kRotationRounding * binSize_);
    for (const int t : finder.near(reach)) {
        if (counts(t)) {
            add(mesh, t);
        }
    }
}

void BroadPhase::add(const SurfaceMesh& mesh, int triangle) {
    Bounds bounds;
    for (const int v : mesh.triangle(triangle)) {
        bounds.add(toFrame(mesh.position(v)));
    }
    if (!bounds.overlaps(box_)) {
        return;
    }
    for (int bin = binOf(bounds.low.x()); bin <= binOf(bounds.high.x()); ++bin) {
        bins_[bin].push_back(static_cast<int>(entries_.size()));
    }
    entries_.push_back({triangle, bounds});
}

int BroadPhase::binOf(double x) const {
    const double inside = std::clamp(x, box_.low.x(), box_.high.x());
    return static_cast<int>((inside - box_.low.x()) / binSize_);
}

std::vector<int> BroadPhase::query(const Vec3& a, const Vec3& b, const Vec3& c, double pad) const {
    Bounds bounds;
    for (const Vec3& p : {a, b, c}) {
        bounds.add(toFrame(p));
    }
    bounds.widen(pad + kRotationRounding * binSize_);
    std::vector<int> found;
    for (int bin = binOf(bounds.low.x()); bin <= binOf(bounds.high.x()); ++bin) {
        for (const int entry : bins_[bin]) {
            if (entries_[entry].bounds.overlaps(bounds)) {
                found.push_back(entries_[entry].triangle);
            }
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace kerf::cut
