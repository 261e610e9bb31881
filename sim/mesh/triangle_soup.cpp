#include "sim/mesh/triangle_soup.h"

#include <bit>
#include <unordered_map>

#include "sim/base/boxes.h"
#include "sim/base/float_rounding.h"
#include "sim/base/placement.h"

namespace kerf {

namespace {

using PositionBits = std::array<std::uint64_t, 3>;

/// Adding 0 turns -0 into 0, so that both have the same bits.
PositionBits bitsOf(const Vec3& p) {
    return {std::bit_cast<std::uint64_t>(p.x() + 0.0), std::bit_cast<std::uint64_t>(p.y() + 0.0),
            std::bit_cast<std::uint64_t>(p.z() + 0.0)};
}

/// Only used to look up: the order of the map is never walked.
struct PositionBitsHash {
    std::size_t operator()(const PositionBits& bits) const {
        std::uint64_t hash = 0;
        for (const std::uint64_t b : bits) {
            hash = (hash ^ b) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 29;
        }
        return hash;
    }
};

}  // namespace

TriangleSoup weldExactly(const TriangleSoup& soup) {
    TriangleSoup welded;
    std::unordered_map<PositionBits, int, PositionBitsHash> places;
    std::vector<int> newIndex(soup.positions.size(), -1);
    const auto weld = [&](int v) {
        if (newIndex[v] < 0) {
            const int next = static_cast<int>(welded.positions.size());
            const auto [place, isNew] = places.try_emplace(bitsOf(soup.positions[v]), next);
            if (isNew) {
                welded.positions.push_back(soup.positions[v]);
            }
            newIndex[v] = place->second;
        }
        return newIndex[v];
    };
    welded.triangles.reserve(soup.triangles.size());
    for (const auto& [a, b, c] : soup.triangles) {
        const int first = weld(a);
        const int second = weld(b);
        welded.triangles.push_back({first, second, weld(c)});
    }
    welded.skin = soup.skin;
    return welded;
}

Vec3 floatOrigin(const TriangleSoup& soup) {
    return soup.positions.empty() ? Vec3(Vec3::Zero()) : originOf(boxOf(soup.positions));
}

void roundToFloats(TriangleSoup& soup) {
    const Vec3 origin = floatOrigin(soup);
    for (Vec3& p : soup.positions) {
        p = origin + nearestFloats(p - origin);
    }
    soup = weldExactly(soup);
}

void turnTriangle(TriangleSoup& soup, int t) {
    std::swap(soup.triangles[t][1], soup.triangles[t][2]);
    TriangleAttributes turned = attributesOf(soup.skin, t);
    std::swap(turned.uvs[1], turned.uvs[2]);
    std::swap(turned.colors[1], turned.colors[2]);
    setAttributes(soup.skin, t, turned);
}

}  // namespace kerf
