#include "sim/repair/soup_editing.h"

#include <tuple>

#include "sim/base/math.h"
#include "sim/mesh/union_find.h"

namespace kerf::repair {

std::vector<Side> sidesByEdge(const std::vector<Triangle>& triangles) {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const int a = triangles[t][corner];
            const int b = triangles[t][(corner + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), 3 * t + corner, a < b});
        }
    }
    std::ranges::sort(sides, {},
                      [](const Side& s) { return std::tuple(s.low, s.high, s.halfEdge); });
    return sides;
}

std::vector<Side> openSides(const TriangleSoup& soup) {
    std::vector<Side> open;
    forEachEdge(sidesByEdge(soup.triangles), [&](const Side* begin, const Side* end) {
        if (end - begin == 1) {
            open.push_back(*begin);
        }
    });
    return open;
}

Partners partnersOf(const std::vector<Side>& sides, std::size_t triangles) {
    Partners partners(3 * triangles, -1);
    forEachEdge(sides, [&](const Side* begin, const Side* end) {
        if (end - begin == 2) {
            partners[begin[0].halfEdge] = begin[1].halfEdge;
            partners[begin[1].halfEdge] = begin[0].halfEdge;
        }
    });
    return partners;
}

int originOf(const TriangleSoup& soup, int halfEdge) {
    return soup.triangles[halfEdge / 3][halfEdge % 3];
}

int apexOf(const TriangleSoup& soup, int halfEdge) {
    return soup.triangles[halfEdge / 3][(halfEdge + 2) % 3];
}

Corners cornersOf(const TriangleSoup& soup, int triangle) {
    const auto& [a, b, c] = soup.triangles[triangle];
    return {soup.positions[a], soup.positions[b], soup.positions[c]};
}

Bounds boundsOf(const TriangleSoup& soup, int triangle) {
    return boxOf(cornersOf(soup, triangle));
}

bool isUsable(const TriangleSoup& soup, const Triangle& t) {
    const int count = static_cast<int>(soup.positions.size());
    return std::ranges::all_of(
        t, [&](int v) { return v >= 0 && v < count && soup.positions[v].allFinite(); });
}

bool repeatsCorner(const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

Triangle sortedCorners(Triangle t) {
    std::ranges::sort(t);
    return t;
}

void addTriangle(TriangleSoup& soup, const Triangle& corners,
                 const TriangleAttributes& attributes) {
    soup.triangles.push_back(corners);
    resizeAttributes(soup.skin, soup.triangles.size());
    setAttributes(soup.skin, static_cast<int>(soup.triangles.size()) - 1, attributes);
}

int keepTriangles(TriangleSoup& soup, const std::function<bool(int t)>& keeps) {
    const auto count = static_cast<int>(soup.triangles.size());
    int kept = 0;
    for (int t = 0; t < count; ++t) {
        if (keeps(t)) {
            soup.triangles[kept] = soup.triangles[t];
            setAttributes(soup.skin, kept++, attributesOf(soup.skin, t));
        }
    }
    soup.triangles.resize(kept);
    resizeAttributes(soup.skin, kept);
    return count - kept;
}

void dropUnusedVertices(TriangleSoup& soup) {
    std::vector<int> place(soup.positions.size(), -1);
    std::vector<char> used(soup.positions.size(), 0);
    for (const Triangle& t : soup.triangles) {
        for (const int v : t) {
            used[v] = 1;
        }
    }
    int next = 0;
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (used[v] != 0) {
            soup.positions[next] = soup.positions[v];
            place[v] = next++;
        }
    }
    soup.positions.resize(next);
    for (Triangle& t : soup.triangles) {
        for (int& v : t) {
            v = place[v];
        }
    }
}

std::vector<int> partsOf(const TriangleSoup& soup) {
    UnionFind sets(soup.positions.size());
    for (const auto& [a, b, c] : soup.triangles) {
        sets.join(a, b);
        sets.join(b, c);
    }
    std::vector<int> partOfRoot(soup.positions.size(), -1);
    std::vector<int> parts;
    int count = 0;
    for (const Triangle& t : soup.triangles) {
        int& part = partOfRoot[sets.root(t[0])];
        part = part < 0 ? count++ : part;
        parts.push_back(part);
    }
    return parts;
}

namespace {

int countOf(const std::vector<int>& parts) {
    return parts.empty() ? 0 : std::ranges::max(parts) + 1;
}

}  // namespace

std::vector<double> volumesOf(const TriangleSoup& soup, const std::vector<int>& parts) {
    std::vector<double> volumes(countOf(parts), 0.0);
    std::vector<int> apexes(volumes.size(), -1);
    for (std::size_t t = 0; t < parts.size(); ++t) {
        const auto& [a, b, c] = soup.triangles[t];
        int& apex = apexes[parts[t]];
        apex = apex < 0 ? a : apex;
        const Vec3& o = soup.positions[apex];
        volumes[parts[t]] +=
            tetrahedronVolume(soup.positions[a] - o, soup.positions[b] - o, soup.positions[c] - o);
    }
    return volumes;
}

std::vector<double> areasOf(const TriangleSoup& soup, const std::vector<int>& parts) {
    std::vector<double> areas(countOf(parts), 0.0);
    for (std::size_t t = 0; t < parts.size(); ++t) {
        const auto& [a, b, c] = soup.triangles[t];
        areas[parts[t]] += triangleArea(soup.positions[a], soup.positions[b], soup.positions[c]);
    }
    return areas;
}

}  // namespace kerf::repair
