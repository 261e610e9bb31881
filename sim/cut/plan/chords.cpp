#include "sim/cut/plan/chords.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

constexpr double kFlat = 1e-5;  // h: faces that are no farther out of one plane are one
constexpr int kChordRounds = 4;

bool triangleHas(const SurfaceMesh& mesh, int t, int v) {
    const Triangle& corners = mesh.triangle(t);
    return std::find(corners.begin(), corners.end(), v) != corners.end();
}

bool liesOnFace(const SurfaceMesh& mesh, const CutNode& node, int t) {
    switch (node.kind) {
        case NodeKind::face:
            return node.a == t;
        case NodeKind::edge:
            return triangleHas(mesh, t, node.a) && triangleHas(mesh, t, node.b);
        case NodeKind::vertex:
            return triangleHas(mesh, t, node.a);
        case NodeKind::wall:
            break;
    }
    return false;
}

// A wall edge between two nodes of one surface face would lie IN the surface and close a chip of
// no thickness.
bool shareFace(const SurfaceMesh& mesh, const CutNode& p, const CutNode& q) {
    if (p.kind == NodeKind::wall || q.kind == NodeKind::wall) {
        return false;
    }
    if (p.kind == NodeKind::vertex && q.kind == NodeKind::vertex) {
        return mesh.findHalfEdge(p.a, q.a) >= 0;
    }
    const CutNode& first = p.kind == NodeKind::vertex ? q : p;
    const CutNode& second = p.kind == NodeKind::vertex ? p : q;
    if (first.kind == NodeKind::face) {
        return liesOnFace(mesh, second, first.a);
    }
    const int h = mesh.findHalfEdge(first.a, first.b);
    return h >= 0 &&
           (liesOnFace(mesh, second, h / 3) || liesOnFace(mesh, second, mesh.twin(h) / 3));
}

double distanceToFace(const SurfaceMesh& mesh, int face, const Vec3& p) {
    const Corners at = cornersOf(mesh, face);
    const Vec3 normal = areaNormal(at);
    return std::fabs(normal.dot(p - at[0])) / std::max(normal.norm(), 1e-300);
}

/// The two faces at a node on an edge, that around a node on a face twice; -1 for others.
std::array<int, 2> facesAt(const SurfaceMesh& mesh, const CutNode& node) {
    if (node.kind == NodeKind::face) {
        return {node.a, node.a};
    }
    const int h = node.kind == NodeKind::edge ? mesh.findHalfEdge(node.a, node.b) : -1;
    return h < 0 ? std::array{-1, -1} : std::array{h / 3, mesh.twin(h) / 3};
}

bool areNeighbors(const SurfaceMesh& mesh, int f, int g) {
    return mesh.twin(3 * f) / 3 == g || mesh.twin(3 * f + 1) / 3 == g ||
           mesh.twin(3 * f + 2) / 3 == g;
}

/// On two faces side by side, in one plane but for `tolerance`.
bool shareFlatFaces(const SurfaceMesh& mesh, const CutNode& p, const CutNode& q, double tolerance) {
    for (const int f : facesAt(mesh, p)) {
        for (const int g : facesAt(mesh, q)) {
            if (f >= 0 && g >= 0 && areNeighbors(mesh, f, g) &&
                distanceToFace(mesh, f, q.position) < tolerance &&
                distanceToFace(mesh, g, p.position) < tolerance) {
                return true;
            }
        }
    }
    return false;
}

class Chords {
  public:
    Chords(const StepInput& in, const PlacesInStrip& places, BorderedSheet& sheet)
        : in_(in), places_(places), sheet_(sheet), plane_(sheet.plane()) {}

    void flipAll() {
        bool flipped = true;
        for (int round = 0; round < kChordRounds && flipped; ++round) {
            flipped = false;
            for (int t = 0; t < plane_.size(); ++t) {
                for (int e = 0; e < 3 && plane_.marked(t); ++e) {
                    if (flipChord(t, e)) {
                        flipped = true;
                        break;
                    }
                }
            }
        }
    }

    // Where no flip helps, an inner point of the blade's surface leads the wall away from the face.
    void liftRest() {
        const int end = plane_.size();
        for (int t = 0; t < end; ++t) {
            for (int e = 0; e < 3 && plane_.marked(t); ++e) {
                if (liftChord(t, e)) {
                    break;
                }
            }
        }
    }

  private:
    bool isChord(int a, int b) const {
        const CutNode* p = sheet_.borderNode(a);
        const CutNode* q = sheet_.borderNode(b);
        return p != nullptr && q != nullptr && shareFace(in_.mesh, *p, *q);
    }

    bool isFlatChord(int a, int b) const {
        const CutNode* p = sheet_.borderNode(a);
        const CutNode* q = sheet_.borderNode(b);
        return p != nullptr && q != nullptr && shareFlatFaces(in_.mesh, *p, *q, kFlat * in_.h);
    }

    bool flipChord(int t, int e) {
        if (plane_.constrained(t, e) || plane_.neighbor(t, e) < 0) {
            return false;
        }
        const Triangle c = plane_.corners(t);
        if (!isChord(c[e], c[(e + 1) % 3]) ||
            isChord(c[(e + 2) % 3], plane_.oppositeVertex(t, e)) || !plane_.convex(t, e)) {
            return false;
        }
        plane_.flip(t, e);
        return true;
    }

    bool liftChord(int t, int e) {
        const int a = plane_.corners(t)[e];
        const int b = plane_.corners(t)[(e + 1) % 3];
        const int neighbor = plane_.neighbor(t, e);
        if (plane_.constrained(t, e) || neighbor < 0 || !(isChord(a, b) || isFlatChord(a, b))) {
            return false;
        }
        const bool wider = doubleArea(t) >= doubleArea(neighbor);
        const int wide = wider ? t : neighbor;
        const int narrow = wider ? neighbor : t;
        const Vec2 p = centerOf(wide);
        const Triangulation::Location at = plane_.locate(p);
        if (at.where != Triangulation::Where::inside || at.triangle != wide) {
            return false;
        }
        sheet_.addInner(p, places_.at(p), at);
        for (int k = 0; k < 3; ++k) {  // unless the new point has flipped it already
            const Triangle& c = plane_.corners(narrow);
            if (edgeOf(c[k], c[(k + 1) % 3]) == edgeOf(a, b) && plane_.convex(narrow, k)) {
                plane_.flip(narrow, k);
                break;
            }
        }
        return true;
    }

    double doubleArea(int t) const {
        const Triangle& c = plane_.corners(t);
        return cross2(plane_.point(c[1]) - plane_.point(c[0]),
                      plane_.point(c[2]) - plane_.point(c[0]));
    }

    Vec2 centerOf(int t) const {
        const Triangle& c = plane_.corners(t);
        return (plane_.point(c[0]) + plane_.point(c[1]) + plane_.point(c[2])) / 3;
    }

    const StepInput& in_;
    const PlacesInStrip& places_;
    BorderedSheet& sheet_;
    Triangulation& plane_;
};

}  // namespace

void clearChords(const StepInput& in, const PlacesInStrip& places, BorderedSheet& sheet) {
    Chords chords(in, places, sheet);
    chords.flipAll();
    chords.liftRest();
}

}  // namespace kerf::cut
