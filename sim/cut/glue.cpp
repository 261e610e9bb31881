#include "sim/cut/glue.h"

#include <algorithm>
#include <array>

namespace kerf::cut {

namespace {

using Directed = std::pair<int, int>;

Directed reversed(const Directed& edge) {
    return {edge.second, edge.first};
}

/// Half-edges of one sheet by their end points.
class HalfEdgeTable {
  public:
    void add(const Directed& ends, int h) { entries_.push_back({ends, h}); }

    void finish() {
        std::sort(entries_.begin(), entries_.end());
        const auto same = [](const Entry& p, const Entry& q) { return p.first == q.first; };
        if (std::adjacent_find(entries_.begin(), entries_.end(), same) != entries_.end()) {
            throw StepFailure{"two new triangles share a directed edge"};
        }
    }

    int find(const Directed& ends) const {
        const auto at = std::lower_bound(entries_.begin(), entries_.end(), Entry{ends, -1});
        return at != entries_.end() && at->first == ends ? at->second : -1;
    }

  private:
    using Entry = std::pair<Directed, int>;
    std::vector<Entry> entries_;
};

class DirectedSet {
  public:
    void add(const Directed& edge) { edges_.push_back(edge); }
    void finish() { std::sort(edges_.begin(), edges_.end()); }
    bool has(const Directed& edge) const {
        return std::binary_search(edges_.begin(), edges_.end(), edge);
    }

  private:
    std::vector<Directed> edges_;
};

class Gluing {
  public:
    Gluing(const SurfaceMesh& mesh, const CutCurves& curves, const Outline& outline,
           const Subdivision& subdivision, const std::vector<NewTriangle>& triangles)
        : mesh_(mesh), triangles_(triangles), replaced_(subdivision.replaced) {
        for (const OutlineEdge& edge : outline.edges) {
            setOf(edge.kind).add(
                {cornerId(mesh, curves, edge.from), cornerId(mesh, curves, edge.to)});
        }
        for (DirectedSet* set : {&cut_, &free_, &front_}) {
            set->finish();
        }
        for (int i = 0; i < sizeOf(triangles); ++i) {
            for (int e = 0; e < 3; ++e) {
                table(triangles[i].sheet).add(ends(3 * i + e), 3 * i + e);
            }
        }
        for (HalfEdgeTable& sheet : tables_) {
            sheet.finish();
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
    DirectedSet& setOf(OutlineKind kind) {
        return kind == OutlineKind::cut ? cut_ : kind == OutlineKind::free ? free_ : front_;
    }
    HalfEdgeTable& table(Sheet sheet) { return tables_[static_cast<int>(sheet)]; }

    Directed ends(int h) const {
        const Triangle& corners = triangles_[h / 3].corners;
        return {corners[h % 3], corners[(h % 3 + 1) % 3]};
    }

    GluePartner partnerOf(int h) const {
        switch (triangles_[h / 3].sheet) {
            case Sheet::surface:
                return ofSurface(ends(h));
            case Sheet::minus:
                return ofWall(ends(h), ends(h), Sheet::minus, Sheet::plus);
            case Sheet::plus:
                break;
        }
        return ofWall(ends(h), reversed(ends(h)), Sheet::plus, Sheet::minus);
    }

    GluePartner ofSurface(const Directed& edge) const {
        const Directed back = reversed(edge);
        if (cut_.has(edge) || isOldFront(edge)) {
            return in(Sheet::plus, back);
        }
        if (cut_.has(back) || isOldFront(back)) {
            return in(Sheet::minus, back);
        }
        return inSurfaceOrMesh(back);
    }

    // The two half-edges of an old front edge become twins of the new sheets: the slit grows.
    bool isOldFront(const Directed& edge) const {
        return edge.first < mesh_.vertexCount() && edge.second < mesh_.vertexCount() &&
               front_.has(edge);
    }

    // `outlineEdge`: the direction in which the outline would have it.
    GluePartner ofWall(const Directed& edge, const Directed& outlineEdge, Sheet own,
                       Sheet other) const {
        const Directed back = reversed(edge);
        if (cut_.has(outlineEdge)) {
            return in(Sheet::surface, back);
        }
        if (free_.has(outlineEdge)) {
            return in(other, back);
        }
        if (front_.has(outlineEdge)) {
            return inSurfaceOrMesh(back);
        }
        return in(own, back);
    }

    GluePartner in(Sheet sheet, const Directed& edge) const {
        const int h = tables_[static_cast<int>(sheet)].find(edge);
        if (h < 0) {
            throw StepFailure{"a new half-edge has no partner"};
        }
        return {h, -1};
    }

    GluePartner inSurfaceOrMesh(const Directed& edge) const {
        const int h = tables_[static_cast<int>(Sheet::surface)].find(edge);
        if (h >= 0) {
            return {h, -1};
        }
        const bool old = edge.first < mesh_.vertexCount() && edge.second < mesh_.vertexCount();
        const int kept = old ? mesh_.findHalfEdge(edge.first, edge.second) : -1;
        if (kept < 0 || std::binary_search(replaced_.begin(), replaced_.end(), kept / 3)) {
            throw StepFailure{"a new half-edge has no partner in the mesh"};
        }
        return {-1, kept};
    }

    const SurfaceMesh& mesh_;
    const std::vector<NewTriangle>& triangles_;
    const std::vector<int>& replaced_;
    DirectedSet cut_;
    DirectedSet free_;
    DirectedSet front_;
    std::array<HalfEdgeTable, 3> tables_;
};

}  // namespace

std::vector<GluePartner> glue(const SurfaceMesh& mesh, const CutCurves& curves,
                              const Outline& outline, const Subdivision& subdivision,
                              const std::vector<NewTriangle>& triangles) {
    return Gluing(mesh, curves, outline, subdivision, triangles).run();
}

}  // namespace kerf::cut
