#include "sim/cut/plan/strip.h"

#include <algorithm>
#include <optional>
#include <set>

#include "sim/cut/common_position.h"
#include "sim/cut/exact/directed_edges.h"
#include "sim/cut/exact/jitter.h"

namespace kerf::cut {

namespace {

// Shares of h, the first of the edge length there.
constexpr double kNewRungSpacing = 0.45;
constexpr double kPinnedDistance = 0.05;
constexpr double kLeastSpacing = 1e-7;
// A blade that has not gone on by this share tells no plane.
constexpr double kLeastWay = 0.01;
constexpr double kOffsetTurn = 0.3;  // of the offset: how much it differs between A and B
// At rest, a vertex nearer to the skin lies on it; and around the front's ends, vertices within the
// reach are seen on the surface with them.
constexpr double kOnSkin = 1e-3;
constexpr double kReachAround = 1.5;
// More vertices than this at one node is not a crossing but a crumpled mesh.
constexpr int kMostVerticesOfNode = 16;

bool areCopies(const SurfaceMesh& mesh, int a, int b) {
    return mesh.copyGroup(a) >= 0 && mesh.copyGroup(a) == mesh.copyGroup(b);
}

double bladeLength(const StepInput& in) {
    return (in.blade.b - in.blade.a).norm();
}

Vec3 seenPosition(const PredicatePositions& positions, const RungNode& node) {
    return node.vertex >= 0 ? positions.withoutPins(node.vertex) : node.position;
}

bool joinsPrevious(const StepInput& in, const PredicatePositions& positions, const Strip& strip,
                   int i) {
    const RungNode& node = in.rung[i];
    if (i == 0 || node.vertex < 0 || in.rung[i - 1].vertex < 0 ||
        sizeOf(strip.nodes.back().vertices) >= kMostVerticesOfNode) {
        return false;
    }
    const double distance = (seenPosition(positions, node) - strip.nodes.back().position).norm();
    const bool closes =
        !in.rung[i - 1].attached && areCopies(in.mesh, node.vertex, in.rung[i - 1].vertex);
    return distance < in.attempt.tolerance * in.h ||
           (closes && distance < in.attempt.closing * in.h);
}

void joinPrevious(const StepInput& in, const PredicatePositions& positions, Strip& strip, int i) {
    StripNode& last = strip.nodes.back();
    const double count = sizeOf(last.vertices);
    if (in.attempt.closing < kCloseDistance) {
        last.position = (last.position * count + seenPosition(positions, in.rung[i])) / (count + 1);
    }
    last.attachedWithin.push_back(in.rung[i - 1].attached);
    last.vertices.push_back(in.rung[i].vertex);
    last.attached = in.rung[i].attached;
}

StripNode oldNode(const StepInput& in, const PredicatePositions& positions, const RungNode& from) {
    StripNode node;
    node.position = seenPosition(positions, from);
    node.s = from.s;
    node.layout = {from.s * bladeLength(in), 0};
    node.attached = from.attached;
    if (from.vertex >= 0) {
        node.vertices = {from.vertex};
    }
    return node;
}

void placeOldRung(const StepInput& in, const PredicatePositions& positions, Strip& strip) {
    strip.nodes.reserve(2 * in.rung.size() + 2);  // the new rung has no more
    for (int i = 0; i < sizeOf(in.rung); ++i) {
        if (joinsPrevious(in, positions, strip, i)) {
            joinPrevious(in, positions, strip, i);
        } else {
            strip.nodes.push_back(oldNode(in, positions, in.rung[i]));
        }
    }
    strip.oldCount = sizeOf(strip.nodes);
    // Across the blade: a node that is led around skin may have the s of another place.
    const Vec3 along = (in.blade.b - in.blade.a).normalized();
    for (const RungNode& node : in.rung) {
        const Vec3 fromA = node.position - in.blade.a;
        strip.height = std::max(strip.height, (fromA - along * along.dot(fromA)).norm());
    }
}

void pinVertices(const StripNode& node, PredicatePositions& positions) {
    for (const int v : node.vertices) {
        positions.pin(v, node.position);
    }
}

std::optional<Vec3> ifNear(const StepInput& in, int v, const std::optional<Vec3>& place) {
    const bool near = place && (*place - in.mesh.position(v)).norm() < kCloseDistance * in.h;
    return near ? place : std::nullopt;
}

/// Where predicates see a vertex that slipped over the surface: where it belongs.
std::optional<Vec3> onSurface(const StepInput& in, int v) {
    return ifNear(in, v, in.surface.flatPosition(v, kOnSkin * in.h));
}

/// Where they see an inner vertex of the front that came out through the surface.
std::optional<Vec3> keptInside(const StepInput& in, int v) {
    return ifNear(in, v,
                  in.surface.insidePosition(in.mesh.restPosition(v), in.mesh.position(v),
                                            kReachAround * in.h));
}

void seeAroundOnSurface(const StepInput& in, const Vec3& p, PredicatePositions& positions) {
    for (const int t : in.broadPhase.query(p, p, p, kReachAround * in.h)) {
        for (const int v : in.mesh.triangle(t)) {
            if ((in.mesh.position(v) - p).norm() < kReachAround * in.h) {
                if (const auto flat = onSurface(in, v)) {
                    positions.pin(v, *flat);
                }
            }
        }
    }
}

void seeFrontOnSurface(const StepInput& in, Strip& strip, PredicatePositions& positions) {
    for (int i = 0; i < strip.oldCount; ++i) {
        StripNode& node = strip.nodes[i];
        for (const int v : node.vertices) {
            const auto flat = onSurface(in, v);
            if (flat && in.attempt.seenAt == SeenAt::aroundOnSurface) {
                seeAroundOnSurface(in, in.mesh.position(v), positions);
            }
            const bool inner = node.attached && strip.attachedBefore(i);
            const auto inside = inner && !flat ? keptInside(in, v) : std::nullopt;
            node.position = flat.value_or(inside.value_or(node.position));
        }
    }
    for (int i = 0; i < strip.oldCount; ++i) {
        pinVertices(strip.nodes[i], positions);
    }
}

void joinTouchingVertices(const StepInput& in, Strip& strip, PredicatePositions& positions) {
    std::set<int> ofRung;
    for (const RungNode& node : in.rung) {
        ofRung.insert(node.vertex);
    }
    const double radius = in.attempt.tolerance * in.h;
    for (int i = 0; i < strip.oldCount; ++i) {
        StripNode& node = strip.nodes[i];
        if (node.vertices.empty()) {
            continue;
        }
        const Vec3& p = node.position;
        std::set<int> found;
        for (const int t : in.broadPhase.query(p, p, p, radius)) {
            for (const int v : in.mesh.triangle(t)) {
                if (ofRung.count(v) == 0 && (in.mesh.position(v) - p).norm() < radius &&
                    found.insert(v).second) {
                    node.touching.push_back(v);
                    positions.pin(v, p);
                }
            }
        }
        if (!node.touching.empty()) {
            pinVertices(node, positions);
        }
    }
}

void separateParameters(const StepInput& in, Strip& strip) {
    for (int i = 1; i < strip.oldCount; ++i) {
        StripNode& node = strip.nodes[i];
        if (node.s <= strip.nodes[i - 1].s) {
            node.s = strip.nodes[i - 1].s + kLeastSpacing * in.h / bladeLength(in);
            node.layout.x() = node.s * bladeLength(in);
        }
    }
}

// Between two ends that stay, the new rung must leave the old one somewhere.
double middleOfFront(const StepInput& in, const Strip& strip) {
    double first = in.span.to;
    double last = in.span.from;
    for (int i = 0; i + 1 < strip.oldCount; ++i) {
        if (strip.nodes[i].attached) {
            first = std::min(first, strip.nodes[i].s);
            last = std::max(last, strip.nodes[i + 1].s);
        }
    }
    return first < last ? 0.5 * (first + last) : 0.5 * (in.span.from + in.span.to);
}

/// A chain of front edges, by its first and its last node.
struct Chain {
    int first;
    int last;
};

/// Those that end at the skin, not at an end of the rung.
std::vector<Chain> chainsInside(const Strip& strip) {
    std::vector<Chain> chains;
    for (int i = 1; i + 1 < strip.oldCount; ++i) {
        if (!strip.attachedBefore(i) && strip.nodes[i].attached) {
            int last = i + 1;
            while (last < strip.oldCount && strip.nodes[last].attached) {
                ++last;
            }
            if (last + 1 < strip.oldCount) {
                chains.push_back({i, last});
            }
        }
    }
    return chains;
}

/// Whether a triangle between the front edge from node `edge` on and the blade at s would lie on
/// the walls behind that edge.
bool foldsBack(const StepInput& in, const Strip& strip, int edge, double s) {
    const StripNode& p = strip.nodes[edge];
    const StripNode& q = strip.nodes[edge + 1];
    const bool stays = s == in.span.from && in.span.holdsFrom;
    const Vec3 apex = stays ? strip.nodes.front().position : bladePoint(in, s);
    const Vec3 along = (q.position - p.position).stableNormalized();
    const Vec3 ahead = bladePoint(in, 0.5 * (p.s + q.s)) - 0.5 * (p.position + q.position);
    return (apex - p.position).dot(ahead - along * along.dot(ahead)) < 0;
}

// A short front leans as it likes: what joins it to the far end of the blade alone may fold back
// onto its walls. A point ahead of its middle keeps the strip before it.
void stayAheadOfShortFronts(const StepInput& in, const Strip& strip,
                            std::vector<double>& parameters) {
    for (const Chain& chain : chainsInside(strip)) {
        const double first = strip.nodes[chain.first].s;
        const double last = strip.nodes[chain.last].s;
        const auto behind = std::ranges::upper_bound(parameters, last);
        if (behind == parameters.begin() || behind == parameters.end() || *(behind - 1) >= first) {
            continue;
        }
        bool folds = false;
        for (int i = chain.first; i < chain.last; ++i) {
            folds |= foldsBack(in, strip, i, *(behind - 1));
        }
        if (folds) {
            parameters.insert(behind, 0.5 * (first + last));
        }
    }
}

// R1 has a point above every interior front node, never above a surface entry: for a straight
// stroke that one would lie exactly in the surface.
std::vector<double> newRungParameters(const StepInput& in, const Strip& strip,
                                      const std::vector<double>& skipped) {
    std::vector<double> result{in.span.from};
    for (int i = 1; i < strip.oldCount - 1; ++i) {
        const StripNode& node = strip.nodes[i];
        const bool interior = node.attached && strip.attachedBefore(i) &&
                              sizeOf(node.vertices) == 1 &&
                              std::find(skipped.begin(), skipped.end(), node.s) == skipped.end();
        if (!interior) {
            continue;
        }
        const double edge =
            in.edgeLengths.localEdgeLength(in.mesh.restPosition(node.vertices.front()));
        const double spacing = kNewRungSpacing * edge / bladeLength(in);
        if (node.s - result.back() > spacing && in.span.to - node.s > spacing) {
            result.push_back(node.s);
        }
    }
    if (result.size() == 1 && in.span.holdsFrom && in.span.holdsTo) {
        result.push_back(middleOfFront(in, strip));
    }
    result.push_back(in.span.to);
    stayAheadOfShortFronts(in, strip, result);
    return result;
}

bool isPinned(const StepInput& in, const Strip& strip, const Vec3& bladeEnd, int oldEnd) {
    return (bladeEnd - strip.nodes[oldEnd].position).norm() <
           kPinnedDistance * std::min(in.h, strip.height);
}

/// Where the old rung is at a parameter of the blade.
Vec3 oldRungAt(const Strip& strip, double s) {
    int i = 1;
    while (i + 1 < strip.oldCount && strip.nodes[i].s < s) {
        ++i;
    }
    const StripNode& p = strip.nodes[i - 1];
    const StripNode& q = strip.nodes[i];
    const double share = q.s > p.s ? std::clamp((s - p.s) / (q.s - p.s), 0.0, 1.0) : 0;
    return p.position + (q.position - p.position) * share;
}

/// The displacement of the blade at parameter s, which is one for a whole transit [m]. One that
/// stays in its plane goes so far on, and hardly aside: nobody can measure that. Not back: what it
/// swept in the air was swept as far as the blade is.
Vec3 offsetAt(const StepInput& in, const Strip& strip, double s) {
    Vec3 offset = bladeOffset(in.offset * in.h, in.attempt.offsetScale, in.seed, in.transit, s);
    if (!in.attempt.staysInPlane) {
        return offset;
    }
    const Vec3 along = (in.blade.b - in.blade.a).normalized();
    const Vec3 way = bladePoint(in, s) - oldRungAt(strip, s);
    const Vec3 ahead = way - along * along.dot(way);
    const Vec3 aside = offset * std::min(1.0, kLeastOffset * in.h / offset.norm());
    return ahead.norm() < kLeastWay * in.h
               ? aside
               : Vec3(aside + ahead * (std::fabs(ahead.dot(offset)) / ahead.squaredNorm()));
}

void placeNewRung(const StepInput& in, const std::vector<double>& skipped, Strip& strip) {
    const std::vector<double> parameters = newRungParameters(in, strip, skipped);
    const int last = sizeOf(parameters) - 1;
    for (int j = 0; j <= last; ++j) {
        const Vec3 onBlade = bladePoint(in, parameters[j]);
        const int oldEnd = j == 0 ? 0 : strip.oldCount - 1;
        const bool held = (j == 0 && in.span.holdsFrom) || (j == last && in.span.holdsTo);
        if (held || ((j == 0 || j == last) && isPinned(in, strip, onBlade, oldEnd))) {
            strip.newRung.push_back(oldEnd);
            continue;
        }
        StripNode node;
        node.position = onBlade + offsetAt(in, strip, parameters[j]);
        node.s = parameters[j];
        node.layout = {node.s * bladeLength(in), strip.height};
        strip.newRung.push_back(sizeOf(strip.nodes));
        strip.nodes.push_back(node);
    }
}

void stitchRungs(const BladeSpan& span, Strip& strip) {
    std::vector<int> lower(strip.oldCount);
    std::vector<double> lowerS(strip.oldCount);
    for (int i = 0; i < strip.oldCount; ++i) {
        lower[i] = i;
        lowerS[i] = strip.nodes[i].s;
    }
    std::vector<double> upperS;
    for (const int node : strip.newRung) {
        upperS.push_back(strip.nodes[node].s);
    }
    upperS.front() = span.from;  // a pinned end keeps its own s on the old rung
    upperS.back() = span.to;
    strip.triangles = stitch(lower, lowerS, strip.newRung, upperS);
    if (strip.triangles.empty()) {
        throw StepFailure{"the blade swept no area"};
    }
}

void connectEdges(const StepInput& in, Strip& strip) {
    DirectedEdges known(strip.nodes.size());
    const std::size_t edges = 2 * strip.triangles.size() + 1;  // of a band
    known.reserve(edges);
    strip.edges.reserve(edges);
    strip.triangleEdges.reserve(strip.triangles.size());
    for (int t = 0; t < sizeOf(strip.triangles); ++t) {
        Triangle ids{};
        for (int e = 0; e < 3; ++e) {
            const int a = strip.triangles[t][e];
            const int b = strip.triangles[t][(e + 1) % 3];
            const auto [low, high] = edgeOf(a, b);
            ids[e] = known.find(low, high);
            if (ids[e] < 0) {
                ids[e] = sizeOf(strip.edges);
                known.add(low, high, ids[e]);
                strip.edges.push_back({a, b, t});
            } else {
                strip.edges[ids[e]].second = t;
            }
        }
        strip.triangleEdges.push_back(ids);
    }
    for (int i = 0; i + 1 < strip.oldCount; ++i) {
        if (!strip.nodes[i].attached) {
            continue;
        }
        const int edge = known.find(i, i + 1);
        if (edge < 0) {
            throw StepFailure{"a front edge is not in the strip"};
        }
        strip.edges[edge].frontOf = in.pieceOfVertex[strip.nodes[i].vertices.back()];
    }
}

}  // namespace

PredicatePositions::PredicatePositions(const StepInput& in)
    : mesh_(in.mesh),
      opening_(!in.opening.empty() ? &in.opening : nullptr),
      closeDistance_(in.attempt.closing * in.h) {}

Vec3 PredicatePositions::at(int v) const {
    if (!pins_.empty()) {
        const auto pin = pins_.find(v);
        if (pin != pins_.end()) {
            return pin->second;
        }
    }
    return withoutPins(v);
}

void PredicatePositions::pinAside(int v, const Vec3& way) {
    asideFrom_[v] = at(v);
    pin(v, at(v) + way);
    asideReach_ = std::max(asideReach_, way.norm());
}

Vec3 PredicatePositions::inStrip(int v) const {
    const auto from = asideFrom_.find(v);
    return from == asideFrom_.end() ? at(v) : from->second;
}

Vec3 PredicatePositions::withoutPins(int v) const {
    const Vec3 position = commonPosition(mesh_, v, closeDistance_);
    return opening_ == nullptr ? position : Vec3(position + opening_->displacement(v));
}

bool StripNode::isCluster() const {
    return std::any_of(attachedWithin.begin(), attachedWithin.end(), [](char c) { return c != 0; });
}

bool Strip::isNew(int node) const {
    return !isOld(node) || node == newRung.front() || node == newRung.back();
}

bool Strip::isRail(int edge) const {
    const Edge ends = edgeOf(edges[edge].a, edges[edge].b);
    return ends == edgeOf(0, newRung.front()) || ends == edgeOf(oldCount - 1, newRung.back());
}

bool Strip::onNewRung(int edge) const {
    const StripEdge& e = edges[edge];
    return isNew(e.a) && isNew(e.b) && !(isOld(e.a) && isOld(e.b)) && !isRail(edge);
}

namespace {

/// Front edges join vertices of one piece only, so what is left of a gap joins nothing.
void dropGap(std::vector<char>& attachedWithin, int vertex) {
    if (!attachedWithin.empty()) {
        const int gap = std::min(vertex, sizeOf(attachedWithin) - 1);
        attachedWithin.erase(attachedWithin.begin() + gap);
    }
}

}  // namespace

Strip Strip::seenBy(int piece, const std::vector<int>& pieceOfVertex) const {
    const auto isOther = [&](int v) { return pieceOfVertex[v] != piece; };
    Strip strip = *this;
    for (StripNode& node : strip.nodes) {
        node.attached = node.attached && !isOther(node.vertices.back());
        std::erase_if(node.touching, isOther);
        for (int i = sizeOf(node.vertices) - 1; i >= 0; --i) {
            if (isOther(node.vertices[i])) {
                node.vertices.erase(node.vertices.begin() + i);
                dropGap(node.attachedWithin, i);
            }
        }
    }
    for (StripEdge& edge : strip.edges) {
        edge.frontOf = edge.frontOf == piece ? piece : -1;
    }
    return strip;
}

Vec3 bladePoint(const StepInput& in, double s) {
    return in.blade.a + (in.blade.b - in.blade.a) * s;
}

Vec3 bladeOffset(double length, double scale, std::uint64_t seed, int transit, double s) {
    // The transit is part of the seed: with equal offsets, strokes through one point and a blade
    // that comes back the same way would meet the older slits exactly.
    Jitter jitter(seed * 977 + static_cast<std::uint64_t>(transit) * 131 +
                  static_cast<std::uint64_t>(scale));
    const Vec3 atA = jitter.direction();
    const Vec3 turn = jitter.direction() * kOffsetTurn;
    return (atA + turn * s) * (length * scale);
}

std::vector<Triangle> stitch(const std::vector<int>& lower, const std::vector<double>& lowerS,
                             const std::vector<int>& upper, const std::vector<double>& upperS) {
    std::vector<Triangle> triangles;
    const auto emit = [&](int a, int b, int c) {
        if (a != b && b != c && a != c) {
            triangles.push_back({a, b, c});
        }
    };
    const int lastLower = sizeOf(lower) - 1;
    const int lastUpper = sizeOf(upper) - 1;
    const bool pinnedStart = upper.front() == lower.front();
    const bool pinnedEnd = upper.back() == lower.back();
    int i = 0;
    int j = 0;
    while (i < lastLower || j < lastUpper) {
        bool advanceLower = i < lastLower && (j == lastUpper || lowerS[i + 1] < upperS[j + 1]);
        if (i == 0 && pinnedStart) {
            advanceLower = j > 0;
        } else if (pinnedEnd && j + 1 == lastUpper && i < lastLower) {
            advanceLower = true;
        } else if (pinnedEnd && i + 1 == lastLower && j + 1 < lastUpper) {
            advanceLower = false;
        }
        if (advanceLower) {
            emit(lower[i], lower[i + 1], upper[j]);
            ++i;
        } else {
            emit(upper[j + 1], upper[j], lower[i]);
            ++j;
        }
    }
    return triangles;
}

Strip buildStrip(const StepInput& in, PredicatePositions& positions,
                 const std::vector<double>& skipped) {
    Strip strip;
    placeOldRung(in, positions, strip);
    for (int i = 0; i < strip.oldCount; ++i) {
        if (sizeOf(strip.nodes[i].vertices) > 1) {
            pinVertices(strip.nodes[i], positions);
        }
    }
    if (in.attempt.seenAt != SeenAt::ownPlace) {
        seeFrontOnSurface(in, strip, positions);
    }
    if (in.attempt.touching) {
        joinTouchingVertices(in, strip, positions);
    }
    separateParameters(in, strip);
    placeNewRung(in, skipped, strip);
    stitchRungs(in.span, strip);
    connectEdges(in, strip);
    return strip;
}

}  // namespace kerf::cut
