#include "sim/body/ispc_builder.h"

#include "sim/base/math.h"
#include "sim/body/rest_geometry.h"
#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

constexpr double kLeastCosine = 1e-6;  // rays closer to a triangle's plane miss it

constexpr double kLeastFlatness = 0.3;  // below: a slit front, whose normal means nothing
constexpr double kLeastLength = 1e-3;   // of the mean edge
constexpr double kLeastArea = 1e-3;     // of the squared mean edge

// Squared sines of the angles between turned rays and the normal. From 0 to 1 rays would cross a
// body evenly in all directions (Crofton's formula). The steepest are left out, since rays from
// both ends would add up along the normal, and the flattest, which edges would lose.
constexpr double kLeastTurn = 0.15;
constexpr double kMostTurn = 0.9;
// Fractions of the plastic number: a vertex's turns lie far from those of the vertices before it.
constexpr double kTurnStep = 0.7548776662466927;
constexpr double kWayStep = 0.5698402909980532;
constexpr double kLeastSlope = 0.05;  // of a ray against each triangle around its vertex
constexpr int kMostHalvings = 2;      // of the angle of a ray that would leave the body

bool touches(const Triangle& triangle, int vertex) {
    return std::ranges::find(triangle, vertex) != triangle.end();
}

}  // namespace

RayTree::RayTree(const SurfaceMesh& mesh, std::span<const int> triangles)
    : mesh_(mesh), tree_(triangles, [this](int t) { return boundsOf(t); }) {}

void RayTree::update(std::span<const int> triangles) {
    tree_.erase(triangles);
    std::vector<int> alive;
    std::ranges::copy_if(triangles, std::back_inserter(alive),
                         [this](int t) { return mesh_.alive(t); });
    tree_.insert(alive, [this](int t) { return boundsOf(t); });
}

Bounds RayTree::boundsOf(int triangle) const {
    const Bounds box = boxOf(restCornersOf(mesh_, triangle));
    return widened(box, 4 * kHitBorder * box.diagonal());
}

RayHit RayTree::intersect(const BoxRay& ray, int triangle) const {
    const std::optional<LineHit> hit =
        hitOf(restCornersOf(mesh_, triangle), ray.origin, ray.direction, kLeastCosine);
    return hit ? RayHit{triangle, hit->distance, hit->b1, hit->b2} : RayHit{};
}

bool RayTree::facesAway(int triangle, const Vec3& direction) const {
    return areaNormal(restCornersOf(mesh_, triangle)).dot(direction) > 0;
}

bool RayTree::crosses(const Vec3& from, const Vec3& to) const {
    const BoxRay ray(from, to - from);
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

IspcCaster::IspcCaster(const SurfaceMesh& mesh, const RayTree& tree,
                       const std::vector<int>& pieceOfVertex, double edgeLength, IspcRays rays)
    : mesh_(mesh),
      tree_(tree),
      pieceOfVertex_(pieceOfVertex),
      edgeLength_(edgeLength),
      rays_(rays) {}

bool IspcCaster::pointsInside(int vertex, const Vec3& direction) const {
    bool inside = true;
    mesh_.forEachOutgoing(vertex, [&](int h) {
        const Vec3 normal = areaNormal(restCornersOf(mesh_, h / 3));
        inside = inside && normal.dot(direction) < -kLeastSlope * normal.norm();
    });
    return inside;
}

/// Less turned where it would leave the body at once, as beside a sharp edge.
Vec3 IspcCaster::direction(int vertex, int ray, const Vec3& inwards) const {
    if (rays_ == IspcRays::alongNormal) {
        return inwards;
    }
    const auto fraction = [](double x) { return x - std::floor(x); };
    const double part = fraction(0.5 + vertex * kTurnStep);
    const double way = fraction(0.5 + vertex * kWayStep);
    const int count = raysPerVertex(rays_);
    const double turn = kLeastTurn + (kMostTurn - kLeastTurn) * (ray + part) / count;
    const double around = 2 * std::numbers::pi * (way + static_cast<double>(ray) / count);
    const Vec3 axis = std::abs(inwards.x()) < 0.6 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    const Vec3 u = axis.cross(inwards).normalized();
    const Vec3 aside = std::cos(around) * u + std::sin(around) * inwards.cross(u);
    double angle = std::asin(std::sqrt(turn));
    for (int halvings = 0; halvings <= kMostHalvings; ++halvings, angle /= 2) {
        Vec3 turned = std::cos(angle) * inwards + std::sin(angle) * aside;
        if (pointsInside(vertex, turned)) {
            return turned;
        }
    }
    return inwards;
}

std::optional<CastIspc> IspcCaster::cast(int vertex, int ray, double vertexArea) const {
    const int piece = pieceOfVertex_[vertex];
    if (piece < 0) {
        return std::nullopt;
    }
    const VertexNormal normal = restNormal(mesh_, vertex);
    if (normal.flatness < kLeastFlatness) {
        return std::nullopt;
    }
    const RayHit hit = tree_.castToBackFace(
        mesh_.restPosition(vertex), direction(vertex, ray, -normal.direction),
        kLeastLength * edgeLength_, [&](int slot) {
            const Triangle& t = mesh_.triangle(slot);
            const bool inTheWay = pieceOfVertex_[t[0]] == piece || mesh_.absent(slot);
            return inTheWay && !touches(t, vertex);
        });
    if (hit.triangle < 0) {
        return std::nullopt;
    }
    const double area = std::max(vertexArea, kLeastArea * edgeLength_ * edgeLength_);
    const Triangle& t = mesh_.triangle(hit.triangle);
    return CastIspc{
        {static_cast<std::uint32_t>(vertex), static_cast<std::uint32_t>(t[0]),
         static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2]),
         static_cast<float>(hit.b1), static_cast<float>(hit.b2), static_cast<float>(hit.distance),
         static_cast<float>(2 * raysPerVertex(rays_) * hit.distance / area)},
        hit.triangle};
}

Vec3 restEnd(const SurfaceMesh& mesh, const shared::IspcConstraint& c) {
    const double b1 = c.b1;
    const double b2 = c.b2;
    return (1 - b1 - b2) * mesh.restPosition(static_cast<int>(c.t0)) +
           b1 * mesh.restPosition(static_cast<int>(c.t1)) +
           b2 * mesh.restPosition(static_cast<int>(c.t2));
}

}  // namespace kerf
