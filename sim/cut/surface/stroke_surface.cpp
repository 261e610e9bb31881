#include "sim/cut/surface/stroke_surface.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "sim/base/boxes.h"
#include "sim/base/sort_unique.h"
#include "sim/mesh/closest_point.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

constexpr double kKeptDepth = 0.5;  // of the depth at rest

Vec3 mixed(const Vec3& weights, const Vec3& a, const Vec3& b, const Vec3& c) {
    return weights[0] * a + weights[1] * b + weights[2] * c;
}

bool isNear(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, double reach) {
    return ((a.cwiseMin(b).cwiseMin(c) - p).array() <= reach).all() &&
           ((p - a.cwiseMax(b).cwiseMax(c)).array() <= reach).all();
}

}  // namespace

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
