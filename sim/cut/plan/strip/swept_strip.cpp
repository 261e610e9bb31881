#include "sim/cut/plan/strip/swept_strip.h"

#include "sim/cut/blade.h"
#include "sim/cut/exact/directed_edges.h"
#include "sim/cut/plan/strip/new_rung.h"

namespace kerf::cut {

namespace {

constexpr double kLeastSpacing = 1e-7;  // share of h
// Shares of h: at rest, a vertex nearer to the skin lies on it; and around the front's ends,
// vertices within the reach are seen on the surface with them.
constexpr double kOnSkin = 1e-3;
constexpr double kReachAround = 1.5;
// More vertices than this at one node is not a crossing but a crumpled mesh.
constexpr int kMostVerticesOfNode = 16;

bool areCopies(const SurfaceMesh& mesh, int a, int b) {
    return mesh.copyGroup(a) >= 0 && mesh.copyGroup(a) == mesh.copyGroup(b);
}

Vec3 seenPosition(const PredicatePositions& positions, const RungNode& node) {
    return node.vertex >= 0 ? positions.withoutPins(node.vertex) : node.position;
}

bool joinsLast(const StepInput& in, const PredicatePositions& positions,
               const std::vector<StripNode>& nodes, int i) {
    const RungNode& node = in.rung[i];
    if (i == 0 || node.vertex < 0 || in.rung[i - 1].vertex < 0 ||
        sizeOf(nodes.back().vertices) >= kMostVerticesOfNode) {
        return false;
    }
    const double distance = (seenPosition(positions, node) - nodes.back().position).norm();
    const bool closes =
        !in.rung[i - 1].attached && areCopies(in.mesh, node.vertex, in.rung[i - 1].vertex);
    return distance < in.attempt.tolerance * in.h ||
           (closes && distance < in.attempt.closing * in.h);
}

void joinLast(const StepInput& in, const PredicatePositions& positions, int i, StripNode& last) {
    const double count = sizeOf(last.vertices);
    if (in.attempt.closing < kCloseDistance) {
        last.position = (last.position * count + seenPosition(positions, in.rung[i])) / (count + 1);
    }
    last.attachedWithin.push_back(in.rung[i - 1].attached);
    last.vertices.push_back(in.rung[i].vertex);
    last.attached = in.rung[i].attached;
}

StripNode nodeAt(const StepInput& in, const PredicatePositions& positions, const RungNode& from) {
    StripNode node;
    node.position = seenPosition(positions, from);
    node.s = from.s;
    node.layout = {from.s * lengthOf(in.blade), 0};
    node.attached = from.attached;
    if (from.vertex >= 0) {
        node.vertices = {from.vertex};
    }
    return node;
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

void seeFrontOnSurface(const StepInput& in, std::vector<StripNode>& nodes,
                       PredicatePositions& positions) {
    for (int i = 0; i < sizeOf(nodes); ++i) {
        StripNode& node = nodes[i];
        const bool isInner = i > 0 && nodes[i - 1].attached && node.attached;
        for (const int v : node.vertices) {
            const auto flat = onSurface(in, v);
            if (flat) {
                seeAroundOnSurface(in, in.mesh.position(v), positions);
            }
            const auto inside = isInner && !flat ? keptInside(in, v) : std::nullopt;
            node.position = flat.value_or(inside.value_or(node.position));
        }
    }
    for (const StripNode& node : nodes) {
        pinVertices(node, positions);
    }
}

void separateParameters(const StepInput& in, std::vector<StripNode>& nodes) {
    for (int i = 1; i < sizeOf(nodes); ++i) {
        if (nodes[i].s <= nodes[i - 1].s) {
            nodes[i].s = nodes[i - 1].s + kLeastSpacing * in.h / lengthOf(in.blade);
            nodes[i].layout.x() = nodes[i].s * lengthOf(in.blade);
        }
    }
}

/// How far the rung lies behind the blade, across it: a node that is led around skin may have the s
/// of another place.
double heightOf(const std::vector<RungNode>& rung, const Blade& blade) {
    double height = 0;
    for (const RungNode& node : rung) {
        height = std::max(height, across(blade, node.position - blade.a).norm());
    }
    return height;
}

void addNewRung(const std::vector<std::optional<StripNode>>& nodes, Strip& strip) {
    for (const std::optional<StripNode>& node : nodes) {
        const int oldEnd = strip.newRung.empty() ? 0 : strip.oldCount - 1;
        strip.newRung.push_back(node ? sizeOf(strip.nodes) : oldEnd);
        if (node) {
            strip.nodes.push_back(*node);
        }
    }
}

void stitchRungs(const BladeSpan& span, Strip& strip) {
    std::vector<int> lower(strip.oldCount);
    std::iota(lower.begin(), lower.end(), 0);
    std::vector<double> lowerS;
    std::vector<double> upperS;
    lowerS.reserve(lower.size());
    upperS.reserve(strip.newRung.size());
    for (const int node : lower) {
        lowerS.push_back(strip.nodes[node].s);
    }
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
                strip.edges.push_back({a, b});
            } else {
                strip.edges[ids[e]].onBorder = false;
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

std::vector<StripNode> oldRung(const StepInput& in, PredicatePositions& positions) {
    std::vector<StripNode> nodes;
    nodes.reserve(2 * in.rung.size() + 2);  // for the new rung too, which has no more
    for (int i = 0; i < sizeOf(in.rung); ++i) {
        if (joinsLast(in, positions, nodes, i)) {
            joinLast(in, positions, i, nodes.back());
        } else {
            nodes.push_back(nodeAt(in, positions, in.rung[i]));
        }
    }
    for (const StripNode& node : nodes) {
        if (node.vertices.size() > 1) {
            pinVertices(node, positions);
        }
    }
    if (in.attempt.onSurface) {
        seeFrontOnSurface(in, nodes, positions);
    }
    separateParameters(in, nodes);
    return nodes;
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
    strip.nodes = oldRung(in, positions);
    strip.oldCount = sizeOf(strip.nodes);
    strip.height = heightOf(in.rung, in.blade);
    strip.spacing = RungSpacing(in, strip.nodes);
    addNewRung(newRung(in, strip, skipped), strip);
    stitchRungs(in.span, strip);
    connectEdges(in, strip);
    return strip;
}

}  // namespace kerf::cut
