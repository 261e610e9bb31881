#include "sim/mesh/triangle_quality.h"

namespace kerf {

namespace {

constexpr double kNeedleHeight = 0.1;       // of the longest edge
constexpr double kMostTimes = 4;            // as many triangles, where they are made even
const double kEvenArea = std::sqrt(3) / 4;  // of an even triangle with edges of 1
constexpr double kDegrees = 180 / std::numbers::pi;

/// Whether the height over the longest edge is less than such a share of it.
bool isLowerThan(double share, const Corners& corners) {
    return areaNormal(corners).norm() < share * longestEdgeSquare(corners);
}

constexpr double kLeastDeterminant = 1e-30;  // as in shaders/render/field_strain.comp

using Matrix2 = Eigen::Matrix2d;

/// Products of two sides: what a shape is but for where it lies.
Matrix2 gram(const Corners& at) {
    const Vec3 u = at[1] - at[0];
    const Vec3 v = at[2] - at[0];
    Matrix2 products;
    products << u.dot(u), u.dot(v), u.dot(v), v.dot(v);
    return products;
}

}  // namespace

bool isNeedle(const Corners& corners) {
    return areaNormal(corners).norm() > 0 && isLowerThan(kNeedleHeight, corners);
}

double smallestAngle(const Corners& corners) {
    const double twiceArea = areaNormal(corners).norm();
    double smallest = std::numbers::pi;
    for (int i = 0; i < 3; ++i) {
        const Vec3 u = corners[(i + 1) % 3] - corners[i];
        const Vec3 v = corners[(i + 2) % 3] - corners[i];
        smallest = std::min(smallest, std::atan2(twiceArea, u.dot(v)));
    }
    return kDegrees * smallest;
}

void ShapeFigures::add(const Corners& corners) {
    const double angle = smallestAngle(corners);
    ++triangles;
    worstAngle = std::min(worstAngle, angle);
    angleSum += angle;
    slivers += isLowerThan(kSliver, corners) ? 1 : 0;
    bareSlivers += isLowerThan(kBareSliver, corners) ? 1 : 0;
}

void ShapeFigures::add(const ShapeFigures& others) {
    triangles += others.triangles;
    worstAngle = std::min(worstAngle, others.worstAngle);
    angleSum += others.angleSum;
    slivers += others.slivers;
    bareSlivers += others.bareSlivers;
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
    return trianglesOf(figures, mean) > most ? edgeOf(figures, most) : mean;
}

bool isCoarse(const TriangleFigures& figures, double diagonal) {
    constexpr double kCoarse = 1.0 / 8;  // of the diagonal
    return figures.longestEdge > kCoarse * diagonal;
}

double proposedEdge(const TriangleFigures& figures, double diagonal) {
    constexpr double kFine = 1.0 / 25;
    const double even = evenEdge(figures);
    return isCoarse(figures, diagonal) ? std::min(even, kFine * diagonal) : even;
}

double trianglesOf(const TriangleFigures& figures, double edge) {
    return edge > 0 ? figures.area / (kEvenArea * edge * edge) : 0;
}

double edgeOf(const TriangleFigures& figures, double triangles) {
    return std::sqrt(figures.area / (kEvenArea * triangles));
}

double largestStrain(const Corners& rest, const Corners& now) {
    const Matrix2 before = gram(rest);
    if (!(before.determinant() > kLeastDeterminant)) {
        return 0;
    }
    // Squares of the principal stretches are the eigenvalues of before^-1 now.
    const Matrix2 squares = before.inverse() * gram(now);
    const double half = squares.trace() / 2;
    const double spread = std::sqrt(std::max(half * half - squares.determinant(), 0.0));
    const double most = std::abs(std::sqrt(half + spread) - 1);
    const double least = std::abs(std::sqrt(std::max(half - spread, 0.0)) - 1);
    return std::max(most, least);
}

}  // namespace kerf
