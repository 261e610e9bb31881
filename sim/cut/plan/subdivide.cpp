#include "sim/cut/plan/subdivide.h"

#include "sim/cut/exact/directed_edges.h"
#include "sim/cut/exact/triangulation.h"
#include "sim/cut/wall_copies.h"

namespace kerf::cut {

namespace {

/// How many nodes of each kind one triangle has.
struct PatternCount {
    int edgeNodes = 0;
    int faceNodes = 0;
    int vertexNodes = 0;
    int segments = 0;
};

SubdivisionPattern patternOf(const PatternCount& n) {
    if (n.segments == 2) {
        return SubdivisionPattern::twoSegments;
    }
    if (n.segments == 1) {
        if (n.edgeNodes == 1 && n.faceNodes == 1 && n.vertexNodes == 0) {
            return SubdivisionPattern::oneToFour;
        }
        if (n.edgeNodes == 2 && n.faceNodes == 0 && n.vertexNodes == 0) {
            return SubdivisionPattern::oneToThreeA;
        }
        if (n.edgeNodes == 1 && n.faceNodes == 0 && n.vertexNodes == 1) {
            return SubdivisionPattern::oneToTwo;
        }
        if (n.edgeNodes == 0 && n.faceNodes == 1 && n.vertexNodes == 1) {
            return SubdivisionPattern::oneToThreeB;
        }
        if (n.edgeNodes == 0 && n.faceNodes == 2) {
            return SubdivisionPattern::twoKinks;
        }
    }
    return SubdivisionPattern::more;
}

// A point of edge e of the triangle (0,0), (1,0), (0,1), exactly on the line: on the hypotenuse
// x + y = 1 holds in doubles because the smaller coordinate is computed from the larger one.
Vec2 pointOnEdge(int e, double t) {
    if (e == 0) {
        return {t, 0};
    }
    if (e == 2) {
        return {0, 1 - t};
    }
    if (t >= 0.5) {
        return {1 - t, t};
    }
    const double x = 1 - t;
    return {x, 1 - x};
}

// From barycentric coordinates to lengths in the plane of the triangle.
Eigen::Matrix2d triangleMetric(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    Eigen::Matrix2d metric = Eigen::Matrix2d::Identity();
    const double length = ab.norm();
    if (length > 0) {
        metric << length, ab.dot(ac) / length, 0, ab.cross(ac).norm() / length;
    }
    return metric;
}

/// The corners of a triangle, ordered by first copies. Where an older slit is cut again, both
/// of its walls are then divided by the same arithmetic and stay mirrored, also where the
/// Delaunay criterion has ties.
struct CanonicalTriangle {
    Triangle corners;
    std::array<int, 3> order{0, 1, 2};  ///< their places in the mesh triangle
    bool mirrored = false;
};

CanonicalTriangle canonicalTriangle(const SurfaceMesh& mesh, int m) {
    const Triangle& in = mesh.triangle(m);
    CanonicalTriangle out{in};
    const auto sortPair = [&](int i, int j) {
        if (mesh.firstCopy(out.corners[j]) < mesh.firstCopy(out.corners[i])) {
            std::swap(out.corners[i], out.corners[j]);
            std::swap(out.order[i], out.order[j]);
            out.mirrored = !out.mirrored;
        }
    };
    sortPair(0, 1);
    sortPair(1, 2);
    sortPair(0, 1);
    return out;
}

class TriangleSubdivision {
  public:
    TriangleSubdivision(const SurfaceMesh& mesh, const CutCurves& curves, int m,
                        double closeDistance)
        : mesh_(mesh),
          curves_(curves),
          m_(m),
          canonical_(canonicalTriangle(mesh, m)),
          corners_(canonical_.corners),
          plane_({0, 0}, {1, 0}, {0, 1}),
          ids_(corners_.begin(), corners_.end()) {
        const auto at = [&](int i) { return commonPosition(mesh, corners_[i], closeDistance); };
        plane_.setMetric(triangleMetric(at(0), at(1), at(2)));
        for (int i = 0; i < 3; ++i) {
            vertexOf_.add(corners_[i], i);
        }
    }

    void run(std::vector<int> segments) {
        addEdgeNodes();
        addFaceNodes();
        std::sort(segments.begin(), segments.end(), [&](int p, int q) {
            return curves_.segments[p].stripTriangle < curves_.segments[q].stripTriangle;
        });
        for (const int segment : segments) {
            addSegment(curves_.segments[segment]);
        }
        count_.segments = sizeOf(segments);
    }

    void emit(Subdivision& result) const {
        ++result.patterns[static_cast<int>(patternOf(count_))];
        result.replaced.push_back(m_);
        for (int t = 0; t < plane_.size(); ++t) {
            Triangle c = plane_.corners(t);
            if (canonical_.mirrored) {
                std::swap(c[1], c[2]);
            }
            result.triangles.push_back({{ids_[c[0]], ids_[c[1]], ids_[c[2]]},
                                        CutSide::surface,
                                        mesh_.kind(m_),
                                        mesh_.wallLabel(m_)});
            result.parents.push_back(m_);
        }
    }

  private:
    void addPoint(int node, const Vec2& at) {
        const Triangulation::Insertion inserted = plane_.insert(at);
        if (inserted.vertex != sizeOf(ids_) || inserted.existed) {
            throw StepFailure{"two curve nodes coincide in a triangle"};
        }
        ids_.push_back(cornerId(mesh_, curves_, node));
        vertexOf_.add(ids_.back(), inserted.vertex);
    }

    void addEdgeNodes() {
        for (int e = 0; e < 3; ++e) {
            const auto hits = curves_.onEdge.find(edgeOf(corners_[e], corners_[(e + 1) % 3]));
            if (hits == curves_.onEdge.end()) {
                continue;
            }
            std::vector<EdgeHit> along = hits->second;
            if (curves_.nodes[along.front().node].a != corners_[e]) {
                std::reverse(along.begin(), along.end());
            }
            for (const EdgeHit& hit : along) {
                const CutNode& node = curves_.nodes[hit.node];
                addPoint(hit.node, pointOnEdge(e, node.a == corners_[e] ? node.t : 1 - node.t));
                ++count_.edgeNodes;
            }
        }
    }

    void addFaceNodes() {
        const auto& onFace = curves_.onFace;
        for (auto at = onFace.lower_bound({m_, -1}); at != onFace.end() && at->first.first == m_;
             ++at) {
            const Vec3& weights = curves_.nodes[at->second].weights;
            addPoint(at->second, {weights[canonical_.order[1]], weights[canonical_.order[2]]});
            ++count_.faceNodes;
        }
    }

    void addSegment(const Segment& segment) {
        std::array<int, 2> ends{};
        const std::array<int, 2> nodes{segment.from, segment.to};
        for (int i = 0; i < 2; ++i) {
            ends[i] = vertexOf_.find(cornerId(mesh_, curves_, nodes[i]));
            if (ends[i] < 0) {
                throw StepFailure{"a curve ends outside its triangle"};
            }
            count_.vertexNodes += curves_.nodes[nodes[i]].kind == NodeKind::vertex;
        }
        if (!plane_.constrain(ends[0], ends[1])) {
            throw StepFailure{"curves cross in a triangle"};
        }
    }

    const SurfaceMesh& mesh_;
    const CutCurves& curves_;
    int m_;
    CanonicalTriangle canonical_;
    Triangle corners_;
    Triangulation plane_;
    std::vector<int> ids_;
    VertexNumbers vertexOf_;
    PatternCount count_;
};

// An edge or face with nodes and no curve through it would leave a hole.
void requireComplete(const SurfaceMesh& mesh, const CutCurves& curves) {
    const auto isReplaced = [&](int t) { return curves.segmentsOfTriangle.count(t) > 0; };
    for (const auto& [edge, hits] : curves.onEdge) {
        const int h = mesh.findHalfEdge(edge.first, edge.second);
        if (h < 0 || !isReplaced(h / 3) || !isReplaced(mesh.twin(h) / 3)) {
            throw StepFailure{"the curve stops at an edge"};
        }
    }
    for (const auto& [key, node] : curves.onFace) {
        if (!isReplaced(key.first)) {
            throw StepFailure{"the curve stops in a triangle"};
        }
    }
}

}  // namespace

int cornerId(const SurfaceMesh& mesh, const CutCurves& curves, int node) {
    return curves.nodes[node].kind == NodeKind::vertex ? curves.nodes[node].a
                                                       : mesh.vertexCount() + node;
}

Subdivision subdivide(const SurfaceMesh& mesh, const CutCurves& curves, double closeDistance) {
    requireComplete(mesh, curves);
    Subdivision result;
    for (const auto& [m, segments] : curves.segmentsOfTriangle) {
        TriangleSubdivision triangle(mesh, curves, m, closeDistance);
        triangle.run(segments);
        triangle.emit(result);
    }
    return result;
}

}  // namespace kerf::cut
