#include "sim/cut/patch/patch_plan.h"

#include "sim/cut/plan/wall/sheet_border.h"

namespace kerf::cut {

namespace {

constexpr double kNoEdge = 0.01;                 // share of h
constexpr double kDensity = 1.4142135623730951;  // Liepa's alpha: higher is finer
constexpr int kRefinements = 40;
constexpr double kNoArea = 1e-9;  // share of h^2

/// A point of a patch: on the rim of the wound, or at the mean of others.
struct PatchNode {
    Vec3 rest = Vec3::Zero();    ///< [m]
    Vec2 layout = Vec2::Zero();  ///< place in the plane of the wound [m]
    double size = 0;             ///< edge length wanted there [m]
};

class PatchPlanner {
  public:
    PatchPlanner(const SurfaceMesh& mesh, const Wound& wound, double h)
        : mesh_(mesh), wound_(wound), h_(h) {}

    PatchPlan run() {
        requireLoops();
        takeRim();
        layOut();
        BorderedSheet patch = unrefined();
        refine(patch);
        divideKnownEdges(patch);
        std::vector<Triangle> triangles = patch.triangles();
        requireNewEdges(triangles);
        return {std::move(rim_), std::move(inner_), std::move(triangles)};
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
            nodes_.push_back({mesh_.restPosition(v), Vec2::Zero(), edgeLengthAround(v)});
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
        if (!(normal.norm() > kNoArea * h_ * h_)) {
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

    BorderedSheet unrefined() const {
        try {
            return {sheet(), layout_, sizeOf(rim_), h_};
        } catch (const StepFailure&) {  // its border crosses itself
            throw StepFailure{"a flat patch would fold over"};
        }
    }

    void refine(BorderedSheet& patch) {
        bool divided = true;
        for (int round = 0; round < kRefinements && divided; ++round) {
            divided = false;
            const int count = patch.plane().size();
            for (int t = 0; t < count; ++t) {
                if (!patch.plane().marked(t)) {
                    continue;
                }
                const Triangle corners = patch.nodesOf(t);
                if (isCoarse(corners)) {
                    insertMean({corners.begin(), corners.end()},
                               {Triangulation::Where::inside, t, -1}, patch);
                    divided = true;
                }
            }
        }
    }

    /// Its middle is far from all of its corners, against the edges that are wanted here.
    bool isCoarse(const Triangle& corners) const {
        const PatchNode middle = meanOf(corners);
        return std::ranges::all_of(corners, [&](int i) {
            const double distance = kDensity * (middle.rest - nodes_[i].rest).norm();
            return distance > middle.size && distance > nodes_[i].size;
        });
    }

    template <class Nodes>
    PatchNode meanOf(const Nodes& nodes) const {
        const double share = 1.0 / static_cast<double>(nodes.size());
        PatchNode mean;
        for (const int i : nodes) {
            mean.rest += share * nodes_[i].rest;
            mean.layout += share * nodes_[i].layout;
            mean.size += share * nodes_[i].size;
        }
        return mean;
    }

    void insertMean(std::vector<int> nodes, const Triangulation::Location& at,
                    BorderedSheet& patch) {
        const PatchNode& mean = nodes_.emplace_back(meanOf(nodes));
        patch.addInner(mean.layout, mean.rest, at);
        inner_.push_back(std::move(nodes));
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

    bool isOnRim(int node) const { return node < sizeOf(rim_); }

    bool isKnown(int a, int b) const {
        return isOnRim(a) && isOnRim(b) &&
               (hasEdge(plusVertex(a), plusVertex(b)) || hasEdge(minusVertex(a), minusVertex(b)));
    }

    void divideKnownEdges(BorderedSheet& patch) {
        const int count = patch.plane().size();
        for (int t = 0; t < count; ++t) {
            for (int e = 0; e < 3 && patch.plane().marked(t); ++e) {
                const Triangle corners = patch.nodesOf(t);
                const int a = corners[e], b = corners[(e + 1) % 3];
                if (!patch.plane().constrained(t, e) && isKnown(a, b)) {
                    insertMean({a, b}, {Triangulation::Where::onEdge, t, e}, patch);
                }
            }
        }
    }

    /// No two edges of a patch between the same vertices: a vertex may be on the rim twice.
    void requireNewEdges(const std::vector<Triangle>& triangles) const {
        std::set<Edge> edges;
        for (const Triangle& t : triangles) {
            edges.insert({edgeOf(t[0], t[1]), edgeOf(t[1], t[2]), edgeOf(t[2], t[0])});
        }
        for (const auto vertexOf : {&PatchPlanner::plusVertex, &PatchPlanner::minusVertex}) {
            const auto key = [&](int node) {
                return isOnRim(node) ? (this->*vertexOf)(node) : -1 - node;
            };
            std::set<Edge> used;
            for (const auto& [a, b] : edges) {
                if (key(a) == key(b) || !used.insert(edgeOf(key(a), key(b))).second) {
                    throw StepFailure{"the wound touches itself"};
                }
            }
        }
    }

    const SurfaceMesh& mesh_;
    const Wound& wound_;
    double h_;
    std::vector<WoundEdge> rim_;
    std::vector<int> firstOfLoop_;
    std::vector<PatchNode> nodes_;         ///< the rim's first
    std::vector<std::vector<int>> inner_;  ///< what the others are means of
    std::vector<CutNode> layout_;          ///< of the rim
    Vec3 normal_ = Vec3::Zero();
};

}  // namespace

PatchPlan planPatch(const SurfaceMesh& mesh, const Wound& wound, double h) {
    return PatchPlanner(mesh, wound, h).run();
}

}  // namespace kerf::cut
