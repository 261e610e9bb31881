#include "sim/cut/plan/strip.h"

#include <algorithm>

namespace kerf::cut {

namespace {

/// Front edges join vertices of one piece only, so what is left of a gap joins nothing.
void dropGap(std::vector<char>& attachedWithin, int vertex) {
    if (!attachedWithin.empty()) {
        const int gap = std::min(vertex, sizeOf(attachedWithin) - 1);
        attachedWithin.erase(attachedWithin.begin() + gap);
    }
}

}  // namespace

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

Strip Strip::seenBy(int piece, const std::vector<int>& pieceOfVertex) const {
    const auto isOther = [&](int v) { return pieceOfVertex[v] != piece; };
    Strip strip = *this;
    for (StripNode& node : strip.nodes) {
        node.attached = node.attached && !isOther(node.vertices.back());
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

}  // namespace kerf::cut
