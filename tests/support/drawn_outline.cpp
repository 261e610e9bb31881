#include "tests/support/drawn_outline.h"

namespace kerf::test {

int DrawnOutline::node(const Vec2& layout) {
    cut::CutNode& node = curves.nodes.emplace_back();
    node.layout = layout;
    node.position = {layout.x() - 2, 2 - layout.y(), 0.25};
    return cut::sizeOf(curves.nodes) - 1;
}

void DrawnOutline::loopThrough(const std::vector<int>& nodes, int piece) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        outline.edges.push_back(
            {nodes[i], nodes[(i + 1) % nodes.size()], cut::OutlineKind::free, piece});
    }
}

int DrawnOutline::loop(const Points& points, int piece) {
    std::vector<int> nodes;
    for (const Vec2& p : points) {
        nodes.push_back(node(p));
    }
    loopThrough(nodes, piece);
    return nodes.front();
}

DrawnOutline::Points DrawnOutline::square(double low, double high) {
    return {{low, low}, {high, low}, {high, high}, {low, high}};
}

DrawnOutline::Points DrawnOutline::turned(Points points) {
    std::ranges::reverse(points);
    return points;
}

}  // namespace kerf::test
