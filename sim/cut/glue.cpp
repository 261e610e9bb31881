#include "sim/cut/glue.h"

#include <algorithm>
#include <array>

#include "sim/cut/directed_edges.h"
#include "sim/sort_unique.h"

namespace kerf::cut {

namespace {

/// A directed edge between corners of the new triangles.
struct Directed {
    int from;
    int to;
    Directed reversed() const { return {to, from}; }
};

/// Corners without gaps: the old vertices among them in their order, then the nodes.
class CornerNumbers {
  public:
    CornerNumbers(int vertexCount, std::size_t nodes, const Outline& outline,
                  const CutCurves& curves, const std::vector<NewTriangle>& triangles)
        : vertexCount_(vertexCount) {
        const auto note = [this](int corner) {
            if (corner < vertexCount_) {
                old_.push_back(corner);
            }
        };
        for (const NewTriangle& triangle : triangles) {
            std::ranges::for_each(triangle.corners, note);
        }
        for (const OutlineEdge& edge : outline.edges) {
            for (const int node : {edge.from, edge.to}) {
                if (curves.nodes[node].kind == NodeKind::vertex) {
                    note(curves.nodes[node].a);
                }
            }
        }
        sortUnique(old_);
        count_ = old_.size() + nodes;
    }

    std::size_t count() const { return count_; }
    bool isOld(int number) const { return number < sizeOf(old_); }
    /// Of a number that isOld().
    int vertex(int number) const { return old_[number]; }
    int operator[](int corner) const {
        return corner < vertexCount_
                   ? static_cast<int>(std::ranges::lower_bound(old_, corner) - old_.begin())
                   : sizeOf(old_) + corner - vertexCount_;
    }

  private:
    int vertexCount_;
    std::vector<int> old_;
    std::size_t count_ = 0;
};

class Gluing {
  public:
    Gluing(const SurfaceMesh& mesh, const CutCurves& curves, const Outline& outline,
           const Subdivision& subdivision, const std::vector<NewTriangle>& triangles)
        : mesh_(mesh),
          triangles_(triangles),
          replaced_(subdivision.replaced),
          numbers_(mesh.vertexCount(), curves.nodes.size(), outline, curves, triangles),
          cut_(numbers_.count()),
          free_(numbers_.count()),
          front_(numbers_.count()),
          tables_{DirectedEdges(numbers_.count()), DirectedEdges(numbers_.count()),
                  DirectedEdges(numbers_.count())} {
        for (const OutlineEdge& edge : outline.edges) {
            setOf(edge.kind).add(numbers_[cornerId(mesh, curves, edge.from)],
                                 numbers_[cornerId(mesh, curves, edge.to)], 0);
        }
        numberCorners();
        for (int h = 0; h < 3 * sizeOf(triangles); ++h) {
            const Directed edge = ends(h);
            if (!table(triangles[h / 3].sheet).add(edge.from, edge.to, h)) {
                throw StepFailure{"two new triangles share a directed edge"};
            }
        }
    }

    std::vector<GluePartner> run() const {
        std::vector<GluePartner> partners(3 * triangles_.size());
        for (int h = 0; h < sizeOf(partners); ++h) {
            partners[h] = partnerOf(h);
        }
        for (int h = 0; h < sizeOf(partners); ++h) {
            const int other = partners[h].newHalfEdge;
            if (other >= 0 && partners[other].newHalfEdge != h) {
                throw StepFailure{"the gluing is not mutual"};
            }
        }
        return partners;
    }

  private:
    void numberCorners() {
        corners_.reserve(triangles_.size());
        for (const NewTriangle& triangle : triangles_) {
            const Triangle& c = triangle.corners;
            corners_.push_back({numbers_[c[0]], numbers_[c[1]], numbers_[c[2]]});
        }
        for (DirectedEdges& sheet : tables_) {
            sheet.reserve(3 * triangles_.size());
        }
    }

    DirectedEdges& setOf(OutlineKind kind) {
        return kind == OutlineKind::cut ? cut_ : kind == OutlineKind::free ? free_ : front_;
    }
    DirectedEdges& table(Sheet sheet) { return tables_[static_cast<int>(sheet)]; }

    static bool has(const DirectedEdges& set, const Directed& edge) {
        return set.has(edge.from, edge.to);
    }

    Directed ends(int h) const {
        const Triangle& corners = corners_[h / 3];
        return {corners[h % 3], corners[(h % 3 + 1) % 3]};
    }

    GluePartner partnerOf(int h) const {
        const Directed edge = ends(h);
        switch (triangles_[h / 3].sheet) {
            case Sheet::surface:
                return ofSurface(edge);
            case Sheet::minus:
                return ofWall(edge, edge, Sheet::minus, Sheet::plus);
            case Sheet::plus:
                break;
        }
        return ofWall(edge, edge.reversed(), Sheet::plus, Sheet::minus);
    }

    GluePartner ofSurface(const Directed& edge) const {
        const Directed back = edge.reversed();
        if (has(cut_, edge) || isOldFront(edge)) {
            return in(Sheet::plus, back);
        }
        if (has(cut_, back) || isOldFront(back)) {
            return in(Sheet::minus, back);
        }
        return inSurfaceOrMesh(back);
    }

    // The two half-edges of an old front edge become twins of the new sheets: the slit grows.
    bool isOldFront(const Directed& edge) const {
        return numbers_.isOld(edge.from) && numbers_.isOld(edge.to) && has(front_, edge);
    }

    // `outlineEdge`: the direction in which the outline would have it.
    GluePartner ofWall(const Directed& edge, const Directed& outlineEdge, Sheet own,
                       Sheet other) const {
        const Directed back = edge.reversed();
        if (has(cut_, outlineEdge)) {
            return in(Sheet::surface, back);
        }
        if (has(free_, outlineEdge)) {
            return in(other, back);
        }
        if (has(front_, outlineEdge)) {
            return inSurfaceOrMesh(back);
        }
        return in(own, back);
    }

    GluePartner in(Sheet sheet, const Directed& edge) const {
        const int h = tables_[static_cast<int>(sheet)].find(edge.from, edge.to);
        if (h < 0) {
            throw StepFailure{"a new half-edge has no partner"};
        }
        return {h, -1};
    }

    GluePartner inSurfaceOrMesh(const Directed& edge) const {
        const int h = tables_[static_cast<int>(Sheet::surface)].find(edge.from, edge.to);
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
    CornerNumbers numbers_;
    DirectedEdges cut_;
    DirectedEdges free_;
    DirectedEdges front_;
    std::array<DirectedEdges, 3> tables_;
    std::vector<Triangle> corners_;  ///< of the new triangles, by CornerNumbers
};

}  // namespace

std::vector<GluePartner> glue(const SurfaceMesh& mesh, const CutCurves& curves,
                              const Outline& outline, const Subdivision& subdivision,
                              const std::vector<NewTriangle>& triangles) {
    return Gluing(mesh, curves, outline, subdivision, triangles).run();
}

}  // namespace kerf::cut
