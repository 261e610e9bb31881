#include "sim/solve/implicit/rest_inverse.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/support/cut_ball.h"

namespace kerf {
namespace {

/// A slit ball, turned so that its walls lie across all axes.
BodyModel turnedBall(double angle) {
    SurfaceMesh mesh = test::cutBall(-0.06, 12);
    const Eigen::AngleAxisd turn(angle, Vec3(1, 2, 3).normalized());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, turn * mesh.position(v));
    }
    return buildBodyModel(mesh);
}

// Aggregates on a wall are flat, and have modes that move none of their vertices.
TEST(RestInverseTest, NothingAnswersMoreThanTheLightestVertexWould) {
    Params params;
    params.youngsModulus = 3e5;
    const StageScale scale = stageScale(1.0 / 240, params.damping);
    for (const double angle : {0.0, 0.02, 0.7}) {
        const BodyModel model = turnedBall(angle);
        const std::vector<ConstraintPull> pulls = pullsAtRest(model, typeModuli(params));
        const std::vector<double> masses = massesWithout(model, params.density, {});
        double lightest = 1e300;
        for (std::size_t v = 0; v < masses.size(); ++v) {
            lightest = masses[v] > 0 ? std::min(lightest, masses[v]) : lightest;
        }
        const RestInverse inverse =
            invertAtRest(model, pulls, groupVertices(model, pulls, 60), masses, scale);
        for (const CoarsePiece& piece : inverse.pieces) {
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(piece.inverse.matrix);
            EXPECT_GT(modes.eigenvalues().minCoeff(), 0) << angle;
            EXPECT_LT(modes.eigenvalues().maxCoeff(), 1 / (scale.inertia * lightest)) << angle;
        }
    }
}

}  // namespace
}  // namespace kerf
