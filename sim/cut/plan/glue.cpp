#include "sim/cut/plan/glue.h"

#include "sim/base/containers.h"
#include "sim/cut/exact/directed_edges.h"

namespace kerf::cut {

namespace {

/// A directed edge between corners of the new triangles.
struct Directed {
    int from;
    int to;
    Directed reversed() const { return {to, from}; }
};

/// Corners without gaps: the nodes, then old vertices in the order in which they are first met.
class CornerNumbers {
  public:
    /// At most `mostOld` vertices are old.
    CornerNumbers(int vertexCount, std::size_t nodes, std::size_t mostOld)
        : vertexCount_(vertexCount), nodes_(static_cast<int>(nodes)), placeOfOld_(mostOld) {}

    int operator[](int corner) {
        return corner >= vertexCount_ ? corner - vertexCount_ : numberOfOld(corner);
    }
    std::size_t count() const { return nodes_ + old_.size(); }
    bool isOld(int number) const { return number >= nodes_; }
    /// Of a number that isOld().
    int vertex(int number) const { return old_[number - nodes_]; }

  private:
    int numberOfOld(int vertex) {
        if (const int known = placeOfOld_.find(vertex); known >= 0) {
            return nodes_ + known;
        }
        placeOfOld_.add(vertex, sizeOf(old_));
        old_.push_back(vertex);
        return nodes_ + sizeOf(old_) - 1;
    }

    int vertexCount_;
    int nodes_;
    VertexNumbers placeOfOld_;
    std::vector<int> old_;
};

/// Both walls have the same triangles, those of W+ turned over: half-edge e of one runs along
/// half-edge 2 - e of the other, backwards. So one table serves both, and what holds inside of one
/// is carried over.
class Gluing {
  public:
    Gluing(const SurfaceMesh& mesh, const CutCurves& curves, const Outline& outline,
           const Subdivision& subdivision, const std::vector<NewTriangle>& triangles)
        : mesh_(mesh),
          triangles_(triangles),
          replaced_(subdivision.replaced),
          firstPlus_(sizeOf(subdivision.triangles)),
          firstMinus_((firstPlus_ + sizeOf(triangles)) / 2),
          // Each is a corner of what is replaced, or a V node.
          numbers_(mesh.vertexCount(), curves.nodes.size(),
                   3 * replaced_.size() + curves.nodeOfVertex.size()) {
        numberCorners();
        const std::vector<Directed> outlineEdges = numberOutline(curves, outline);
        const std::size_t count = numbers_.count();
        onOutline_.assign(count, 0);
        cut_ = free_ = front_ = DirectedEdges(count);
        for (int i = 0; i < sizeOf(outlineEdges); ++i) {
            const auto [from, to] = outlineEdges[i];
            setOf(outline.edges[i].kind).add(from, to, 0);
            onOutline_[from] = onOutline_[to] = 1;
        }
        surface_ = tableOf(0, firstPlus_);
        minus_ = tableOf(firstMinus_, sizeOf(triangles));
    }

    std::vector<GluePartner> run() const {
        std::vector<GluePartner> partners(3 * triangles_.size());
        std::vector<int> alone;  // those whose partner is not theirs by the way it was found
        const auto findAlone = [&](int h) {
            alone.push_back(h);
            partners[h] = partnerOf(h);
        };
        const auto findWithin = [&](int first, int end) {
            for (int h = 3 * first; h < 3 * end; ++h) {
                if (partners[h].newHalfEdge < 0 && !joinInside(h, partners)) {
                    findAlone(h);
                }
            }
        };
        alone.reserve(partners.size());
        findWithin(0, firstPlus_);
        findWithin(firstMinus_, sizeOf(triangles_));
        for (int h = 3 * firstPlus_; h < 3 * firstMinus_; ++h) {
            if (isInside(ends(h))) {
                partners[h].newHalfEdge = mirror(partners[mirror(h)].newHalfEdge);
            } else {
                findAlone(h);
            }
        }
        for (const int h : alone) {
            const int other = partners[h].newHalfEdge;
            if (other >= 0 && partners[other].newHalfEdge != h) {
                throw StepFailure{"the gluing is not mutual"};
            }
        }
        return partners;
    }

  private:
    void numberCorners() {
        corners_.resize(triangles_.size());
        for (int t = 0; t < sizeOf(triangles_); ++t) {
            if (t < firstPlus_ || t >= firstMinus_) {
                const Triangle& c = triangles_[t].corners;
                corners_[t] = {numbers_[c[0]], numbers_[c[1]], numbers_[c[2]]};
            }
        }
        for (int t = firstPlus_; t < firstMinus_; ++t) {
            const Triangle& c = corners_[t + firstMinus_ - firstPlus_];
            corners_[t] = {c[0], c[2], c[1]};
        }
    }

    std::vector<Directed> numberOutline(const CutCurves& curves, const Outline& outline) {
        return mapped(outline.edges, [&](const OutlineEdge& edge) -> Directed {
            return {numbers_[cornerId(mesh_, curves, edge.from)],
                    numbers_[cornerId(mesh_, curves, edge.to)]};
        });
    }

    DirectedEdges tableOf(int first, int end) const {
        DirectedEdges table(numbers_.count());
        table.reserve(3 * static_cast<std::size_t>(end - first));
        for (int h = 3 * first; h < 3 * end; ++h) {
            const Directed edge = ends(h);
            if (!table.add(edge.from, edge.to, h)) {
                throw StepFailure{"two new triangles share a directed edge"};
            }
        }
        return table;
    }

    DirectedEdges& setOf(OutlineKind kind) {
        return kind == OutlineKind::cut ? cut_ : kind == OutlineKind::free ? free_ : front_;
    }

    static bool has(const DirectedEdges& set, const Directed& edge) {
        return set.has(edge.from, edge.to);
    }

    Directed ends(int h) const {
        const int triangle = SurfaceMesh::triangleOf(h);
        const Triangle& corners = corners_[triangle];
        const int corner = h - 3 * triangle;
        return {corners[corner], corners[corner == 2 ? 0 : corner + 1]};
    }

    /// The half-edge of the other wall that runs along a half-edge of a wall.
    int mirror(int h) const {
        const int walls = firstMinus_ - firstPlus_;
        const int triangle = SurfaceMesh::triangleOf(h);
        const int corner = h - 3 * triangle;
        return 3 * (triangle + (h < 3 * firstMinus_ ? walls : -walls)) + 2 - corner;
    }

    /// No edge of the outline, in either direction.
    bool isInside(const Directed& edge) const {
        return onOutline_[edge.from] == 0 || onOutline_[edge.to] == 0;
    }

    /// Gives two half-edges within the surface, or within W-, to each other.
    bool joinInside(int h, std::vector<GluePartner>& partners) const {
        const Directed edge = ends(h);
        const int other =
            isInside(edge) ? (h < 3 * firstPlus_ ? surface_ : minus_).find(edge.to, edge.from) : -1;
        if (other >= 0) {
            partners[h].newHalfEdge = other;
            partners[other].newHalfEdge = h;
        }
        return other >= 0;
    }

    GluePartner partnerOf(int h) const {
        const Directed edge = ends(h);
        switch (triangles_[h / 3].side) {
            case CutSide::surface:
                return ofSurface(edge);
            case CutSide::minus:
                return ofWall(edge, edge, CutSide::minus, CutSide::plus);
            case CutSide::plus:
                break;
        }
        return ofWall(edge, edge.reversed(), CutSide::plus, CutSide::minus);
    }

    GluePartner ofSurface(const Directed& edge) const {
        const Directed back = edge.reversed();
        if (has(cut_, edge) || isOldFront(edge)) {
            return in(CutSide::plus, back);
        }
        if (has(cut_, back) || isOldFront(back)) {
            return in(CutSide::minus, back);
        }
        return inSurfaceOrMesh(back);
    }

    // The two half-edges of an old front edge become twins of the new sheets: the slit grows.
    bool isOldFront(const Directed& edge) const {
        return numbers_.isOld(edge.from) && numbers_.isOld(edge.to) && has(front_, edge);
    }

    // `outlineEdge`: the direction in which the outline would have it.
    GluePartner ofWall(const Directed& edge, const Directed& outlineEdge, CutSide own,
                       CutSide other) const {
        const Directed back = edge.reversed();
        if (has(cut_, outlineEdge)) {
            return in(CutSide::surface, back);
        }
        if (has(free_, outlineEdge)) {
            return in(other, back);
        }
        if (has(front_, outlineEdge)) {
            return inSurfaceOrMesh(back);
        }
        return in(own, back);
    }

    GluePartner in(CutSide side, const Directed& edge) const {
        const int h = find(side, edge);
        if (h < 0) {
            throw StepFailure{"a new half-edge has no partner"};
        }
        return {h, -1};
    }

    /// -1 where there is none.
    int find(CutSide side, const Directed& edge) const {
        if (side != CutSide::plus) {
            return (side == CutSide::surface ? surface_ : minus_).find(edge.from, edge.to);
        }
        const int mirrored = minus_.find(edge.to, edge.from);
        return mirrored < 0 ? -1 : mirror(mirrored);
    }

    GluePartner inSurfaceOrMesh(const Directed& edge) const {
        const int h = find(CutSide::surface, edge);
        if (h >= 0) {
            return {h, -1};
        }
        const bool old = numbers_.isOld(edge.from) && numbers_.isOld(edge.to);
        const int kept =
            old ? mesh_.findHalfEdge(numbers_.vertex(edge.from), numbers_.vertex(edge.to)) : -1;
        if (kept < 0 || std::binary_search(replaced_.begin(), replaced_.end(), kept / 3)) {
            throw StepFailure{"a new half-edge has no partner in the mesh"};
        }
        return {-1, kept};
    }

    const SurfaceMesh& mesh_;
    const std::vector<NewTriangle>& triangles_;
    const std::vector<int>& replaced_;
    int firstPlus_;  ///< triangles: first the surface, then W+, then W-
    int firstMinus_;
    CornerNumbers numbers_;
    std::vector<Triangle> corners_;  ///< of the new triangles, by CornerNumbers
    std::vector<char> onOutline_;    ///< by number
    DirectedEdges cut_{0};
    DirectedEdges free_{0};
    DirectedEdges front_{0};
    DirectedEdges surface_{0};
    DirectedEdges minus_{0};
};

}  // namespace

std::vector<GluePartner> glue(const SurfaceMesh& mesh, const CutCurves& curves,
                              const Outline& outline, const Subdivision& subdivision,
                              const std::vector<NewTriangle>& triangles) {
    return Gluing(mesh, curves, outline, subdivision, triangles).run();
}

}  // namespace kerf::cut
