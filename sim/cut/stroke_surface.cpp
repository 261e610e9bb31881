#include "sim/cut/stroke_surface.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "sim/mesh/closest_point.h"

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

StrokeSurface::StrokeSurface(const SurfaceMesh& mesh) : vertexCount_(mesh.vertexCount()) {
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (mesh.alive(t)) {
            parts_.push_back({mesh.triangle(t), mesh.wallLabel(t)});
        }
    }
    for (int v = 0; v < vertexCount_; ++v) {
        if (mesh.outgoing(v) >= 0) {
            vertices_.push_back(v);
        }
    }
}

// A clean-up may have taken a corner away; what is left of it moves no more.
bool StrokeSurface::isWhole(const SurfaceMesh& mesh, const Triangle& corners) {
    return std::all_of(corners.begin(), corners.end(),
                       [&](int v) { return mesh.outgoing(v) >= 0; });
}

// The two walls of an older slit rest at the same place.
bool StrokeSurface::isBeside(const SurfaceMesh& mesh, int v, int wallLabel) const {
    bool beside = false;
    mesh.forEachOutgoing(v, [&](int h) { beside |= mesh.wallLabel(h / 3) == wallLabel; });
    return beside;
}

std::optional<Vec3> StrokeSurface::flatPosition(const SurfaceMesh& mesh, int v,
                                                double reach) const {
    if (v < vertexCount_) {
        return std::nullopt;
    }
    const Vec3& rest = mesh.restPosition(v);
    std::optional<Vec3> nearest;
    double least = reach;
    for (const Part& part : parts_) {
        const Triangle& t = part.corners;
        const Vec3& a = mesh.restPosition(t[0]);
        const Vec3& b = mesh.restPosition(t[1]);
        const Vec3& c = mesh.restPosition(t[2]);
        if (!isNear(rest, a, b, c, least) || !isWhole(mesh, t) ||
            !isBeside(mesh, v, part.wallLabel)) {
            continue;
        }
        const Vec3 weights = closestWeights(rest, a, b, c);
        const double distance = (mixed(weights, a, b, c) - rest).norm();
        if (distance <= least) {
            least = distance;
            nearest = mixed(weights, mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
        }
    }
    return nearest;
}

std::optional<Vec3> StrokeSurface::insidePosition(const SurfaceMesh& mesh, int v,
                                                  double reach) const {
    const Vec3& rest = mesh.restPosition(v);
    double depth = reach;
    std::optional<Vec3> onSurface;
    Vec3 outward = Vec3::Zero();
    for (const Part& part : parts_) {
        const Triangle& t = part.corners;
        const Vec3& a = mesh.restPosition(t[0]);
        const Vec3& b = mesh.restPosition(t[1]);
        const Vec3& c = mesh.restPosition(t[2]);
        // The far side of a thin part, or the other wall of an older slit, faces the other way.
        if (!isNear(rest, a, b, c, depth) || !isWhole(mesh, t) ||
            (b - a).cross(c - a).dot(rest - a) >= 0) {
            continue;
        }
        const Vec3 weights = closestWeights(rest, a, b, c);
        const double distance = (mixed(weights, a, b, c) - rest).norm();
        if (distance < depth) {
            depth = distance;
            const Vec3& p = mesh.position(t[0]);
            const Vec3& q = mesh.position(t[1]);
            const Vec3& r = mesh.position(t[2]);
            onSurface = mixed(weights, p, q, r);
            outward = (q - p).cross(r - p).stableNormalized();
        }
    }
    if (!onSurface) {
        return std::nullopt;
    }
    const double excess = outward.dot(mesh.position(v) - *onSurface) + kKeptDepth * depth;
    return excess > 0 ? std::optional(Vec3(mesh.position(v) - excess * outward)) : std::nullopt;
}

}  // namespace kerf::cut
