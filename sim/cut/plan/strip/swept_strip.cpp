#include "sim/cut/plan/strip/swept_strip.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "sim/cut/blade_line.h"
#include "sim/cut/exact/directed_edges.h"
#include "sim/cut/plan/strip/new_rung.h"
#include "sim/cut/plan/strip/old_rung.h"

namespace kerf::cut {

namespace {

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
    addNewRung(newRung(in, strip, skipped), strip);
    stitchRungs(in.span, strip);
    connectEdges(in, strip);
    return strip;
}

}  // namespace kerf::cut
