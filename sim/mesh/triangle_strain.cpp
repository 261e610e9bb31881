#include "sim/mesh/triangle_strain.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

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
