#include "sim/mesh/skin_attributes.h"

#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle.h"

namespace kerf {
namespace {

constexpr int kMaxWalk = 16;        // triangles from the middle of a new one to its corner
constexpr double kOutside = -1e-6;  // a weight below this is outside

/// Whether an edge has other values on its other side. It begins at `corner` of t, and at `other`
/// of g.
template <class Values>
bool parts(const std::vector<Values>& values, int t, int corner, int g, int other) {
    return !values.empty() && (values[t][corner] != values[g][(other + 1) % 3] ||
                               values[t][(corner + 1) % 3] != values[g][other]);
}

template <class Values>
auto blend(const Values& corners, const Eigen::Vector3f& w) {
    return (w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2]).eval();
}

/// Those of a triangle that has none.
TriangleAttributes noAttributes() {
    TriangleAttributes none;
    none.uvs.fill(Eigen::Vector2f::Zero());
    none.colors.fill(Eigen::Vector4f::Ones());
    return none;
}

}  // namespace

TriangleAttributes attributesOf(const SkinAttributes& skin, int t) {
    TriangleAttributes own = noAttributes();
    own.uvs = skin.uvs.empty() ? own.uvs : skin.uvs[t];
    own.colors = skin.colors.empty() ? own.colors : skin.colors[t];
    own.material = skin.materials.empty() ? own.material : skin.materials[t];
    return own;
}

void setAttributes(SkinAttributes& skin, int t, const TriangleAttributes& attributes) {
    if (!skin.uvs.empty()) {
        skin.uvs[t] = attributes.uvs;
    }
    if (!skin.colors.empty()) {
        skin.colors[t] = attributes.colors;
    }
    if (!skin.materials.empty()) {
        skin.materials[t] = attributes.material;
    }
}

void resizeAttributes(SkinAttributes& skin, std::size_t triangles) {
    const TriangleAttributes none = noAttributes();
    if (!skin.uvs.empty()) {
        skin.uvs.resize(triangles, none.uvs);
    }
    if (!skin.colors.empty()) {
        skin.colors.resize(triangles, none.colors);
    }
    if (!skin.materials.empty()) {
        skin.materials.resize(triangles, none.material);
    }
}

SkinCarrier::SkinCarrier(const SurfaceMesh& uncut, const SkinAttributes& skin)
    : mesh_(uncut), skin_(skin) {}

TriangleAttributes SkinCarrier::of(int slot, const Corners& corners) {
    if (isOriginal(slot, corners)) {
        return attributesOf(skin_, slot);
    }
    const auto& [a, b, c] = corners;
    const int middle = find((a + b + c) / 3);
    TriangleAttributes out = noAttributes();
    out.material = skin_.materials.empty() ? -1 : skin_.materials[middle];
    for (int i = 0; i < 3; ++i) {
        const SkinPoint point = pointOf(middle, corners[i]);
        if (!skin_.uvs.empty()) {
            out.uvs[i] = blend(skin_.uvs[point.triangle], point.weights);
        }
        if (!skin_.colors.empty()) {
            out.colors[i] = blend(skin_.colors[point.triangle], point.weights);
        }
    }
    return out;
}

/// No cut has touched it: its corners may be copies, at the same places, rounded to float.
bool SkinCarrier::isOriginal(int slot, const Corners& corners) const {
    if (slot >= mesh_.triangleSlots()) {
        return false;
    }
    const Corners own = restCornersOf(mesh_, slot);
    return std::ranges::equal(own, corners, [](const Vec3& a, const Vec3& b) {
        return a.cast<float>() == b.cast<float>();
    });
}

int SkinCarrier::find(const Vec3& p) {
    if (!triangles_) {
        triangles_.emplace(livingTriangles(mesh_),
                           [this](int t) { return restCornersOf(mesh_, t); });
    }
    return triangles_->find(p);
}

/// From triangle t over edges that are no seams to where p lies.
SkinCarrier::SkinPoint SkinCarrier::pointOf(int t, const Vec3& p) const {
    for (int walked = 0; walked < kMaxWalk; ++walked) {
        const Vec3 weights = planeWeights(t, p);
        int least = 0;
        weights.minCoeff(&least);
        const int across = neighbour(t, (least + 1) % 3);
        if (weights[least] >= kOutside || across < 0) {
            break;
        }
        t = across;
    }
    const auto [a, b, c] = restCornersOf(mesh_, t);
    return {t, closestWeights(p, a, b, c).cast<float>()};
}

/// Barycentric, of the foot of p in the plane of t.
Vec3 SkinCarrier::planeWeights(int t, const Vec3& p) const {
    const auto [a, b, c] = restCornersOf(mesh_, t);
    const Vec3 normal = areaNormal(a, b, c);
    const double area = normal.squaredNorm();
    if (area == 0) {
        return Vec3::Constant(1.0 / 3);
    }
    const double v = areaNormal(a, p, c).dot(normal) / area;
    const double w = areaNormal(a, b, p).dot(normal) / area;
    return {1 - v - w, v, w};
}

/// Over the edge that begins at a corner; -1 where that is a seam.
int SkinCarrier::neighbour(int t, int corner) const {
    const int g = mesh_.twin(3 * t + corner);
    const bool seam =
        parts(skin_.uvs, t, corner, g / 3, g % 3) || parts(skin_.colors, t, corner, g / 3, g % 3);
    return seam ? -1 : g / 3;
}

SkinAttributes carrySkin(const SurfaceMesh& uncut, const SkinAttributes& skin,
                         const SurfaceMesh& cut) {
    SkinAttributes out = skin;
    resizeAttributes(out, static_cast<std::size_t>(cut.triangleSlots()));
    SkinCarrier carrier(uncut, skin);
    for (int t = 0; t < cut.triangleSlots() && !skin.empty(); ++t) {
        const bool skinned = cut.alive(t) && cut.kind(t) == SurfaceKind::skin;
        setAttributes(out, t, skinned ? carrier.of(t, restCornersOf(cut, t)) : noAttributes());
    }
    return out;
}

}  // namespace kerf
