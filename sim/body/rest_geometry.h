#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/base/math.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Area of a living triangle in the rest shape [m^2].
double restArea(const SurfaceMesh& mesh, int triangle);

/// A third of the rest area of the triangles around each vertex [m^2], shape [vertexCount].
std::vector<double> restVertexAreas(const SurfaceMesh& mesh);

/// Mean rest edge length of the living triangles [m].
double meanRestEdgeLength(const SurfaceMesh& mesh);

/// The outward normal of a vertex in the rest shape, weighted by the angles of its triangles.
struct VertexNormal {
    Vec3 direction = Vec3::Zero();  ///< unit; zero where the triangles cancel
    /// Length of the weighted sum over the sum of the angles: 1 where flat, near 0 at the front of
    /// a slit, whose two walls face each other.
    double flatness = 0;
};
VertexNormal restNormal(const SurfaceMesh& mesh, int vertex);

/// The dihedral angle at a half-edge [rad], flat 0, convex > 0: now and at rest. None if a triangle
/// beside it is degenerate.
std::optional<double> edgeAngle(const SurfaceMesh& mesh, int h);
std::optional<double> restEdgeAngle(const SurfaceMesh& mesh, int h);

template <class Scalar>
struct Dihedral {
    Scalar angle = 0;  ///< [rad], flat 0, convex > 0, in (-pi, pi]
    /// The gradient of the angle by x0 .. x3 [rad/m].
    std::array<Eigen::Matrix<Scalar, 3, 1>, 4> gradient;
    bool valid = false;  ///< false where a triangle is degenerate; the rest is not set then
};

/// Signed angle between the triangles A = (x0, x1, x2) and B = (x1, x0, x3), counter-clockwise from
/// outside, and its gradient (Bridson et al. 2003, Tamstorf and Grinspun 2013; our sign: convex
/// edges are positive). Taken as differences, so that floats keep their digits:
/// `edge` = x1 - x0, `left` = x2 - x0, `right` = x3 - x0.
///
///          x2
///         /  \        A
///        x0--x1  e ->
///         \  /        B
///          x3
template <class Scalar>
Dihedral<Scalar> dihedral(const Eigen::Matrix<Scalar, 3, 1>& edge,
                          const Eigen::Matrix<Scalar, 3, 1>& left,
                          const Eigen::Matrix<Scalar, 3, 1>& right) {
    using Vector = Eigen::Matrix<Scalar, 3, 1>;
    const Vector normalA = edge.cross(left);
    const Vector normalB = right.cross(edge);
    const Scalar squareA = normalA.squaredNorm();
    const Scalar squareB = normalB.squaredNorm();
    const Scalar squareEdge = edge.squaredNorm();
    const Scalar degenerate = Scalar(1e-8) * squareEdge * squareEdge;
    Dihedral<Scalar> result;
    if (squareA <= degenerate || squareB <= degenerate) {
        return result;
    }
    const Scalar length = std::sqrt(squareEdge);
    result.valid = true;
    result.angle = std::atan2(normalA.cross(normalB).dot(edge) / length, normalA.dot(normalB));
    const Vector a = normalA * (length / squareA);
    const Vector b = normalB * (length / squareB);
    const Scalar alongA = left.dot(edge) / squareEdge;
    const Scalar alongB = right.dot(edge) / squareEdge;
    result.gradient[0] = (1 - alongA) * a + (1 - alongB) * b;
    result.gradient[1] = alongA * a + alongB * b;
    result.gradient[2] = -a;
    result.gradient[3] = -b;
    return result;
}

/// A difference of two angles [rad], brought into [-pi, pi].
template <class Scalar>
Scalar wrapAngle(Scalar angle) {
    constexpr Scalar pi = std::numbers::pi_v<Scalar>;
    if (angle > pi) {
        return angle - 2 * pi;
    }
    return angle < -pi ? angle + 2 * pi : angle;
}

/// The rotation that brings points with this covariance (sum of current rest^T) closest together
/// (Kabsch 1976).
Eigen::Matrix3d bestRotation(const Eigen::Matrix3d& covariance);

/// A vertex of a piece, as its rest shape is fitted to it.
struct FittedVertex {
    int vertex = -1;
    double weight = 0;
    Vec3 at = Vec3::Zero();        ///< [m]
    Vec3 rest = Vec3::Zero();      ///< [m]
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
};

/// How a piece moves as a whole.
struct RigidMotion {
    Vec3 velocity = Vec3::Zero();  ///< of its middle [m/s]
    Vec3 spin = Vec3::Zero();      ///< [rad/s]
};

/// The best fit of the rest shape of a piece to its present positions.
struct RestPose {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< never mirrors
    Vec3 middle = Vec3::Zero();                              ///< [m]
    Vec3 restMiddle = Vec3::Zero();                          ///< [m]
    double radius = 0;                                       ///< RMS distance from it at rest [m]

    /// The goal of a vertex with this rest position [m].
    Vec3 placeOf(const Vec3& rest) const { return middle + rotation * (rest - restMiddle); }
};

/// The pose with the least weighted squares of distances (shape matching, Mueller et al. 2005).
/// Some weight must be above 0.
RestPose fitRestPose(std::span<const FittedVertex> vertices);
/// The rigid motion with the weighted momenta of the vertices about `middle`, their mean.
RigidMotion rigidMotionOf(std::span<const FittedVertex> vertices, const Vec3& middle);
/// Root mean square of the distances from the vertices to their goals [m].
double rmsWay(const RestPose& pose, std::span<const FittedVertex> vertices);

}  // namespace kerf
