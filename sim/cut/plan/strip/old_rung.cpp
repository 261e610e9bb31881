#include "sim/cut/plan/strip/old_rung.h"

#include <optional>

#include "sim/cut/blade_line.h"

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

}  // namespace kerf::cut
