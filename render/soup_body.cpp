#include "render/soup_body.h"

#include "shaders/shared/shared_types.h"

namespace kerf::render {
namespace {

using Pair = std::array<std::uint32_t, 2>;
using Four = std::array<std::uint32_t, 4>;

bool isDrawn(const TriangleSoup& soup, const Triangle& t) {
    const int count = static_cast<int>(soup.positions.size());
    return std::ranges::all_of(
        t, [&](int v) { return v >= 0 && v < count && soup.positions[v].allFinite(); });
}

shared::vec4 packed(const Vec3& p) {
    return {float(p.x()), float(p.y()), float(p.z()), 0};
}

}  // namespace

/// Each triangle has corners of its own behind the vertices of the soup, so that its normal is its
/// own too.
SoupBody::SoupBody(const TriangleSoup& soup) {
    std::vector<shared::vec4> positions;
    positions.reserve(soup.positions.size() + 3 * soup.triangles.size());
    for (const Vec3& p : soup.positions) {
        positions.push_back(packed(p.allFinite() ? p : Vec3(Vec3::Zero())));
    }
    std::vector<Four> triangles;
    std::vector<Pair> ranges(soup.positions.size(), Pair{0, 0});
    std::vector<std::uint32_t> incidence;
    for (const Triangle& t : soup.triangles) {
        if (!isDrawn(soup, t)) {
            continue;
        }
        const auto number = static_cast<std::uint32_t>(triangles.size());
        const auto first = static_cast<std::uint32_t>(positions.size());
        triangles.push_back({first, first + 1, first + 2, 0});
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            positions.push_back(positions[t[corner]]);
            const auto entry = static_cast<std::uint32_t>(incidence.size());
            ranges.push_back({entry, entry + 1});
            incidence.push_back(4 * number + corner);
        }
    }
    vertexCount_ = static_cast<std::uint32_t>(positions.size());
    triangleCount_ = static_cast<std::uint32_t>(triangles.size());
    positions_.assign(positions);
    cutSkinNormals_.resize(positions.size() * sizeof(shared::vec4));
    cutSkinNormals_.clear();
    triangles_.assign(triangles);
    incidenceRanges_.assign(ranges);
    incidence_.assign(incidence);
}

BodyView SoupBody::view() const {
    return {.positions = &positions_,
            .restPositions = &positions_,
            .cutSkinNormals = &cutSkinNormals_,
            .triangles = &triangles_,
            .incidenceRanges = &incidenceRanges_,
            .incidence = &incidence_,
            .vertexCount = vertexCount_,
            .triangleCount = triangleCount_};
}

}  // namespace kerf::render
