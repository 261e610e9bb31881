#include "sim/mesh/triangle_soup.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "sim/base/text.h"
#include "sim/mesh/box_tree.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/union_find.h"
#include "sim/mesh/winding.h"

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

bool isInRange(const TriangleSoup& soup, const Triangle& t) {
    const int count = static_cast<int>(soup.positions.size());
    return std::ranges::all_of(t, [&](int v) { return v >= 0 && v < count; });
}

/// A triangle whose indices are valid and that is more than a line.
bool isProper(const TriangleSoup& soup, const Triangle& t) {
    return isInRange(soup, t) && !hasRepeatedCorner(t);
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

void findEdges(const std::vector<Side>& sides, SurfaceFaults& faults) {
    forEachEdge(sides, [&](auto begin, auto end) {
        const auto count = end - begin;
        const SurfaceFaults::Edge edge{begin->low, begin->high};
        if (count == 1) {
            faults.openEdges.push_back(edge);
        } else if (count > 2) {
            faults.nonManifoldEdges.push_back(edge);
        } else if (begin->upward == (begin + 1)->upward) {
            faults.misorientedEdges.push_back(edge);
        }
    });
}

int cornerOf(const Triangle& t, int v) {
    return t[0] == v ? 0 : t[1] == v ? 1 : 2;
}

/// Joins the corners of triangles that share an edge at a vertex; a vertex with more than one
/// class of corners touches itself in a point.
std::vector<int> findNonManifoldVertices(const std::vector<Triangle>& triangles,
                                         const std::vector<Side>& sides, std::size_t vertexCount) {
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
    std::vector<int> found;
    for (std::size_t v = 0; v < vertexCount; ++v) {
        if (umbrellas[v] > 1) {
            found.push_back(static_cast<int>(v));
        }
    }
    return found;
}

/// Connected pieces of a list of triangles.
struct TrianglePieces {
    std::vector<int> ofTriangle;  ///< numbered by their lowest triangle
    std::vector<double> volumes;  ///< signed [m^3]
    std::vector<double> areas;    ///< [m^2]
    std::vector<Bounds> bounds;   ///< [m]
    std::vector<int> firsts;      ///< the lowest triangle
    std::vector<int> counts;      ///< of triangles

    int add(int firstTriangle) {
        volumes.push_back(0);
        areas.push_back(0);
        bounds.emplace_back();
        firsts.push_back(firstTriangle);
        counts.push_back(0);
        return static_cast<int>(volumes.size()) - 1;
    }
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
            piece = pieces.add(static_cast<int>(pieces.ofTriangle.size()));
        }
        pieces.ofTriangle.push_back(piece);
        const Corners at = cornersOf(soup, t);
        pieces.volumes[piece] += tetrahedronVolume(at[0] - middle, at[1] - middle, at[2] - middle);
        pieces.areas[piece] += triangleArea(at);
        ++pieces.counts[piece];
        for (const Vec3& corner : at) {
            pieces.bounds[piece].add(corner);
        }
    }
    return pieces;
}

double totalVolume(const TrianglePieces& pieces) {
    return std::accumulate(pieces.volumes.begin(), pieces.volumes.end(), 0.0);
}

/// So many triangles of the piece, spread over it, or all.
std::vector<int> samplesOf(const TrianglePieces& pieces, int piece, int count) {
    std::vector<int> samples;
    const int step = std::max(1, pieces.counts[piece] / count);
    int seen = 0;
    for (int t = pieces.firsts[piece]; seen < pieces.counts[piece]; ++t) {
        if (pieces.ofTriangle[t] == piece && seen++ % step == 0) {
            samples.push_back(t);
        }
    }
    return samples;
}

bool liesIn(const Bounds& inner, const Bounds& outer) {
    return contains(outer, inner.low) && contains(outer, inner.high);
}

/// Removes from `around` the pieces that do not surround the point.
void keepAround(const TriangleSoup& soup, const std::vector<Triangle>& triangles,
                const TrianglePieces& pieces, const Vec3& point, std::vector<int>& around) {
    std::vector<int> winding(pieces.volumes.size(), 0);
    std::vector<char> asked(pieces.volumes.size(), 0);
    for (const int piece : around) {
        asked[piece] = 1;
    }
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (asked[pieces.ofTriangle[t]] != 0) {
            winding[pieces.ofTriangle[t]] +=
                rayCrossing(cornersOf(soup, triangles[t]), triangles[t], point);
        }
    }
    std::erase_if(around, [&](int piece) { return winding[piece] == 0; });
}

/// Finds in which other pieces each piece lies as a whole, as far as samples tell.
class Nesting {
  public:
    Nesting(const TriangleSoup& soup, const std::vector<Triangle>& triangles,
            const TrianglePieces& pieces)
        : soup_(soup), triangles_(triangles), pieces_(pieces) {}

    /// How many pieces are around each.
    std::vector<int> depths() const {
        std::vector<std::vector<int>> around = boxesAround();
        const auto nested =
            std::ranges::count_if(around, [](const auto& pieces) { return !pieces.empty(); });
        const auto tests =
            static_cast<double>(nested * static_cast<std::ptrdiff_t>(triangles_.size()));
        const int samples = std::max(kLeastSamples, static_cast<int>(kMostTests / (tests + 1)));
        std::vector<int> depths;
        for (int piece = 0; piece < static_cast<int>(around.size()); ++piece) {
            keepThoseAround(piece, samples, around[piece]);
            depths.push_back(static_cast<int>(around[piece].size()));
        }
        return depths;
    }

  private:
    static constexpr int kLeastSamples = 5;
    static constexpr double kMostTests = 3e8;  // of a point with a triangle: about a second

    std::vector<std::vector<int>> boxesAround() const {
        std::vector<int> all(pieces_.bounds.size());
        std::iota(all.begin(), all.end(), 0);
        const BoxTree::BoundsOf boundsOf = [this](int piece) { return pieces_.bounds[piece]; };
        BoxTree tree(all, boundsOf);
        std::vector<std::vector<int>> around(all.size());
        for (const int piece : all) {
            const Bounds& own = pieces_.bounds[piece];
            const auto mayHold = [&](const Bounds& box) { return liesIn(own, box); };
            tree.find(boundsOf, mayHold, [&](int other) {
                if (other != piece && liesIn(own, pieces_.bounds[other])) {
                    around[piece].push_back(other);
                }
            });
        }
        return around;
    }

    void keepThoseAround(int piece, int samples, std::vector<int>& around) const {
        if (around.empty()) {
            return;
        }
        for (const int t : samplesOf(pieces_, piece, samples)) {
            const Vec3 point = pointInside(cornersOf(soup_, triangles_[t]));
            keepAround(soup_, triangles_, pieces_, point, around);
            if (around.empty()) {
                return;
            }
        }
    }

    const TriangleSoup& soup_;
    const std::vector<Triangle>& triangles_;
    const TrianglePieces& pieces_;
};

/// By piece: whether it bounds material from outside or a cavity, and which way it faces.
struct Facing {
    std::vector<bool> cavity;
    std::vector<bool> wrong;

    int wrongPieces() const { return countWrong(false); }
    int wrongCavities() const { return countWrong(true); }
    int cavities() const { return static_cast<int>(std::ranges::count(cavity, true)); }

  private:
    int countWrong(bool ofCavities) const {
        int found = 0;
        for (std::size_t i = 0; i < wrong.size(); ++i) {
            found += wrong[i] && cavity[i] == ofCavities;
        }
        return found;
    }
};

/// A piece inside another one is a cavity, one inside that is material again, and so on.
Facing facingOf(const TriangleSoup& soup, const std::vector<Triangle>& triangles,
                const TrianglePieces& pieces) {
    Facing facing;
    const std::vector<int> depths = Nesting(soup, triangles, pieces).depths();
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const bool cavity = depths[i] % 2 == 1;
        facing.cavity.push_back(cavity);
        facing.wrong.push_back(cavity ? pieces.volumes[i] > 0 : pieces.volumes[i] < 0);
    }
    return facing;
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
    report.vertices = static_cast<int>(soup.positions.size());
    report.triangles = static_cast<int>(soup.triangles.size());
    report.bounds = boundsOf(soup);
    report.nonFiniteVertices = static_cast<int>(
        std::ranges::count_if(soup.positions, [](const Vec3& p) { return !p.allFinite(); }));
    report.outOfRangeIndices = static_cast<int>(std::ranges::count_if(
        soup.triangles, [&](const Triangle& t) { return !isInRange(soup, t); }));
}

std::vector<int> findDegenerateTriangles(const TriangleSoup& soup) {
    std::vector<int> found;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const Triangle& t = soup.triangles[i];
        if (isInRange(soup, t) &&
            (hasRepeatedCorner(t) || areaNormal(cornersOf(soup, t)).isZero(0))) {
            found.push_back(static_cast<int>(i));
        }
    }
    return found;
}

SurfaceFaults findFaultsOf(const TriangleSoup& soup, const std::vector<Triangle>& proper) {
    SurfaceFaults faults;
    const std::vector<Side> sides = sortedSides(proper);
    findEdges(sides, faults);
    faults.nonManifoldVertices = findNonManifoldVertices(proper, sides, soup.positions.size());
    faults.degenerateTriangles = findDegenerateTriangles(soup);
    return faults;
}

void countFaults(const SurfaceFaults& faults, MeshReport& report) {
    report.openEdges = static_cast<int>(faults.openEdges.size());
    report.nonManifoldEdges = static_cast<int>(faults.nonManifoldEdges.size());
    report.misorientedEdges = static_cast<int>(faults.misorientedEdges.size());
    report.nonManifoldVertices = static_cast<int>(faults.nonManifoldVertices.size());
    report.degenerateTriangles = static_cast<int>(faults.degenerateTriangles.size());
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
        {r.outwardCavities, "shell inside another one that faces outward",
         "shells inside another one that face outward",
         "a shell inside another one bounds a cavity; flip its normals in a modelling tool"},
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

SurfaceFaults findSurfaceFaults(const TriangleSoup& welded) {
    return findFaultsOf(welded, properTriangles(welded));
}

MeshReport inspectTriangles(const TriangleSoup& welded) {
    MeshReport report;
    countElements(welded, report);
    const std::vector<Triangle> proper = properTriangles(welded);
    countFaults(findFaultsOf(welded, proper), report);
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
        const Facing facing = facingOf(welded, proper, pieces);
        report.insideOutPieces = facing.wrongPieces();
        report.outwardCavities = facing.wrongCavities();
        report.cavities = facing.cavities();
        report.pieces -= report.cavities;
        report.oriented =
            report.insideOutPieces == 0 && report.outwardCavities == 0 && report.volume > 0;
    }
    report.problem = describeProblem(report);
    report.cuttable = report.problem.empty();
    return report;
}

void turnTriangle(TriangleSoup& soup, int t) {
    std::swap(soup.triangles[t][1], soup.triangles[t][2]);
    TriangleAttributes turned = attributesOf(soup.skin, t);
    std::swap(turned.uvs[1], turned.uvs[2]);
    std::swap(turned.colors[1], turned.colors[2]);
    setAttributes(soup.skin, t, turned);
}

int turnOutward(TriangleSoup& soup) {
    const TrianglePieces pieces = findTrianglePieces(soup, soup.triangles, boundsOf(soup).center());
    const Facing facing = facingOf(soup, soup.triangles, pieces);
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        if (facing.wrong[pieces.ofTriangle[i]]) {
            turnTriangle(soup, static_cast<int>(i));
        }
    }
    return facing.wrongPieces() + facing.wrongCavities();
}

}  // namespace kerf
