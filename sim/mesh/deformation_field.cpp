#include "sim/mesh/deformation_field.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

constexpr double kRidge = 1e-6;  // of the trace

/// The sides and, about as long, the normal.
std::array<Vec3, 4> edgesOf(const VertexPositions& places, const Triangle& triangle) {
    const Vec3& a = places[triangle[0]];
    const Vec3& b = places[triangle[1]];
    const Vec3& c = places[triangle[2]];
    const Vec3 cross = areaNormal(a, b, c);
    const double length = cross.norm();
    return {b - a, c - b, a - c, length > 0 ? Vec3(cross / std::sqrt(length)) : Vec3(Vec3::Zero())};
}

}  // namespace

void LinearField::add(const Vec3& edge, const Vec3& change) {
    spread_ += edge * edge.transpose();
    change_ += change * edge.transpose();
}

Vec3 LinearField::along(const Vec3& way) const {
    Eigen::Matrix3d spread = spread_;
    spread.diagonal().array() += kRidge * spread.trace() + 1e-300;
    return change_ * spread.ldlt().solve(way);
}

void DeformationField::add(const Triangle& triangle) {
    const std::array<Vec3, 4> from = edgesOf(from_, triangle);
    const std::array<Vec3, 4> to = edgesOf(to_, triangle);
    for (std::size_t k = 0; k < from.size(); ++k) {
        offset_.add(from[k], to[k] - from[k]);
    }
}

}  // namespace kerf
