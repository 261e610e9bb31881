#include "app/scene/readout/cut_preview.h"

#include <Eigen/Geometry>

#include "sim/base/containers.h"
#include "sim/base/math.h"
#include "sim/mesh/triangle.h"

namespace kerf::app {
namespace {

constexpr double kParallel = 1e-14;  // of squared areas
constexpr double kOnEdge = 1e-9;     // of squared areas: no ray slips between two triangles
constexpr double kHair = 1e-6;       // half the width of the box about a ray, of its length
const Vec3 kAside{0.61e-4, 0.35e-4, 0.71e-4};  // of the blade's length

/// The part of a line, from the shares `low` to `high` of it.
struct Part {
    double low = -1e300;
    double high = 1e300;
    bool empty() const { return low >= high; }
};

/// The part of the line p + t d inside the triangle, all in one plane.
Part partInside(const Corners& c, const Vec3& normal, const Vec3& p, const Vec3& d) {
    Part part;
    for (int e = 0; e < 3; ++e) {
        const Vec3 inward = normal.cross(c[(e + 1) % 3] - c[e]);
        const double at = inward.dot(p - c[e]);
        const double along = inward.dot(d);
        if (along > 0) {
            part.low = std::max(part.low, -at / along);
        } else if (along < 0) {
            part.high = std::min(part.high, -at / along);
        } else if (at < 0) {
            return {1, 0};
        }
    }
    return part;
}

/// Where two triangles pass through each other.
std::optional<std::array<Vec3, 2>> intersect(const Corners& a, const Corners& b) {
    const Vec3 na = areaNormal(a);
    const Vec3 nb = areaNormal(b);
    const Vec3 d = na.cross(nb);
    const double dd = d.squaredNorm();
    if (dd <= kParallel * na.squaredNorm() * nb.squaredNorm()) {
        return std::nullopt;
    }
    const Vec3 p = (na.dot(a[0]) * nb.cross(d) + nb.dot(b[0]) * d.cross(na)) / dd;
    const Part inA = partInside(a, na, p, d);
    const Part inB = partInside(b, nb, p, d);
    const Part both{std::max(inA.low, inB.low), std::min(inA.high, inB.high)};
    if (inA.empty() || inB.empty() || both.empty()) {
        return std::nullopt;
    }
    return std::array<Vec3, 2>{p + both.low * d, p + both.high * d};
}

/// The two triangles of each step of the way, with their boxes.
struct PathStrip {
    std::vector<Corners> faces;
    std::vector<Bounds> boxes;
    Bounds box;

    explicit PathStrip(std::span<const Blade> way) {
        // A little beside, or a way along edges of the mesh would be met by chance alone.
        const Vec3 aside =
            way.empty() ? Vec3(Vec3::Zero()) : Vec3(kAside * (way[0].b - way[0].a).norm());
        for (std::size_t i = 1; i < way.size(); ++i) {
            add({way[i - 1].a + aside, way[i - 1].b + aside, way[i].b + aside});
            add({way[i - 1].a + aside, way[i].b + aside, way[i].a + aside});
        }
    }
    void add(const Corners& face) {
        faces.push_back(face);
        boxes.push_back(boxOf(face));
        box.add(boxes.back());
    }
};

/// Of the triangles around a vertex that are of the same kind.
Vec3 vertexNormal(const SurfaceMesh& mesh, int vertex, SurfaceKind kind) {
    Vec3 sum = Vec3::Zero();
    mesh.forEachOutgoing(vertex, [&](int h) {
        if (mesh.kind(h / 3) == kind) {
            sum += areaNormal(cornersOf(mesh, h / 3));
        }
    });
    return sum.norm() > 0 ? Vec3(sum.normalized()) : sum;
}

/// Shares of the corners at the point where the ray meets the triangle from its front.
std::optional<Vec3> meet(const Corners& c, const Vec3& origin, const Vec3& direction,
                         double& distance) {
    const Vec3 normal = areaNormal(c);
    const double facing = normal.dot(direction);
    if (facing >= 0) {
        return std::nullopt;
    }
    const double at = normal.dot(c[0] - origin) / facing;
    const Vec3 p = origin + at * direction;
    Vec3 shares;
    for (int k = 0; k < 3; ++k) {
        shares[k] = areaNormal(p, c[(k + 1) % 3], c[(k + 2) % 3]).dot(normal);
    }
    if (at <= 0 || at >= distance || shares.minCoeff() < -kOnEdge * normal.squaredNorm()) {
        return std::nullopt;
    }
    distance = at;
    return shares / shares.sum();
}

}  // namespace

void bringAround(const SurfaceMesh& mesh, int triangle) {
    std::vector<int> vertices;
    for (const int v : mesh.triangle(triangle)) {
        mesh.forEachOutgoing(v, [&](int h) { vertices.push_back(mesh.target(h)); });
    }
    sortUnique(vertices);
    mesh.bring(vertices);
}

OrientedBox boxAbout(std::span<const Blade> way) {
    std::vector<Vec3> points;
    for (const Blade& blade : way) {
        points.insert(points.end(), {blade.a, blade.b});
    }
    OrientedBox box = orientedBoxOf(points);
    box.widen(2 * kAside.norm() * (way[0].b - way[0].a).norm());
    return box;
}

CutPreview previewCut(const SurfaceMesh& mesh, std::span<const int> triangles,
                      std::span<const Blade> way) {
    const PathStrip strip(way);
    CutPreview preview;
    for (const int t : triangles) {
        if (!mesh.present(t)) {
            continue;
        }
        const Corners corners = cornersOf(mesh, t);
        const Bounds box = boxOf(corners);
        if (!box.overlaps(strip.box)) {
            continue;
        }
        const std::size_t before = preview.wound.size();
        for (std::size_t i = 0; i < strip.faces.size(); ++i) {
            if (box.overlaps(strip.boxes[i])) {
                if (const auto line = intersect(corners, strip.faces[i])) {
                    preview.wound.push_back(*line);
                }
            }
        }
        if (preview.wound.size() > before) {
            preview.touched.push_back(t);
        }
    }
    return preview;
}

std::optional<SurfacePoint> pickSurface(const SurfaceMesh& mesh, std::span<const int> triangles,
                                        const render::Ray& ray) {
    SurfacePoint best;
    Vec3 shares = Vec3::Zero();
    double distance = 1e300;
    for (const int t : triangles) {
        if (!mesh.present(t)) {
            continue;
        }
        if (const auto hit = meet(cornersOf(mesh, t), ray.origin, ray.direction, distance)) {
            best.triangle = t;
            shares = *hit;
        }
    }
    if (best.triangle < 0) {
        return std::nullopt;
    }
    best.position = ray.origin + distance * ray.direction;
    bringAround(mesh, best.triangle);
    Vec3 normal = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        normal += shares[k] *
                  vertexNormal(mesh, mesh.triangle(best.triangle)[k], mesh.kind(best.triangle));
    }
    best.normal = normal.norm() > 0 ? Vec3(normal.normalized())
                                    : Vec3(areaNormal(cornersOf(mesh, best.triangle)).normalized());
    return best;
}

OrientedBox boxAbout(const render::Ray& ray, const Bounds& bounds) {
    const double reach = bounds.diagonal() + (bounds.center() - ray.origin).norm();
    OrientedBox box;
    box.axes.col(0) = ray.direction;
    box.axes.col(1) = ray.direction.unitOrthogonal();
    box.axes.col(2) = ray.direction.cross(box.axes.col(1));
    box.center = ray.origin + 0.5 * reach * ray.direction;
    box.half = Vec3(0.5 * reach, 0, 0);
    box.widen(kHair * reach);
    return box;
}

}  // namespace kerf::app
