#include "sim/mesh/triangle.h"

namespace kerf {

Vec3 closestWeights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double abA = ab.dot(p - a);
    const double acA = ac.dot(p - a);
    const double abB = ab.dot(p - b);
    const double acB = ac.dot(p - b);
    const double abC = ab.dot(p - c);
    const double acC = ac.dot(p - c);
    if (abA <= 0 && acA <= 0) {
        return {1, 0, 0};
    }
    if (abB >= 0 && acB <= abB) {
        return {0, 1, 0};
    }
    if (acC >= 0 && abC <= acC) {
        return {0, 0, 1};
    }
    const double overC = abA * acB - abB * acA;
    if (overC <= 0 && abA >= 0 && abB <= 0) {
        const double t = abA / (abA - abB);
        return {1 - t, t, 0};
    }
    const double overB = abC * acA - abA * acC;
    if (overB <= 0 && acA >= 0 && acC <= 0) {
        const double t = acA / (acA - acC);
        return {1 - t, 0, t};
    }
    const double overA = abB * acC - abC * acB;
    if (overA <= 0 && acB >= abB && abC >= acC) {
        const double t = (acB - abB) / ((acB - abB) + (abC - acC));
        return {0, 1 - t, t};
    }
    return Vec3(overA, overB, overC) / (overA + overB + overC);
}

Vec3 closestOn(const Corners& triangle, const Vec3& p) {
    const auto& [a, b, c] = triangle;
    const Vec3 weights = closestWeights(p, a, b, c);
    return weights[0] * a + weights[1] * b + weights[2] * c;
}

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a;
    const double square = ab.squaredNorm();
    const double t = square > 0 ? std::clamp((p - a).dot(ab) / square, 0.0, 1.0) : 0.0;
    return (p - a - t * ab).norm();
}

}  // namespace kerf
