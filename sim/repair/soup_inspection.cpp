#include "sim/repair/soup_inspection.h"

#include "sim/base/math.h"
#include "sim/base/text.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/union_find.h"
#include "sim/repair/crossings.h"
#include "sim/repair/shell_nesting.h"
#include "sim/repair/soup_editing.h"

namespace kerf {

namespace {

using repair::forEachEdge;
using repair::repeatsCorner;
using repair::Side;
using repair::sidesByEdge;
using repair::SoupShells;

bool isInRange(const TriangleSoup& soup, const Triangle& t) {
    const int count = static_cast<int>(soup.positions.size());
    return std::ranges::all_of(t, [&](int v) { return v >= 0 && v < count; });
}

/// A triangle whose indices are valid and that is more than a line.
bool isProper(const TriangleSoup& soup, const Triangle& t) {
    return isInRange(soup, t) && !repeatsCorner(t);
}

/// The proper triangles of a soup: itself where all are, else a copy without attributes.
class ProperPart {
  public:
    explicit ProperPart(const TriangleSoup& soup) : soup_(soup) {
        const auto proper = [&](const Triangle& t) { return isProper(soup, t); };
        isWhole_ = std::ranges::all_of(soup.triangles, proper);
        if (!isWhole_) {
            part_.positions = soup.positions;
            std::ranges::copy_if(soup.triangles, std::back_inserter(part_.triangles), proper);
        }
    }
    const TriangleSoup& get() const { return isWhole_ ? soup_ : part_; }

  private:
    const TriangleSoup& soup_;
    TriangleSoup part_;
    bool isWhole_ = false;
};

void findEdges(const std::vector<Side>& sides, SurfaceFaults& faults) {
    forEachEdge(sides, [&](const Side* begin, const Side* end) {
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
    forEachEdge(sides, [&](const Side* begin, const Side* end) {
        for (const Side* side = begin + 1; side < end; ++side) {
            for (const int v : {begin->low, begin->high}) {
                corners.join(3 * begin->triangle() + cornerOf(triangles[begin->triangle()], v),
                             3 * side->triangle() + cornerOf(triangles[side->triangle()], v));
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

double totalVolume(const SoupShells& shells) {
    return std::accumulate(shells.volumes.begin(), shells.volumes.end(), 0.0);
}

/// By shell: whether it bounds material from outside or a cavity, and which way it faces.
struct Facing {
    std::vector<char> cavity;
    std::vector<bool> wrong;

    int wrongPieces() const { return countWrong(false); }
    int wrongCavities() const { return countWrong(true); }
    int cavities() const { return static_cast<int>(std::ranges::count(cavity, 1)); }

  private:
    int countWrong(bool ofCavities) const {
        int found = 0;
        for (std::size_t i = 0; i < wrong.size(); ++i) {
            found += wrong[i] && (cavity[i] != 0) == ofCavities;
        }
        return found;
    }
};

Facing facingOf(const TriangleSoup& soup, const SoupShells& shells) {
    Facing facing;
    facing.cavity = repair::nestShells(soup, shells).cavity;
    for (int i = 0; i < shells.size(); ++i) {
        facing.wrong.push_back(facing.cavity[i] != 0 ? shells.volumes[i] > 0
                                                     : shells.volumes[i] < 0);
    }
    return facing;
}

int countFlat(const SoupShells& shells) {
    int flat = 0;
    for (int i = 0; i < shells.size(); ++i) {
        flat += shells.isFlat(i) ? 1 : 0;
    }
    return flat;
}

void countElements(const TriangleSoup& soup, MeshReport& report) {
    report.vertices = static_cast<int>(soup.positions.size());
    report.triangles = static_cast<int>(soup.triangles.size());
    report.bounds = boxOf(soup.positions);
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
            (repeatsCorner(t) ||
             areaNormal(repair::cornersOf(soup, static_cast<int>(i))).isZero(0))) {
            found.push_back(static_cast<int>(i));
        }
    }
    return found;
}

SurfaceFaults findFaultsOf(const TriangleSoup& soup, const std::vector<Triangle>& proper) {
    SurfaceFaults faults;
    const std::vector<Side> sides = sidesByEdge(proper);
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

SurfaceFaults findSurfaceFaults(const TriangleSoup& welded) {
    return findFaultsOf(welded, ProperPart(welded).get().triangles);
}

MeshReport inspectTriangles(const TriangleSoup& welded) {
    MeshReport report;
    countElements(welded, report);
    const ProperPart part(welded);
    const TriangleSoup& proper = part.get();
    countFaults(findFaultsOf(welded, proper.triangles), report);
    const SoupShells shells = repair::measureShells(proper);
    report.pieces = shells.size();
    report.volume = totalVolume(shells);

    const bool sound = report.nonFiniteVertices == 0 && report.outOfRangeIndices == 0;
    report.closed = sound && !proper.triangles.empty() && report.openEdges == 0;
    report.manifold = sound && report.nonManifoldEdges == 0 && report.nonManifoldVertices == 0;
    // Which side is out only a closed surface tells.
    report.oriented = sound && !proper.triangles.empty() && report.misorientedEdges == 0;
    if (report.closed && report.manifold && report.misorientedEdges == 0) {
        report.flatPieces = countFlat(shells);
        const Facing facing = facingOf(proper, shells);
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

int turnOutward(TriangleSoup& soup) {
    const SoupShells shells = repair::measureShells(soup);
    const Facing facing = facingOf(soup, shells);
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        if (facing.wrong[shells.ofTriangle[i]]) {
            turnTriangle(soup, static_cast<int>(i));
        }
    }
    return facing.wrongPieces() + facing.wrongCavities();
}

void countCrossings(const TriangleSoup& welded, MeshReport& report) {
    report.crossingTriangles = static_cast<int>(repair::crossingTriangles(welded).size());
}

}  // namespace kerf
