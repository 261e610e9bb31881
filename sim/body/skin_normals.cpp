#include "sim/body/skin_normals.h"

#include "shaders/shared/roundness.h"
#include "sim/body/rest_geometry.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

/// Which kinds of triangles lie around a vertex.
struct Kinds {
    bool skin = false;
    bool wall = false;
};

Kinds kindsAround(const SurfaceMesh& mesh, int vertex) {
    Kinds kinds;
    mesh.forEachOutgoing(vertex, [&](int h) {
        (mesh.kind(h / 3) == SurfaceKind::skin ? kinds.skin : kinds.wall) = true;
    });
    return kinds;
}

/// A little less than drawn skin has, since the pieces about a new vertex bulge once more.
constexpr double kRoundness = 0.8 * shared::kRoundness;
constexpr double kLeastNormal = 0.01;  // of a normal that tells a bulge

/// A corner of an old triangle of the skin at rest.
struct RoundCorner {
    Vec3 position = Vec3::Zero();
    Vec3 normal = Vec3::Zero();  ///< unit; zero at hard edges, where nothing bulges
    double weight = 0;           ///< of a point in the triangle
};

/// `told`: a normal whose length is 1 + the bulge.
RoundCorner roundCorner(const Vec3& position, const Vec3& told, bool hard, double weight) {
    const double length = told.norm();
    if (hard || length <= 0) {
        return {position, Vec3::Zero(), weight};
    }
    const Vec3 normal = told / length;
    return {position + (length - 1) * normal, normal, weight};
}

/// Four times how far the middle of an edge bulges (shaders/render/rounded.glsl).
Vec3 edgeBulge(const RoundCorner& a, const RoundCorner& b) {
    if (a.normal.dot(b.normal) <= shared::kLeastAgreement) {
        return Vec3::Zero();
    }
    const Vec3 along = a.position - b.position;
    return along.dot(a.normal) * a.normal - along.dot(b.normal) * b.normal;
}

/// How far above the point with these weights the round skin lies, along `up`.
double bulgeAt(const std::array<RoundCorner, 3>& corners, const Vec3& point, const Vec3& up) {
    Vec3 chord = Vec3::Zero();
    Vec3 bulge = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        const RoundCorner& corner = corners[i];
        const RoundCorner& next = corners[(i + 1) % 3];
        chord += corner.weight * corner.position;
        bulge += kRoundness * corner.weight * next.weight * edgeBulge(corner, next);
    }
    return (chord + bulge - point).dot(up);
}

const double kHardCosine = std::cos(kHardEdgeAngle * std::numbers::pi / 180);

/// A triangle of the skin at a vertex, at rest.
struct Corner {
    Vec3 face = Vec3::Zero();  ///< unit normal; zero of walls and of triangles without area
    double angle = 0;
    int side = 0;  ///< the first of the corners that it goes on from across smooth edges
};

Corner cornerOf(const SurfaceMesh& mesh, int vertex, int h) {
    const Vec3& p = mesh.restPosition(vertex);
    const Vec3 u = mesh.restPosition(mesh.target(h)) - p;
    const Vec3 w = mesh.restPosition(mesh.apex(h)) - p;
    const Vec3 normal = u.cross(w);
    const double twiceArea = normal.norm();
    if (mesh.kind(h / 3) != SurfaceKind::skin || twiceArea <= 0) {
        return {};
    }
    return {normal / twiceArea, std::atan2(twiceArea, u.dot(w))};
}

/// In their order around the vertex.
std::vector<Corner> cornersAround(const SurfaceMesh& mesh, int vertex) {
    std::vector<Corner> corners;
    mesh.forEachOutgoing(vertex, [&](int h) { corners.push_back(cornerOf(mesh, vertex, h)); });
    return corners;
}

bool isHard(const Corner& a, const Corner& b) {
    return a.angle > 0 && b.angle > 0 && a.face.dot(b.face) < kHardCosine;
}

/// Whether any two neighbours meet at a hard edge.
bool hasHardEdge(const std::vector<Corner>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (isHard(corners[i], corners[(i + 1) % corners.size()])) {
            return true;
        }
    }
    return false;
}

/// Numbers the smooth stretches between hard edges.
void numberSides(std::vector<Corner>& corners) {
    for (std::size_t i = 1; i < corners.size(); ++i) {
        corners[i].side = corners[i - 1].side + (isHard(corners[i - 1], corners[i]) ? 1 : 0);
    }
    if (!isHard(corners.back(), corners.front())) {
        const int last = corners.back().side;
        for (Corner& corner : corners) {
            corner.side = corner.side == last ? 0 : corner.side;
        }
    }
}

}  // namespace

std::vector<SkinNormals::Side> SkinNormals::sidesAround(const SurfaceMesh& mesh, int vertex) {
    std::vector<Corner> corners = cornersAround(mesh, vertex);
    if (!hasHardEdge(corners)) {
        return {};
    }
    numberSides(corners);
    std::vector<Side> sides;
    for (const Corner& corner : corners) {
        Vec3 sum = Vec3::Zero();
        for (const Corner& other : corners) {
            sum += other.side == corner.side ? Vec3(other.angle * other.face) : Vec3::Zero();
        }
        sides.push_back({corner.face, sum.normalized()});
    }
    return sides;
}

SkinNormals::SkinNormals(const SurfaceMesh& uncut) {
    std::vector<Vec3> normals;
    HardVertices hard;
    normals.reserve(uncut.vertexCount());
    for (int v = 0; v < uncut.vertexCount(); ++v) {
        normals.push_back(restNormal(uncut, v).direction);
        if (std::vector<Side> sides = sidesAround(uncut, v); !sides.empty()) {
            hard.emplace(v, std::move(sides));
        }
    }
    hardUncut_ = std::make_shared<const HardVertices>(std::move(hard));
    uncut_ = std::make_shared<const std::vector<Vec3>>(std::move(normals));
}

const Vec3& SkinNormals::normal(int vertex) const {
    return vertex < uncutVertices() ? (*uncut_)[vertex] : later_[vertex - uncutVertices()];
}

const std::vector<SkinNormals::Side>* SkinNormals::sidesOf(int vertex) const {
    if (!uncut_) {
        return nullptr;
    }
    const HardVertices& hard = vertex < uncutVertices() ? *hardUncut_ : hardLater_;
    const auto found = hard.find(vertex);
    return found == hard.end() ? nullptr : &found->second;
}

const Vec3& SkinNormals::normal(int vertex, const Vec3& face) const {
    const std::vector<Side>* sides = sidesOf(vertex);
    if (sides == nullptr) {
        return normal(vertex);
    }
    return std::ranges::max_element(*sides, {},
                                    [&](const Side& side) { return side.face.dot(face); })
        ->normal;
}

void SkinNormals::follow(const SurfaceMesh& mesh, int firstNew, std::span<const Triangle> old) {
    later_.resize(mesh.vertexCount() - uncutVertices(), Vec3::Zero());
    if (old.empty()) {
        return;
    }
    const auto cornersOf = [&](int i) {
        const auto [a, b, c] = old[i];
        return std::array{mesh.restPosition(a), mesh.restPosition(b), mesh.restPosition(c)};
    };
    std::vector<int> ids(old.size());
    std::iota(ids.begin(), ids.end(), 0);
    NearestTriangle nearest(ids, cornersOf);
    for (int v = firstNew; v < mesh.vertexCount(); ++v) {
        if (!kindsAround(mesh, v).skin) {
            continue;
        }
        const Vec3& p = mesh.restPosition(v);
        const int i = nearest.find(p);
        const auto [a, b, c] = cornersOf(i);
        const Vec3 w = closestWeights(p, a, b, c);
        const Vec3 face = (b - a).cross(c - a).normalized();
        std::array<RoundCorner, 3> corners;
        Vec3 sum = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            const Vec3& told = normal(old[i][k], face);
            sum += w[k] * told.normalized();
            const bool hard = sidesOf(old[i][k]) != nullptr;
            corners[k] = roundCorner(cornersOf(i)[k], told, hard, w[k]);
        }
        const Vec3 up = sum.normalized();
        later_[v - uncutVertices()] = std::max(1 + bulgeAt(corners, p, up), kLeastNormal) * up;
        if (std::vector<Side> sides = sidesAround(mesh, v); !sides.empty()) {
            hardLater_.insert_or_assign(v, std::move(sides));
        }
    }
}

Vec3 SkinNormals::ofCut(const SurfaceMesh& mesh, int vertex) const {
    const Kinds kinds = kindsAround(mesh, vertex);
    const bool isNew = vertex >= uncutVertices();
    const bool isCut = kinds.skin && (isNew || kinds.wall) && sidesOf(vertex) == nullptr;
    return isCut ? normal(vertex) : Vec3::Zero();
}

}  // namespace kerf
