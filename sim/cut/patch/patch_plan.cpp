#include "sim/cut/patch/patch_plan.h"

#include "sim/cut/plan/wall/ears.h"

namespace kerf::cut {

namespace {

// Liepa's alpha: higher is finer.
constexpr double kNoEdge = 0.01;  // share of h
constexpr double kDensity = 1.4142135623730951;
constexpr int kRefinements = 40;
// Of the squared edge length: what folds over less than this is rounding.
constexpr double kFolded = 1e-9;

class PatchPlanner {
  public:
    PatchPlanner(const SurfaceMesh& mesh, const Wound& wound, double h)
        : mesh_(mesh), wound_(wound), h_(h) {}

    PatchPlan run() {
        requireLoops();
        takeRim();
        layOut();
        PatchSurface patch(nodes_, cutEars(sheet(), layout_, h_));
        patch.relax();
        refine(patch);
        divideKnownEdges(patch);
        requireUnfolded(patch);
        requireNewEdges(patch);
        return {std::move(rim_), patch.nodes(), patch.triangles()};
    }

  private:
    void requireLoops() const {
        if (wound_.endsInside) {
            throw StepFailure{"the stroke ended inside the body"};
        }
        if (wound_.unmirrored || wound_.loops.empty()) {
            throw StepFailure{"the two sides of the wound differ"};
        }
    }

    void takeRim() {
        for (const std::vector<WoundEdge>& loop : wound_.loops) {
            firstOfLoop_.push_back(sizeOf(rim_));
            rim_.insert(rim_.end(), loop.begin(), loop.end());
        }
        firstOfLoop_.push_back(sizeOf(rim_));
        for (const WoundEdge& edge : rim_) {
            const int v = mesh_.origin(edge.plus);
            nodes_.push_back({{}, mesh_.restPosition(v), Vec2::Zero(), edgeLengthAround(v)});
        }
    }

    /// Mean rest length of the edges around a vertex that are part of the surface, but for those
    /// that lead nowhere: the blade passed at the vertex.
    double edgeLengthAround(int v) const {
        double sum = 0;
        int count = 0;
        mesh_.forEachOutgoing(v, [&](int h) {
            const double length =
                (mesh_.restPosition(mesh_.target(h)) - mesh_.restPosition(v)).norm();
            const bool isThere = !mesh_.absent(h / 3) || !mesh_.absent(mesh_.twin(h) / 3);
            if (isThere && length > kNoEdge * h_) {
                sum += length;
                ++count;
            }
        });
        return count > 0 ? sum / count : h_;
    }

    Vec3 areaOf(int loop) const {
        Vec3 sum = Vec3::Zero();
        const Vec3& origin = nodes_[firstOfLoop_[loop]].rest;
        for (int i = firstOfLoop_[loop]; i < firstOfLoop_[loop + 1]; ++i) {
            sum += (nodes_[i].rest - origin).cross(nodes_[nextOf(loop, i)].rest - origin) / 2;
        }
        return sum;
    }

    int nextOf(int loop, int i) const {
        return i + 1 < firstOfLoop_[loop + 1] ? i + 1 : firstOfLoop_[loop];
    }

    int loopCount() const { return sizeOf(firstOfLoop_) - 1; }

    void layOut() {
        Vec3 normal = Vec3::Zero();
        for (int loop = 0; loop < loopCount(); ++loop) {
            normal += areaOf(loop);
        }
        if (!(normal.norm() > kFolded * h_ * h_)) {
            throw StepFailure{"the wound has no area"};
        }
        normal.normalize();
        const Vec3 x = normal.unitOrthogonal();
        const Vec3 y = normal.cross(x);
        const Vec3 origin = nodes_.front().rest;
        layout_.resize(nodes_.size());
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const Vec3 way = nodes_[i].rest - origin;
            nodes_[i].layout = layout_[i].layout = {way.dot(x), way.dot(y)};
        }
        normal_ = normal;
    }

    Sheet2d sheet() const {
        int outer = 0;
        for (int loop = 1; loop < loopCount(); ++loop) {
            outer = areaOf(loop).dot(normal_) > areaOf(outer).dot(normal_) ? loop : outer;
        }
        Sheet2d sheet{loopEdges(outer), {}};
        for (int loop = 0; loop < loopCount(); ++loop) {
            if (loop != outer) {
                sheet.holes.push_back(loopEdges(loop));
            }
        }
        return sheet;
    }

    Loop loopEdges(int loop) const {
        Loop edges;
        for (int i = firstOfLoop_[loop]; i < firstOfLoop_[loop + 1]; ++i) {
            edges.push_back({i, nextOf(loop, i), OutlineKind::cut, 0});
        }
        return edges;
    }

    static void refine(PatchSurface& patch) {
        bool divided = true;
        for (int round = 0; round < kRefinements && divided; ++round) {
            divided = false;
            const int count = sizeOf(patch.triangles());
            for (int t = 0; t < count; ++t) {
                if (isCoarse(patch, t)) {
                    patch.splitTriangle(t);
                    divided = true;
                }
            }
            patch.relax();
        }
    }

    /// Its middle is far from all of its corners, against the edges that are wanted here.
    static bool isCoarse(const PatchSurface& patch, int t) {
        const Triangle& corners = patch.triangles()[t];
        Vec3 middle = Vec3::Zero();
        double size = 0;
        for (const int i : corners) {
            middle += patch.nodes()[i].rest / 3;
            size += patch.nodes()[i].size / 3;
        }
        return std::ranges::all_of(corners, [&](int i) {
            const PatchNode& node = patch.nodes()[i];
            const double distance = kDensity * (middle - node.rest).norm();
            return distance > size && distance > node.size;
        });
    }

    int plusVertex(int node) const { return mesh_.origin(rim_[node].plus); }
    int minusVertex(int node) const { return mesh_.target(rim_[node].minus); }

    /// The surface has an edge between these that stays.
    bool hasEdge(int u, int v) const {
        const int h = mesh_.findHalfEdge(u, v);
        return h >= 0 && !(isReplaced(h / 3) && isReplaced(mesh_.twin(h) / 3));
    }

    bool isReplaced(int t) const {
        return std::ranges::binary_search(wound_.plus, t) ||
               std::ranges::find(wound_.minus, t) != wound_.minus.end();
    }

    bool isKnown(const PatchSurface& patch, int h) const {
        const int a = patch.origin(h);
        const int b = patch.target(h);
        return patch.twin(h) >= 0 && patch.onRim(a) && patch.onRim(b) &&
               (hasEdge(plusVertex(a), plusVertex(b)) || hasEdge(minusVertex(a), minusVertex(b)));
    }

    void divideKnownEdges(PatchSurface& patch) const {
        const int count = 3 * sizeOf(patch.triangles());
        for (int h = 0; h < count; ++h) {
            if (isKnown(patch, h)) {
                patch.splitEdge(h);
            }
        }
    }

    void requireUnfolded(const PatchSurface& patch) const {
        for (const auto& [a, b, c] : patch.triangles()) {
            if (patch.doubleArea(a, b, c) < -kFolded * h_ * h_) {
                throw StepFailure{"a flat patch would fold over"};
            }
        }
    }

    /// No two edges of a patch between the same vertices: a vertex may be on the rim twice.
    void requireNewEdges(const PatchSurface& patch) const {
        for (const auto vertexOf : {&PatchPlanner::plusVertex, &PatchPlanner::minusVertex}) {
            std::map<Edge, int> uses;
            for (int h = 0; h < 3 * sizeOf(patch.triangles()); ++h) {
                if (h < patch.twin(h) || patch.twin(h) < 0) {
                    const auto key = [&](int node) {
                        return patch.onRim(node) ? (this->*vertexOf)(node) : -1 - node;
                    };
                    const Edge edge = edgeOf(key(patch.origin(h)), key(patch.target(h)));
                    if (edge.first == edge.second || ++uses[edge] > 1) {
                        throw StepFailure{"the wound touches itself"};
                    }
                }
            }
        }
    }

    const SurfaceMesh& mesh_;
    const Wound& wound_;
    double h_;
    std::vector<WoundEdge> rim_;
    std::vector<int> firstOfLoop_;
    std::vector<PatchNode> nodes_;
    std::vector<CutNode> layout_;
    Vec3 normal_ = Vec3::Zero();
};

}  // namespace

PatchPlan planPatch(const SurfaceMesh& mesh, const Wound& wound, double h) {
    return PatchPlanner(mesh, wound, h).run();
}

}  // namespace kerf::cut
