#include "sim/cut/plan/seams.h"

#include "sim/cut/wall_copies.h"

namespace kerf::cut {

namespace {

class Seams {
  public:
    Seams(const StepInput& in, const CutCurves& met) : mesh_(in.mesh), met_(met), curves_(met) {
        for (const auto& [v, way] : in.opening.displacements()) {
            opened_.insert(mesh_.firstCopy(v));
        }
    }

    CutCurves run() {
        for (const auto& [edge, hits] : met_.onEdge) {
            if (isOpened(edge)) {
                faceEdge(edge, hits);
            }
        }
        for (const auto& [key, node] : met_.onFace) {
            if (const int facing = facingWall(key.first); facing >= 0) {
                faceNode(key.second, key.first, facing, node);
            }
        }
        for (const Segment& segment : met_.segments) {
            if (const int facing = facingWall(segment.triangle); facing >= 0) {
                faceSegment(segment, facing);
            }
        }
        return std::move(curves_);
    }

  private:
    bool isOpened(int v) const { return opened_.count(mesh_.firstCopy(v)) > 0; }
    bool isOpened(const Edge& edge) const { return isOpened(edge.first) || isOpened(edge.second); }

    bool isWallEdge(int h) const {
        return mesh_.kind(h / 3) == SurfaceKind::wall ||
               mesh_.kind(mesh_.twin(h) / 3) == SurfaceKind::wall;
    }

    void faceEdge(const Edge& edge, const std::vector<EdgeHit>& hits) {
        if (!isWallEdge(mesh_.findHalfEdge(edge.first, edge.second))) {
            return;
        }
        for (const int u : livingCopies(mesh_, edge.first)) {
            for (const int v : livingCopies(mesh_, edge.second)) {
                const int h = mesh_.findHalfEdge(u, v);
                if (h >= 0 && edgeOf(u, v) != edge) {
                    addHits(hits, edge.first, u, v, h);
                }
            }
        }
    }

    // u is the copy of `first`. Seen open, the two walls may be met at different points of the
    // edge; both take the same one.
    void addHits(const std::vector<EdgeHit>& hits, int first, int u, int v, int h) {
        std::vector<EdgeHit>& facing = curves_.onEdge[edgeOf(u, v)];
        for (const EdgeHit& hit : hits) {
            const bool forwards = curves_.nodes[hit.node].a == first;
            const CutNode node = facingEdgeNode(hit.node, forwards ? u : v, forwards ? v : u);
            const auto known = std::find_if(facing.begin(), facing.end(), [&](const EdgeHit& k) {
                return k.stripTriangle == hit.stripTriangle;
            });
            if (known == facing.end()) {
                facing.push_back({hit.stripTriangle, addSeamNode(node)});
            } else {
                moveTo(node, curves_.nodes[known->node]);
            }
        }
        orderAlong(facing);
        curves_.segmentsOfTriangle[h / 3];
        curves_.segmentsOfTriangle[mesh_.twin(h) / 3];
    }

    int addSeamNode(CutNode node) {
        node.onSeam = true;
        curves_.nodes.push_back(node);
        return sizeOf(curves_.nodes) - 1;
    }

    static void moveTo(const CutNode& place, CutNode& node) {
        node.a = place.a;
        node.b = place.b;
        node.t = place.t;
        node.weights = place.weights;
        node.position = place.position;
        node.rest = place.rest;
        node.velocity = place.velocity;
    }

    CutNode facingEdgeNode(int source, int a, int b) const {
        CutNode node = curves_.nodes[source];
        const auto shift = [&](auto&& quantity) {
            return Vec3((1 - node.t) * (quantity(a) - quantity(node.a)) +
                        node.t * (quantity(b) - quantity(node.b)));
        };
        node.position += shift([&](int v) { return mesh_.position(v); });
        node.rest += shift([&](int v) { return mesh_.restPosition(v); });
        node.velocity += shift([&](int v) { return mesh_.velocity(v); });
        node.a = a;
        node.b = b;
        return node;
    }

    // All from the same end, ascending.
    void orderAlong(std::vector<EdgeHit>& hits) {
        const int start = curves_.nodes[hits.front().node].a;
        for (const EdgeHit& hit : hits) {
            CutNode& node = curves_.nodes[hit.node];
            if (node.a != start) {
                std::swap(node.a, node.b);
                node.t = 1 - node.t;
            }
        }
        std::sort(hits.begin(), hits.end(), [&](const EdgeHit& p, const EdgeHit& q) {
            const double tp = curves_.nodes[p.node].t;
            const double tq = curves_.nodes[q.node].t;
            return tp != tq ? tp < tq : p.stripTriangle < q.stripTriangle;
        });
    }

    /// The corner of triangle t that is a copy of v, -1 where there is none.
    int copyIn(int t, int v) const {
        for (const int corner : mesh_.triangle(t)) {
            if (mesh_.firstCopy(corner) == mesh_.firstCopy(v)) {
                return corner;
            }
        }
        return -1;
    }

    /// The mirror of an opened wall triangle, -1 for others.
    int facingWall(int t) const {
        const Triangle& c = mesh_.triangle(t);
        if (mesh_.kind(t) != SurfaceKind::wall ||
            std::none_of(c.begin(), c.end(), [&](int v) { return isOpened(v); })) {
            return -1;
        }
        return mirrorOf(mesh_, t);
    }

    int cornerOf(int t, int v) const {
        const Triangle& c = mesh_.triangle(t);
        return static_cast<int>(std::find(c.begin(), c.end(), v) - c.begin());
    }

    void faceNode(int stripEdge, int t, int facing, int source) {
        CutNode node = curves_.nodes[source];
        const Vec3 weights = node.weights;
        node.a = facing;
        for (int i = 0; i < 3; ++i) {
            const int from = mesh_.triangle(t)[i];
            const int to = copyIn(facing, from);
            node.weights[cornerOf(facing, to)] = weights[i];
            node.position += weights[i] * (mesh_.position(to) - mesh_.position(from));
            node.rest += weights[i] * (mesh_.restPosition(to) - mesh_.restPosition(from));
            node.velocity += weights[i] * (mesh_.velocity(to) - mesh_.velocity(from));
        }
        const auto known = curves_.onFace.find({facing, stripEdge});
        if (known != curves_.onFace.end()) {
            moveTo(node, curves_.nodes[known->second]);
            return;
        }
        curves_.onFace[{facing, stripEdge}] = addSeamNode(node);
    }

    void faceSegment(const Segment& segment, int facing) {
        const int from = nodeIn(facing, segment, segment.from);
        const int to = nodeIn(facing, segment, segment.to);
        std::vector<int>& known = curves_.segmentsOfTriangle[facing];
        const bool isThere = std::any_of(known.begin(), known.end(), [&](int i) {
            const Segment& s = curves_.segments[i];
            return edgeOf(s.from, s.to) == edgeOf(from, to);
        });
        if (!isThere) {
            known.push_back(sizeOf(curves_.segments));
            curves_.segments.push_back({facing, segment.stripTriangle, to, from});
        }
    }

    /// What stands for the end of a segment in the facing triangle.
    int nodeIn(int facing, const Segment& segment, int id) {
        const CutNode node = curves_.nodes[id];
        if (node.kind == NodeKind::vertex) {
            const int copy = copyIn(facing, node.a);
            return curves_.vertexNode(mesh_, copy, node.layout);
        }
        if (node.kind == NodeKind::face) {
            return curves_.onFace.at({facing, node.stripEdge});
        }
        const Edge edge = edgeOf(copyIn(facing, node.a), copyIn(facing, node.b));
        const auto hits = curves_.onEdge.find(edge);
        if (hits != curves_.onEdge.end()) {
            for (const EdgeHit& hit : hits->second) {
                if (hit.stripTriangle == segment.stripTriangle) {
                    return hit.node;
                }
            }
        }
        throw StepFailure{"a seam does not meet the edge that it faces"};
    }

    const SurfaceMesh& mesh_;
    const CutCurves& met_;  ///< without seams
    CutCurves curves_;
    std::set<int> opened_;  ///< first copies of vertices of which a copy is seen elsewhere
};

}  // namespace

CutCurves withSeams(const StepInput& in, CutCurves curves) {
    return in.opening.empty() ? std::move(curves) : Seams(in, curves).run();
}

}  // namespace kerf::cut
