#pragma once

#include <cstdint>

namespace kerf {

/// An amount that grows with a mesh: so much for each vertex, and so much for each triangle.
struct PerElement {
    double vertex = 0;
    double triangle = 0;

    friend constexpr PerElement operator+(const PerElement& a, const PerElement& b) {
        return {a.vertex + b.vertex, a.triangle + b.triangle};
    }
    friend constexpr PerElement operator*(double times, const PerElement& each) {
        return {times * each.vertex, times * each.triangle};
    }
    /// The total for a mesh with so many vertices and triangles.
    constexpr double of(double vertices, double triangles) const {
        return vertex * vertices + triangle * triangles;
    }
};

/// How many edges a closed surface has.
inline constexpr PerElement kEdges{0, 1.5};

}  // namespace kerf
