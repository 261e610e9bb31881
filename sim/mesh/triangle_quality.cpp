#include "sim/mesh/triangle_quality.h"

#include <algorithm>
#include <cmath>

namespace kerf {

namespace {

constexpr double kNeedleHeight = 0.1;       // of the longest edge
constexpr double kMostTimes = 4;            // as many triangles, where they are made even
const double kEvenArea = std::sqrt(3) / 4;  // of an even triangle with edges of 1

}  // namespace

bool isNeedle(const Corners& corners) {
    const double twiceArea = areaNormal(corners).norm();
    return twiceArea > 0 && twiceArea < kNeedleHeight * longestEdgeSquare(corners);
}

void TriangleFigures::add(const Corners& corners) {
    for (int i = 0; i < 3; ++i) {
        const double edge = (corners[(i + 1) % 3] - corners[i]).norm();
        shortestEdge = edgeSum == 0 ? edge : std::min(shortestEdge, edge);
        longestEdge = std::max(longestEdge, edge);
        edgeSum += edge;
    }
    ++triangles;
    needles += isNeedle(corners) ? 1 : 0;
    area += triangleArea(corners);
    evenEdgeSum += std::sqrt(triangleArea(corners) / kEvenArea);
}

TriangleFigures figuresOf(const TriangleSoup& soup) {
    TriangleFigures figures;
    for (const auto& [a, b, c] : soup.triangles) {
        figures.add({soup.positions[a], soup.positions[b], soup.positions[c]});
    }
    return figures;
}

double evenEdge(const TriangleFigures& figures) {
    const double mean = figures.triangles > 0 ? figures.evenEdgeSum / figures.triangles : 0;
    const double most = kMostTimes * figures.triangles;
    return trianglesOf(figures, mean) > most ? std::sqrt(figures.area / (kEvenArea * most)) : mean;
}

double trianglesOf(const TriangleFigures& figures, double edge) {
    return edge > 0 ? figures.area / (kEvenArea * edge * edge) : 0;
}

}  // namespace kerf
