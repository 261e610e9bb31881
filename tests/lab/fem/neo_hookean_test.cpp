#include "bench/lab/fem/neo_hookean.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <stdexcept>

namespace kerf {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const NeoHookean kSolid = NeoHookean::of(1e5, 0.45);

/// Stretched, sheared; the second also inside out.
std::vector<Matrix3d> someDeformations() {
    Matrix3d f;
    f << 1.2, 0.3, -0.1, 0.05, 0.8, 0.2, -0.2, 0.1, 1.1;
    Matrix3d turned = f;
    turned.col(2) *= -0.7;
    return {Matrix3d::Identity(), f, turned};
}

TEST(NeoHookean, StressIsTheSlopeOfTheEnergy) {
    const double step = 1e-6;
    for (const Matrix3d& f : someDeformations()) {
        const Matrix3d stress = kSolid.stress(f);
        for (int i = 0; i < 9; ++i) {
            Matrix3d more = f;
            Matrix3d less = f;
            more.data()[i] += step;
            less.data()[i] -= step;
            const double slope = (kSolid.energy(more) - kSolid.energy(less)) / (2 * step);
            EXPECT_NEAR(stress.data()[i], slope, 1e-3) << i;
        }
    }
}

TEST(NeoHookean, TangentIsTheSlopeOfTheStress) {
    const double step = 1e-6;
    for (const Matrix3d& f : someDeformations()) {
        const NeoHookean::Tangent tangent = kSolid.tangent(f);
        EXPECT_LT((tangent - tangent.transpose()).norm(), 1e-9 * tangent.norm());
        for (int i = 0; i < 9; ++i) {
            Matrix3d more = f;
            Matrix3d less = f;
            more.data()[i] += step;
            less.data()[i] -= step;
            const Matrix3d slope = (kSolid.stress(more) - kSolid.stress(less)) / (2 * step);
            const Eigen::Map<const Matrix3d> column(tangent.col(i).data());
            EXPECT_LT((column - slope).norm(), 1e-3) << i;
        }
    }
}

TEST(NeoHookean, RestsUndeformedAndDoesNotFeelTurns) {
    EXPECT_EQ(kSolid.energy(Matrix3d::Identity()), 0);
    EXPECT_LT(kSolid.stress(Matrix3d::Identity()).norm(), 1e-9);
    const Matrix3d turn(Eigen::AngleAxisd(1.1, Vector3d(1, 2, -1).normalized()));
    for (const Matrix3d& f : someDeformations()) {
        EXPECT_NEAR(kSolid.energy(turn * f), kSolid.energy(f), 1e-6);
    }
}

// Hooke's law: 2 mu e + lambda tr(e), with E and nu as engineers measure them.
TEST(NeoHookean, ObeysHookesLawWhereStrainsAreSmall) {
    const double poisson = 0.45;
    const double strain = 1e-7;
    Matrix3d f = Matrix3d::Identity();
    f.diagonal() += strain * Vector3d(1, -poisson, -poisson);
    const Matrix3d stress = kSolid.stress(f);
    EXPECT_NEAR(stress(0, 0), 1e5 * strain, 1e-5 * 1e5 * strain);
    EXPECT_NEAR(stress(1, 1), 0, 1e-5 * 1e5 * strain);
    Matrix3d sheared = Matrix3d::Identity();
    sheared(0, 1) = strain;
    EXPECT_NEAR(kSolid.stress(sheared)(0, 1), 1e5 / 2.9 * strain, 1e-5 * 1e5 * strain);
}

TEST(NeoHookean, IsRefusedWithoutAModulusOrAsIncompressible) {
    EXPECT_THROW(NeoHookean::of(0, 0.3), std::invalid_argument);
    EXPECT_THROW(NeoHookean::of(1e5, 0.5), std::invalid_argument);
}

}  // namespace
}  // namespace kerf
