#include "sim/body/rest_geometry.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

template <class Places>
std::optional<double> angleAt(const SurfaceMesh& mesh, int h, const Places& places) {
    const Vec3& x0 = places(mesh.origin(h));
    const Vec3 edge = places(mesh.target(h)) - x0;
    const Vec3 left = places(mesh.apex(h)) - x0;
    const Vec3 right = places(mesh.apex(mesh.twin(h))) - x0;
    const Dihedral<double> found = dihedral<double>(edge, left, right);
    return found.valid ? std::optional(found.angle) : std::nullopt;
}

}  // namespace

double restArea(const SurfaceMesh& mesh, int triangle) {
    return triangleArea(restCornersOf(mesh, triangle));
}

std::vector<double> restVertexAreas(const SurfaceMesh& mesh) {
    std::vector<double> areas(mesh.vertexCount(), 0.0);
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (mesh.present(t)) {
            const double third = restArea(mesh, t) / 3;
            for (const int v : mesh.triangle(t)) {
                areas[v] += third;
            }
        }
    }
    return areas;
}

double meanRestEdgeLength(const SurfaceMesh& mesh) {
    double sum = 0;
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        if (mesh.alive(h / 3)) {
            sum += (mesh.restPosition(mesh.target(h)) - mesh.restPosition(mesh.origin(h))).norm();
        }
    }
    return mesh.aliveTriangles() > 0 ? sum / (3.0 * mesh.aliveTriangles()) : 0.0;
}

VertexNormal restNormal(const SurfaceMesh& mesh, int vertex) {
    Vec3 sum = Vec3::Zero();
    double angles = 0;
    const Vec3& center = mesh.restPosition(vertex);
    mesh.forEachOutgoing(vertex, [&](int h) {
        if (mesh.absent(h / 3)) {
            return;
        }
        const Vec3 u = mesh.restPosition(mesh.target(h)) - center;
        const Vec3 w = mesh.restPosition(mesh.apex(h)) - center;
        const Vec3 normal = u.cross(w);
        const double twiceArea = normal.norm();
        if (twiceArea > 0) {
            const double angle = std::atan2(twiceArea, u.dot(w));
            sum += normal * (angle / twiceArea);
            angles += angle;
        }
    });
    const double length = sum.norm();
    if (length <= 0) {
        return {};
    }
    return {sum / length, length / angles};
}

std::optional<double> edgeAngle(const SurfaceMesh& mesh, int h) {
    return angleAt(mesh, h, [&](int v) -> const Vec3& { return mesh.position(v); });
}

std::optional<double> restEdgeAngle(const SurfaceMesh& mesh, int h) {
    return angleAt(mesh, h, [&](int v) -> const Vec3& { return mesh.restPosition(v); });
}

namespace {

using Matrix = Eigen::Matrix3d;
using Vertices = std::span<const FittedVertex>;

/// The weighted mean of what f(vertex) gives.
template <class Value, class F>
Value meanOf(Vertices vertices, Value sum, F&& f) {
    double weight = 0;
    for (const FittedVertex& v : vertices) {
        sum += v.weight * f(v);
        weight += v.weight;
    }
    return sum / weight;
}

}  // namespace

Eigen::Matrix3d bestRotation(const Eigen::Matrix3d& covariance) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d product = svd.matrixU() * svd.matrixV().transpose();
    const Vec3 signs(1, 1, product.determinant() < 0 ? -1 : 1);
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

RestPose fitRestPose(Vertices vertices) {
    RestPose pose;
    pose.middle = meanOf(vertices, pose.middle, [](const auto& v) { return v.at; });
    pose.restMiddle = meanOf(vertices, pose.restMiddle, [](const auto& v) { return v.rest; });
    pose.rotation = bestRotation(meanOf(vertices, Matrix(Matrix::Zero()), [&](const auto& v) {
        return Matrix((v.at - pose.middle) * (v.rest - pose.restMiddle).transpose());
    }));
    pose.radius = std::sqrt(meanOf(
        vertices, 0.0, [&](const auto& v) { return (v.rest - pose.restMiddle).squaredNorm(); }));
    return pose;
}

RigidMotion rigidMotionOf(Vertices vertices, const Vec3& middle) {
    RigidMotion motion;
    motion.velocity = meanOf(vertices, motion.velocity, [](const auto& v) { return v.velocity; });
    const Vec3 angularMomentum = meanOf(vertices, motion.spin, [&](const auto& v) {
        return Vec3((v.at - middle).cross(v.velocity - motion.velocity));
    });
    Matrix inertia = meanOf(vertices, Matrix(Matrix::Zero()), [&](const auto& v) {
        const Vec3 arm = v.at - middle;
        return Matrix(arm.squaredNorm() * Matrix::Identity() - arm * arm.transpose());
    });
    const double size = inertia.trace();
    inertia += 1e-6 * size * Matrix::Identity();  // for what lies on a line
    motion.spin = size > 0 ? Vec3(inertia.inverse() * angularMomentum) : Vec3(Vec3::Zero());
    return motion;
}

double rmsWay(const RestPose& pose, Vertices vertices) {
    return std::sqrt(meanOf(
        vertices, 0.0, [&](const auto& v) { return (pose.placeOf(v.rest) - v.at).squaredNorm(); }));
}

}  // namespace kerf
