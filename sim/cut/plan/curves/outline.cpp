#include "sim/cut/plan/curves/outline.h"

#include <Eigen/Dense>

#include "sim/cut/plan/curves/inside_out.h"

namespace kerf::cut {

namespace {

constexpr double kShiftRidge = 1e-6;  // of the trace, towards a shift

struct KnownOffset {
    Vec3 position;
    Vec3 offset;  ///< rest - position
};

std::vector<KnownOffset> knownOffsets(const StepInput& in, const Strip& strip,
                                      const CutCurves& curves) {
    std::vector<KnownOffset> places;
    for (const CutNode& node : curves.nodes) {
        if (node.kind != NodeKind::wall) {
            places.push_back({node.position, node.rest - node.position});
        }
    }
    for (const StripNode& node : strip.nodes) {
        for (const int v : node.vertices) {
            const Vec3& position = in.mesh.position(v);
            places.push_back({position, in.mesh.restPosition(v) - position});
        }
    }
    return places;
}

/// The part of an outline that lies in one piece of the body.
class OutlineOfPiece {
  public:
    /// `strip`: as the piece sees it; `whole`: with what belongs to others. `firstNode`: the number
    /// of the first node that it adds.
    OutlineOfPiece(const StepInput& in, const Strip& strip, const Strip& whole,
                   const RestGuess& guess, int piece, const CutCurves& curves, int firstNode)
        : in_(in),
          strip_(strip),
          whole_(whole),
          guess_(guess),
          piece_(piece),
          curves_(curves),
          firstNode_(firstNode) {}

    Outline run() {
        std::vector<Segment> segments;
        std::ranges::copy_if(curves_.segments, std::back_inserter(segments), [&](auto& segment) {
            return in_.pieceOfVertex[in_.mesh.triangle(segment.triangle)[0]] == piece_;
        });
        points_ = tellInsideOut(in_, strip_, borderPoints(in_, strip_, piece_, curves_, segments));
        if (segments.empty() && std::ranges::none_of(points_, &BorderPoint::inside)) {
            return {};
        }
        for (const Segment& segment : segments) {
            addEdge(segment.from, segment.to, OutlineKind::cut);
        }
        for (int i = 0; i < sizeOf(points_); ++i) {
            if (points_[i].inside) {
                addPart(i, (i + 1) % sizeOf(points_));
            }
        }
        return std::move(outline_);
    }

  private:
    void addEdge(int from, int to, OutlineKind kind) {
        outline_.edges.push_back({from, to, kind, piece_});
    }

    const CutNode& at(int node) const {
        return node < sizeOf(curves_.nodes) ? curves_.nodes[node]
                                            : outline_.nodes[node - firstNode_];
    }

    int add(const CutNode& node) {
        outline_.nodes.push_back(node);
        return firstNode_ + sizeOf(outline_.nodes) - 1;
    }

    int vertexNode(int v, const Vec2& layout) {
        if (const int known = curves_.nodeOfVertex.find(v); known >= 0) {
            return known;
        }
        int made = madeAtVertex_.find(v);
        if (made < 0) {
            made = add(nodeAtVertex(in_.mesh, v, layout));
            madeAtVertex_.add(v, made);
        }
        return made;
    }

    /// The part of the border between two points that lies inside.
    void addPart(int i, int j) {
        const BorderPoint& point = points_[i];
        if (point.link == Link::none) {
            throw StepFailure{"the gap in the front lies inside"};
        }
        const int from = nodeAt(i);
        const int to = nodeAt(j);
        if (point.isOnFront(strip_)) {
            addEdge(from, to, OutlineKind::front);
        } else {
            addFreeEdge(i, j, from, to);
        }
    }

    void addFreeEdge(int i, int j, int from, int to) {
        const int edge = points_[i].edge;
        const bool newRung = strip_.onNewRung(edge);
        if (!newRung) {
            requireNoStub(edge);
        }
        addFreePiece(from, to, points_[i].parameter(strip_), points_[j].parameter(strip_), newRung);
        if (newRung) {
            outline_.endBInside |= points_[i].stripNode == strip_.newRung.back();
            outline_.endAInside |= points_[j].stripNode == strip_.newRung.front();
        }
        const bool frontEnds = !points_[j].inside || points_[j].link != Link::stripEdge ||
                               !strip_.onNewRung(points_[j].edge);
        if (newRung && frontEnds) {
            outline_.front.push_back({points_[j].parameter(strip_), to, false});
        }
    }

    // What lies behind the old rung is never swept: the body would stay connected there. So would
    // a piece on the other side of an older slit, into which the front runs on.
    void requireNoStub(int edge) const {
        const StripEdge& e = strip_.edges[edge];
        const bool onOldRung = strip_.isOld(e.a) && strip_.isOld(e.b);
        const bool besideFront =
            !whole_.nodes[e.a].vertices.empty() || !whole_.nodes[e.b].vertices.empty();
        if (onOldRung && besideFront) {
            throw StepFailure{"a free piece beside the old front"};
        }
    }

    Vec3 restOf(const CutNode& node) const {
        return node.kind == NodeKind::wall ? guess_.at(node.position) : node.rest;
    }

    /// Where to divide a piece of the new rung, whose rim is where it meets the surface.
    std::vector<double> divideRung(const CutNode& start, const CutNode& end, double length,
                                   double sFrom, double sTo) const {
        const Vec3 from = restOf(start);
        const Vec3 to = restOf(end);
        const auto edgeAt = [&](const Vec3& rest) { return in_.edgeLengths.localEdgeLength(rest); };
        const auto wantedLengthAt = [&](double share) {
            double wanted =
                strip_.spacing.at(std::lerp(sFrom, sTo, share), edgeAt(from + (to - from) * share));
            if (start.kind != NodeKind::wall) {
                wanted = std::min(wanted, in_.grading.grown(edgeAt(from), length * share));
            }
            if (end.kind != NodeKind::wall) {
                wanted = std::min(wanted, in_.grading.grown(edgeAt(to), length * (1 - share)));
            }
            return wanted;
        };
        return divideByLength(length, std::min(edgeAt(from), edgeAt(to)), wantedLengthAt);
    }

    std::vector<double> divide(const CutNode& start, const CutNode& end, double sFrom, double sTo,
                               bool newRung) const {
        const double length = (end.position - start.position).norm();
        return newRung && in_.grading.isOn()
                   ? divideRung(start, end, length, sFrom, sTo)
                   : divideByEdgeLength(in_.edgeLengths, restOf(start), restOf(end), length);
    }

    // Samples a free piece at the spacing of the edges around.
    void addFreePiece(int from, int to, double sFrom, double sTo, bool newRung) {
        const CutNode start = at(from);
        const CutNode end = at(to);
        int previous = from;
        double done = 0;
        for (const double share : divide(start, end, sFrom, sTo, newRung)) {
            int next = to;
            if (share < 1) {
                CutNode node;
                node.position = start.position + (end.position - start.position) * share;
                node.layout = start.layout + (end.layout - start.layout) * share;
                next = add(node);
            }
            addEdge(previous, next, OutlineKind::free);
            if (newRung) {
                outline_.front.push_back({sFrom + (sTo - sFrom) * done, previous, true});
            }
            previous = next;
            done = share;
        }
    }

    int nodeAt(int i) {
        BorderPoint& point = points_[i];
        if (point.node >= 0) {
            return point.node;
        }
        const StripNode& strip = strip_.nodes[point.stripNode];
        if (point.vertex >= 0) {
            return point.node = vertexNode(point.vertex, strip.layout);
        }
        if (strip.vertices.size() > 1) {
            throw StepFailure{"two front vertices at one point and no curve"};
        }
        CutNode node;
        node.position = strip.position;
        node.layout = strip.layout;
        return point.node = add(node);
    }

    const StepInput& in_;
    const Strip& strip_;
    const Strip& whole_;
    const RestGuess& guess_;
    int piece_;
    const CutCurves& curves_;
    int firstNode_;
    std::vector<BorderPoint> points_;
    VertexNumbers madeAtVertex_;
    Outline outline_;
};

void join(Outline& sum, const Outline& part) {
    sum.nodes.insert(sum.nodes.end(), part.nodes.begin(), part.nodes.end());
    sum.edges.insert(sum.edges.end(), part.edges.begin(), part.edges.end());
    sum.front.insert(sum.front.end(), part.front.begin(), part.front.end());
    sum.endAInside |= part.endAInside;
    sum.endBInside |= part.endBInside;
}

// Runs of attached points stay together; those of all pieces take turns from B to A.
void sortRuns(std::vector<FrontPoint>& front) {
    std::vector<std::vector<FrontPoint>> runs(1);
    for (const FrontPoint& point : front) {
        runs.back().push_back(point);
        if (!point.attached) {
            runs.emplace_back();
        }
    }
    runs.pop_back();
    std::stable_sort(runs.begin(), runs.end(), [](const auto& p, const auto& q) {
        return p.front().s + p.back().s > q.front().s + q.back().s;
    });
    front.clear();
    for (const std::vector<FrontPoint>& run : runs) {
        front.insert(front.end(), run.begin(), run.end());
    }
}

void requireClosed(const Outline& outline, const std::vector<CutNode>& nodes) {
    std::vector<int> out(nodes.size() + outline.nodes.size(), 0);
    std::vector<int> in(out.size(), 0);
    for (const OutlineEdge& edge : outline.edges) {
        ++out[edge.from];
        ++in[edge.to];
    }
    for (int i = 0; i < sizeOf(out); ++i) {
        const int added = i - sizeOf(nodes);
        const CutNode& node = added < 0 ? nodes[i] : outline.nodes[added];
        const bool crossing = out[i] > 1 && node.kind != NodeKind::vertex;
        if (out[i] != in[i] || crossing) {
            throw StepFailure{"the border of the wall is not closed"};
        }
    }
}

}  // namespace

RestGuess::RestGuess(const StepInput& in, const Strip& strip, const CutCurves& curves) {
    if (in.atRest || in.edgeLengths.isEven()) {
        return;
    }
    const std::vector<KnownOffset> places = knownOffsets(in, strip, curves);
    if (places.empty()) {
        return;
    }
    for (const KnownOffset& place : places) {
        center_ += place.position / sizeOf(places);
        offset_ += place.offset / sizeOf(places);
    }
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d offsets = Eigen::Matrix3d::Zero();
    for (const KnownOffset& place : places) {
        const Vec3 q = place.position - center_;
        spread += q * q.transpose();
        offsets += (place.offset - offset_) * q.transpose();
    }
    spread.diagonal().array() += kShiftRidge * spread.trace() + 1e-300;
    change_ = offsets * spread.inverse();
}

Outline traceOutline(const StepInput& in, const Strip& strip, const RestGuess& guess,
                     const CutCurves& curves) {
    const std::set<int> pieces = piecesInStrip(in, strip, curves);
    Outline outline;
    for (const int piece : pieces) {
        const Strip seen = strip.seenBy(piece, in.pieceOfVertex);
        const int firstNode = sizeOf(curves.nodes) + sizeOf(outline.nodes);
        join(outline, OutlineOfPiece(in, seen, strip, guess, piece, curves, firstNode).run());
    }
    if (pieces.size() > 1) {
        sortRuns(outline.front);
    }
    requireClosed(outline, curves.nodes);
    return outline;
}

}  // namespace kerf::cut
