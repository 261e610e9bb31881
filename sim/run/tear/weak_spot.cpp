#include "sim/run/tear/weak_spot.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "sim/mesh/deformation_field.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/triangle_quality.h"

namespace kerf {

namespace {

using Stretches = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>;

/// The squares of the principal stretches of a triangle and those at its corners, with their
/// present directions: one alone may stretch for its shape.
Stretches stretchesAround(const SurfaceMesh& mesh, int t) {
    DeformationField field(VertexPositions::atRest(mesh), VertexPositions::current(mesh));
    for (const int v : mesh.triangle(t)) {
        mesh.forEachOutgoing(v,
                             [&](int h) { field.add(mesh.triangle(SurfaceMesh::triangleOf(h))); });
    }
    Eigen::Matrix3d gradient;
    gradient << field.along(Vec3::UnitX()), field.along(Vec3::UnitY()), field.along(Vec3::UnitZ());
    return Stretches(gradient * gradient.transpose());
}

bool counts(const SurfaceMesh& mesh, int t, const StrongPlaces& strong) {
    const Vec3& corner = mesh.restPosition(mesh.triangle(t)[0]);
    return mesh.kind(t) == SurfaceKind::skin &&
           std::ranges::none_of(strong.places, [&](const Vec3& place) {
               return (place - corner).norm() < strong.reach;
           });
}

WeakSpot spotAt(const Corners& corners, const Vec3& pulled) {
    const Vec3 normal = unitNormal<Vec3>(corners[0], corners[1], corners[2]);
    return {(corners[0] + corners[1] + corners[2]) / 3, normal,
            normal.cross(pulled).stableNormalized()};
}

}  // namespace

std::optional<WeakSpot> findWeakSpot(const SurfaceMesh& mesh, double least,
                                     const StrongPlaces& strong) {
    std::optional<WeakSpot> weakest;
    double most = 1 + least;
    for (const int t : livingTriangles(mesh)) {
        const Corners now = cornersOf(mesh, t);
        if (1 + largestStrain(restCornersOf(mesh, t), now) > most && counts(mesh, t, strong)) {
            const Stretches around = stretchesAround(mesh, t);
            if (const double mean = std::sqrt(around.eigenvalues()[2]); mean > most) {
                most = mean;
                weakest = spotAt(now, around.eigenvectors().col(2));
            }
        }
    }
    return weakest;
}

}  // namespace kerf
