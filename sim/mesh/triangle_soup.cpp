#include "sim/mesh/triangle_soup.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "sim/base/text.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/union_find.h"

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

/// One side of one triangle.
struct Side {
    int low = 0;
    int high = 0;
    int triangle = 0;
    bool upward = false;  ///< runs from low to high
};

bool sameEdge(const Side& a, const Side& b) {
    return a.low == b.low && a.high == b.high;
}

bool hasRepeatedCorner(const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// A triangle whose indices are valid and that is more than a line.
bool isProper(const TriangleSoup& soup, const Triangle& t) {
    const int count = static_cast<int>(soup.positions.size());
    return std::ranges::all_of(t, [&](int v) { return v >= 0 && v < count; }) &&
           !hasRepeatedCorner(t);
}

std::vector<Triangle> properTriangles(const TriangleSoup& soup) {
    std::vector<Triangle> proper;
    std::ranges::copy_if(soup.triangles, std::back_inserter(proper),
                         [&](const Triangle& t) { return isProper(soup, t); });
    return proper;
}

std::vector<Side> sortedSides(const std::vector<Triangle>& triangles) {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const int a = triangles[t][corner];
            const int b = triangles[t][(corner + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), t, a < b});
        }
    }
    std::ranges::sort(
        sides, {}, [](const Side& s) { return std::tuple(s.low, s.high, s.triangle, s.upward); });
    return sides;
}

/// Calls f(begin, end) for the sides of each edge.
template <class F>
void forEachEdge(const std::vector<Side>& sides, F&& f) {
    for (auto begin = sides.begin(); begin != sides.end();) {
        const auto end = std::find_if_not(begin, sides.end(),
                                          [&](const Side& s) { return sameEdge(s, *begin); });
        f(begin, end);
        begin = end;
    }
}

void countEdges(const std::vector<Side>& sides, MeshReport& report) {
    forEachEdge(sides, [&](auto begin, auto end) {
        const auto count = end - begin;
        report.openEdges += count == 1;
        report.nonManifoldEdges += count > 2;
        report.misorientedEdges += count == 2 && begin->upward == (begin + 1)->upward;
    });
}

int cornerOf(const Triangle& t, int v) {
    return t[0] == v ? 0 : t[1] == v ? 1 : 2;
}

/// Joins the corners of triangles that share an edge at a vertex; a vertex with more than one
/// class of corners touches itself in a point.
int countNonManifoldVertices(const std::vector<Triangle>& triangles, const std::vector<Side>& sides,
                             std::size_t vertexCount) {
    UnionFind corners(3 * triangles.size());
    forEachEdge(sides, [&](auto begin, auto end) {
        for (auto side = begin + 1; side < end; ++side) {
            for (const int v : {begin->low, begin->high}) {
                corners.join(3 * begin->triangle + cornerOf(triangles[begin->triangle], v),
                             3 * side->triangle + cornerOf(triangles[side->triangle], v));
            }
        }
    });
    std::vector<int> umbrellas(vertexCount, 0);
    for (int c = 0; c < static_cast<int>(3 * triangles.size()); ++c) {
        umbrellas[triangles[c / 3][c % 3]] += corners.root(c) == c;
    }
    return static_cast<int>(std::ranges::count_if(umbrellas, [](int n) { return n > 1; }));
}

/// Connected pieces of a list of triangles.
struct TrianglePieces {
    std::vector<int> ofTriangle;  ///< numbered by their lowest triangle
    std::vector<double> volumes;  ///< signed [m^3]
    std::vector<double> areas;    ///< [m^2]
};

Corners cornersOf(const TriangleSoup& soup, const Triangle& t) {
    return {soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]};
}

/// Volumes are summed about the middle of the model, where rounding is smallest.
TrianglePieces findTrianglePieces(const TriangleSoup& soup, const std::vector<Triangle>& triangles,
                                  const Vec3& middle) {
    UnionFind vertices(soup.positions.size());
    for (const auto& [a, b, c] : triangles) {
        vertices.join(a, b);
        vertices.join(b, c);
    }
    TrianglePieces pieces;
    std::vector<int> pieceOfRoot(soup.positions.size(), -1);
    for (const Triangle& t : triangles) {
        int& piece = pieceOfRoot[vertices.root(t[0])];
        if (piece < 0) {
            piece = static_cast<int>(pieces.volumes.size());
            pieces.volumes.push_back(0);
            pieces.areas.push_back(0);
        }
        pieces.ofTriangle.push_back(piece);
        const Corners at = cornersOf(soup, t);
        pieces.volumes[piece] += tetrahedronVolume(at[0] - middle, at[1] - middle, at[2] - middle);
        pieces.areas[piece] += triangleArea(at);
    }
    return pieces;
}

double totalVolume(const TrianglePieces& pieces) {
    return std::accumulate(pieces.volumes.begin(), pieces.volumes.end(), 0.0);
}

/// Half the solid angle of a triangle seen from a point, signed (Van Oosterom, Strackee 1983).
double halfSolidAngle(const TriangleSoup& soup, const Triangle& t, const Vec3& point) {
    const Vec3 a = soup.positions[t[0]] - point;
    const Vec3 b = soup.positions[t[1]] - point;
    const Vec3 c = soup.positions[t[2]] - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    return std::atan2(a.dot(b.cross(c)),
                      la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

/// In how many other pieces a piece lies, from the winding of each around one of its vertices.
int enclosingPieces(const TriangleSoup& soup, const std::vector<Triangle>& triangles,
                    const TrianglePieces& pieces, int piece) {
    const auto first = std::ranges::find(pieces.ofTriangle, piece) - pieces.ofTriangle.begin();
    const Vec3& point = soup.positions[triangles[first][0]];
    std::vector<double> winding(pieces.volumes.size(), 0);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (pieces.ofTriangle[i] != piece) {
            winding[pieces.ofTriangle[i]] +=
                halfSolidAngle(soup, triangles[i], point) / (2 * std::numbers::pi);
        }
    }
    return static_cast<int>(
        std::ranges::count_if(winding, [](double w) { return std::abs(w) > 0.5; }));
}

/// Which pieces face inwards; see turnOutward.
std::vector<bool> findInsideOut(const TriangleSoup& soup, const std::vector<Triangle>& triangles,
                                const TrianglePieces& pieces) {
    const bool whole = totalVolume(pieces) < 0;
    std::vector<bool> insideOut(pieces.volumes.size(), whole);
    for (int i = 0; i < static_cast<int>(pieces.volumes.size()); ++i) {
        const bool negative = whole ? pieces.volumes[i] > 0 : pieces.volumes[i] < 0;
        if (negative && enclosingPieces(soup, triangles, pieces, i) % 2 == 0) {
            insideOut[i] = !insideOut[i];
        }
    }
    return insideOut;
}

/// Pieces that still have negative volume once those that are inside out have been turned.
int countCavities(const TrianglePieces& pieces, const std::vector<bool>& insideOut) {
    int cavities = 0;
    for (std::size_t i = 0; i < pieces.volumes.size(); ++i) {
        cavities += insideOut[i] ? pieces.volumes[i] > 0 : pieces.volumes[i] < 0;
    }
    return cavities;
}

/// A piece encloses nothing where its volume is within rounding of zero.
int countFlat(const TrianglePieces& pieces) {
    constexpr double kFlatRatio = 1e-9;
    int flat = 0;
    for (std::size_t i = 0; i < pieces.volumes.size(); ++i) {
        flat += std::abs(pieces.volumes[i]) <= kFlatRatio * std::pow(pieces.areas[i], 1.5);
    }
    return flat;
}

Bounds boundsOf(const TriangleSoup& soup) {
    Bounds bounds;
    for (const Vec3& p : soup.positions) {
        bounds.add(p);
    }
    return bounds;
}

void countElements(const TriangleSoup& soup, MeshReport& report) {
    const int vertexCount = static_cast<int>(soup.positions.size());
    report.vertices = vertexCount;
    report.triangles = static_cast<int>(soup.triangles.size());
    report.bounds = boundsOf(soup);
    report.nonFiniteVertices = static_cast<int>(
        std::ranges::count_if(soup.positions, [](const Vec3& p) { return !p.allFinite(); }));
    for (const Triangle& t : soup.triangles) {
        const bool inRange =
            std::ranges::all_of(t, [&](int v) { return v >= 0 && v < vertexCount; });
        report.outOfRangeIndices += !inRange;
        report.degenerateTriangles +=
            inRange && (hasRepeatedCorner(t) || areaNormal(cornersOf(soup, t)).isZero(0));
    }
}

/// One kind of fault: how much of it, what it means and what to do.
struct Fault {
    int count;
    const char* one;
    const char* many;
    const char* meaning;
};

/// The most basic first: its meaning explains the ones after it.
std::vector<Fault> listFaults(const MeshReport& r) {
    return {
        {r.nonFiniteVertices, "vertex with a coordinate that is not a finite number",
         "vertices with a coordinate that is not a finite number",
         "the file is damaged; export it again"},
        {r.outOfRangeIndices, "triangle that names a vertex that is not there",
         "triangles that name a vertex that is not there", "the file is damaged; export it again"},
        {r.openEdges, "open edge", "open edges",
         "the surface is not closed, so cut faces can't be capped; fill the holes in a modelling "
         "tool"},
        {r.nonManifoldEdges, "edge with more than two triangles",
         "edges with more than two triangles",
         "the surface branches, so it has no clear inside; remove the extra faces in a modelling "
         "tool"},
        {r.nonManifoldVertices, "vertex where the surface touches itself",
         "vertices where the surface touches itself",
         "the parts hang together in a point only; separate them in a modelling tool"},
        {r.misorientedEdges, "edge between triangles that face opposite ways",
         "edges between triangles that face opposite ways",
         "outside and inside are mixed; recalculate the normals in a modelling tool"},
        {r.degenerateTriangles, "triangle without area", "triangles without area",
         "such triangles can't deform; dissolve them in a modelling tool"},
        {r.flatPieces, "piece that encloses no volume", "pieces that enclose no volume",
         "a cut needs an inside; give it thickness in a modelling tool"},
        {r.insideOutPieces, "piece that is inside out", "pieces that are inside out",
         "the triangles face inwards; flip the normals in a modelling tool"},
        {r.cavities, "cavity", "cavities",
         "hollow bodies can't be cut yet; remove the inner surface in a modelling tool"},
    };
}

std::string describeProblem(const MeshReport& report) {
    if (report.triangles == 0) {
        return "no triangles: there is no surface to cut; export the model as a triangle mesh";
    }
    std::string counts;
    std::string meaning;
    for (const Fault& fault : listFaults(report)) {
        if (fault.count > 0) {
            counts += (counts.empty() ? "" : ", ") + counted(fault.count, fault.one, fault.many);
            meaning = meaning.empty() ? fault.meaning : meaning;
        }
    }
    return counts.empty() ? "" : counts + ": " + meaning;
}

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

MeshReport inspectTriangles(const TriangleSoup& welded) {
    MeshReport report;
    countElements(welded, report);
    const std::vector<Triangle> proper = properTriangles(welded);
    const std::vector<Side> sides = sortedSides(proper);
    countEdges(sides, report);
    report.nonManifoldVertices = countNonManifoldVertices(proper, sides, welded.positions.size());
    const TrianglePieces pieces = findTrianglePieces(welded, proper, report.bounds.center());
    report.pieces = static_cast<int>(pieces.volumes.size());
    report.volume = totalVolume(pieces);

    const bool sound = report.nonFiniteVertices == 0 && report.outOfRangeIndices == 0;
    report.closed = sound && !proper.empty() && report.openEdges == 0;
    report.manifold = sound && report.nonManifoldEdges == 0 && report.nonManifoldVertices == 0;
    // Which side is out only a closed surface tells.
    report.oriented = sound && !proper.empty() && report.misorientedEdges == 0;
    if (report.closed && report.manifold && report.misorientedEdges == 0) {
        report.flatPieces = countFlat(pieces);
        const std::vector<bool> insideOut = findInsideOut(welded, proper, pieces);
        report.insideOutPieces = static_cast<int>(std::ranges::count(insideOut, true));
        report.cavities = countCavities(pieces, insideOut);
        report.oriented = report.insideOutPieces == 0 && report.volume > 0;
    }
    report.problem = describeProblem(report);
    report.cuttable = report.problem.empty();
    return report;
}

int turnOutward(TriangleSoup& soup) {
    const TrianglePieces pieces = findTrianglePieces(soup, soup.triangles, boundsOf(soup).center());
    const std::vector<bool> insideOut = findInsideOut(soup, soup.triangles, pieces);
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        if (insideOut[pieces.ofTriangle[i]]) {
            std::swap(soup.triangles[i][1], soup.triangles[i][2]);
            TriangleAttributes turned = attributesOf(soup.skin, static_cast<int>(i));
            std::swap(turned.uvs[1], turned.uvs[2]);
            std::swap(turned.colors[1], turned.colors[2]);
            setAttributes(soup.skin, static_cast<int>(i), turned);
        }
    }
    return static_cast<int>(std::ranges::count(insideOut, true));
}

}  // namespace kerf
