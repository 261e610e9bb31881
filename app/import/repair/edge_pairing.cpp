#include "app/import/repair/edge_pairing.h"

#include "sim/base/containers.h"
#include "sim/mesh/union_find.h"
#include "sim/repair/soup_editing.h"

namespace kerf::app {

namespace {

using repair::Partners;
using repair::Side;

constexpr double kSameAngle = 1e-9;  // of triangles at an edge

/// Walks over the patch of a triangle; `turned` tells which face otherwise than it. Returns the
/// triangles of the patch.
std::vector<int> walkPatch(const TriangleSoup& soup, const Partners& partners, int first,
                           std::vector<char>& seen, std::vector<char>& turned) {
    std::vector<int> patch{first};
    seen[first] = 1;
    for (std::size_t i = 0; i < patch.size(); ++i) {
        for (int h = 3 * patch[i]; h < 3 * patch[i] + 3; ++h) {
            const int g = partners[h];
            if (g >= 0 && seen[g / 3] == 0) {
                seen[g / 3] = 1;
                const bool alike = repair::originOf(soup, g) != repair::originOf(soup, h);
                turned[g / 3] = alike ? turned[patch[i]] : 1 - turned[patch[i]];
                patch.push_back(g / 3);
            }
        }
    }
    return patch;
}

/// The way around an edge at which a triangle stands, from -pi to less than pi.
double angleAround(const TriangleSoup& soup, const Side& side, const Vec3& along, const Vec3& right,
                   const Vec3& ahead) {
    const Vec3 way = soup.positions[repair::apexOf(soup, side.halfEdge)] - soup.positions[side.low];
    const Vec3 across = way - way.dot(along) * along;
    const double angle = std::atan2(across.dot(ahead), across.dot(right));
    return angle < std::numbers::pi - kSameAngle ? angle : angle - 2 * std::numbers::pi;
}

/// A side of an edge and where its triangle stands.
struct PlacedSide {
    double angle;
    int sheet;  ///< of its triangle
    Side side;
};

/// Of sides at one angle those come first that run up, so that solids that touch there stay apart.
/// Of several sheets each lies within the other, so that surfaces that lie on each other keep to
/// themselves at all their edges.
void orderSameAngles(std::vector<PlacedSide>& placed) {
    for (auto begin = placed.begin(); begin != placed.end();) {
        auto end = begin + 1;
        while (end != placed.end() && end->angle - (end - 1)->angle < kSameAngle) {
            ++end;
        }
        std::stable_sort(begin, end, [](const PlacedSide& a, const PlacedSide& b) {
            if (a.side.upward != b.side.upward) {
                return a.side.upward;
            }
            return a.side.upward ? a.sheet > b.sheet : a.sheet < b.sheet;
        });
        begin = end;
    }
}

/// The sides of an edge in the order in which one turns about it from low to high.
std::vector<Side> inTurn(const TriangleSoup& soup, const std::vector<int>& sheets,
                         const Side* begin, const Side* end) {
    const Vec3 along =
        (soup.positions[begin->high] - soup.positions[begin->low]).stableNormalized();
    const Vec3 right = along.unitOrthogonal();
    const Vec3 ahead = along.cross(right);
    std::vector<PlacedSide> placed;
    for (const Side* side = begin; side != end; ++side) {
        placed.push_back(
            {angleAround(soup, *side, along, right, ahead), sheets[side->triangle()], *side});
    }
    std::ranges::stable_sort(placed, {}, &PlacedSide::angle);
    orderSameAngles(placed);
    return mapped(placed, &PlacedSide::side);
}

/// Numbers of the parts that hang together by edges of two triangles, by triangle.
std::vector<int> sheetsOf(const Partners& partners) {
    UnionFind sets(partners.size() / 3);
    for (int h = 0; h < static_cast<int>(partners.size()); ++h) {
        if (partners[h] > h) {
            sets.join(h / 3, partners[h] / 3);
        }
    }
    std::vector<int> sheets;
    sheets.reserve(partners.size() / 3);
    for (int t = 0; t < static_cast<int>(partners.size() / 3); ++t) {
        sheets.push_back(sets.root(t));
    }
    return sheets;
}

/// Pairs the two sides of each sheet that has just those at the edge and runs on between them.
void pairOwn(const std::vector<int>& sheets, const std::vector<Side>& turn, Partners& partners) {
    for (const Side& side : turn) {
        const auto own = [&](const Side& other) {
            return sheets[other.triangle()] == sheets[side.triangle()];
        };
        const auto partner = std::ranges::find_if(
            turn, [&](const Side& other) { return own(other) && other.upward != side.upward; });
        if (partner != turn.end() && std::ranges::count_if(turn, own) == 2) {
            partners[side.halfEdge] = partner->halfEdge;
        }
    }
}

/// Turning from low to high, material lies between a side that runs down and the next that runs
/// up. They are matched as brackets are; what finds no match stays open.
void pairAround(const std::vector<Side>& turn, Partners& partners) {
    std::vector<int> open;
    for (std::size_t i = 0; i < 2 * turn.size(); ++i) {
        const Side& side = turn[i % turn.size()];
        if (partners[side.halfEdge] >= 0) {
            continue;
        }
        if (!side.upward) {
            if (i < turn.size()) {
                open.push_back(side.halfEdge);
            }
        } else if (!open.empty()) {
            partners[side.halfEdge] = open.back();
            partners[open.back()] = side.halfEdge;
            open.pop_back();
        }
    }
}

/// Leaves two that face opposite ways apart: nothing closes there.
void dropContradictions(const TriangleSoup& soup, Partners& partners) {
    for (int h = 0; h < static_cast<int>(partners.size()); ++h) {
        const int g = partners[h];
        if (g >= 0 && repair::originOf(soup, h) == repair::originOf(soup, g)) {
            partners[h] = -1;
            partners[g] = -1;
        }
    }
}

/// Corners of triangles that hang together by pairs, as sets.
UnionFind fansOf(const TriangleSoup& soup, const Partners& partners) {
    UnionFind corners(3 * soup.triangles.size());
    for (int h = 0; h < static_cast<int>(partners.size()); ++h) {
        const int g = partners[h];
        if (g > h) {
            corners.join(h, 3 * (g / 3) + (g + 1) % 3);
            corners.join(3 * (h / 3) + (h + 1) % 3, g);
        }
    }
    return corners;
}

/// Gives each fan of triangles a vertex of its own. Returns at how many vertices there were
/// several.
int divideVertices(TriangleSoup& soup, UnionFind& fans) {
    std::vector<int> fanOfVertex(soup.positions.size(), -1);
    std::vector<int> vertexOfFan(3 * soup.triangles.size(), -1);
    std::vector<char> isParted(soup.positions.size(), 0);
    for (int corner = 0; corner < static_cast<int>(3 * soup.triangles.size()); ++corner) {
        int& v = soup.triangles[corner / 3][corner % 3];
        const int fan = fans.root(corner);
        if (vertexOfFan[fan] < 0) {
            const bool isFirst = fanOfVertex[v] < 0;
            fanOfVertex[v] = isFirst ? fan : fanOfVertex[v];
            vertexOfFan[fan] = isFirst ? v : static_cast<int>(soup.positions.size());
            if (!isFirst) {
                isParted[v] = 1;
                soup.positions.push_back(soup.positions[v]);
            }
        }
        v = vertexOfFan[fan];
    }
    return static_cast<int>(std::ranges::count(isParted, 1));
}

/// Whether an edge has more than two triangles.
bool branches(const TriangleSoup& soup) {
    bool found = false;
    forEachEdge(repair::sidesByEdge(soup.triangles),
                [&](const Side* begin, const Side* end) { found = found || end - begin > 2; });
    return found;
}

/// Turns connected parts of negative volume, so that it can be told where there is material.
void turnPartsOutward(TriangleSoup& soup) {
    const std::vector<int> parts = repair::partsOf(soup);
    const std::vector<double> volumes = repair::volumesOf(soup, parts);
    for (std::size_t t = 0; t < parts.size(); ++t) {
        if (volumes[parts[t]] < 0) {
            turnTriangle(soup, static_cast<int>(t));
        }
    }
}

}  // namespace

int orientAlike(TriangleSoup& soup) {
    const Partners partners =
        repair::partnersOf(repair::sidesByEdge(soup.triangles), soup.triangles.size());
    std::vector<char> seen(soup.triangles.size(), 0);
    std::vector<char> turned(soup.triangles.size(), 0);
    int count = 0;
    for (int first = 0; first < static_cast<int>(soup.triangles.size()); ++first) {
        if (seen[first] != 0) {
            continue;
        }
        const std::vector<int> patch = walkPatch(soup, partners, first, seen, turned);
        const auto others = std::ranges::count_if(patch, [&](int t) { return turned[t] != 0; });
        const char toTurn = 2 * others <= static_cast<std::ptrdiff_t>(patch.size()) ? 1 : 0;
        for (const int t : patch) {
            if (turned[t] == toTurn) {
                turnTriangle(soup, t);
                ++count;
            }
        }
    }
    return count;
}

PartedSurface partBranches(TriangleSoup& soup) {
    if (branches(soup)) {
        turnPartsOutward(soup);
    }
    const std::vector<Side> sides = repair::sidesByEdge(soup.triangles);
    Partners partners = repair::partnersOf(sides, soup.triangles.size());
    const std::vector<int> sheets = sheetsOf(partners);
    PartedSurface parted;
    forEachEdge(sides, [&](const Side* begin, const Side* end) {
        if (end - begin > 2) {
            const std::vector<Side> turn = inTurn(soup, sheets, begin, end);
            pairOwn(sheets, turn, partners);
            pairAround(turn, partners);
            ++parted.edges;
        }
    });
    dropContradictions(soup, partners);
    UnionFind fans = fansOf(soup, partners);
    const int vertices = divideVertices(soup, fans);
    parted.vertices = parted.edges > 0 ? 0 : vertices;
    return parted;
}

}  // namespace kerf::app
