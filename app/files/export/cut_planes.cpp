#include "app/files/export/cut_planes.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "sim/mesh/triangle.h"

namespace kerf::app {
namespace {

constexpr double kSteep = 0.9;  // of a normal: a plane that faces so far up has no other way up

int strokeOf(const SurfaceMesh& mesh, int t) {
    return mesh.wallLabel(t) / 2;
}

/// The direction that most of the area faces, either way: the two walls of a slit face away from
/// each other. Its largest part is positive.
Vec3 normalOf(const Eigen::Matrix3d& spread) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    const Vec3 normal = solver.eigenvectors().col(2);
    Eigen::Index largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    return normal[largest] < 0 ? Vec3(-normal) : normal;
}

}  // namespace

CutPlanes::CutPlanes(const SurfaceMesh& mesh) {
    std::map<int, Eigen::Matrix3d> spreads;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (mesh.present(t) && mesh.kind(t) == SurfaceKind::wall) {
            const Vec3 area = areaNormal(restCornersOf(mesh, t));
            const auto place = spreads.try_emplace(strokeOf(mesh, t), Eigen::Matrix3d::Zero());
            place.first->second += area * area.stableNormalized().transpose();
        }
    }
    for (const auto& [stroke, spread] : spreads) {
        const Vec3 normal = normalOf(spread);
        const Vec3 up = std::fabs(normal.y()) > kSteep ? Vec3(-Vec3::UnitZ()) : Vec3(Vec3::UnitY());
        const Vec3 across = up.cross(normal).normalized();
        Axes axes;
        axes << across.transpose(), normal.cross(across).transpose();
        axes_.emplace(stroke, axes);
    }
}

Eigen::Vector2f CutPlanes::at(const SurfaceMesh& mesh, int t, int v) const {
    return (axes_.at(strokeOf(mesh, t)) * mesh.restPosition(v)).cast<float>();
}

}  // namespace kerf::app
