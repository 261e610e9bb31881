#include "tests/support/finite_elements.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <stdexcept>

namespace kerf::test {

namespace {

using Stiffness = Eigen::Matrix<double, 12, 12>;
using Elasticity = Eigen::Matrix<double, 6, 6>;

/// Hooke's law for engineering strains (xx, yy, zz, xy, yz, zx).
Elasticity elasticity(double modulus, double poisson) {
    const double lambda = modulus * poisson / ((1 + poisson) * (1 - 2 * poisson));
    const double mu = modulus / (2 * (1 + poisson));
    Elasticity d = Elasticity::Zero();
    d.topLeftCorner<3, 3>().setConstant(lambda);
    d.topLeftCorner<3, 3>().diagonal().array() += 2 * mu;
    d.bottomRightCorner<3, 3>().diagonal().setConstant(mu);
    return d;
}

Stiffness elementStiffness(const ElasticSolid& solid, const std::array<int, 4>& nodes,
                           const Elasticity& d) {
    Eigen::Matrix3d edges;
    for (int i = 0; i < 3; ++i) {
        edges.col(i) = solid.nodes[nodes[i + 1]] - solid.nodes[nodes[0]];
    }
    const double volume = edges.determinant() / 6;
    if (!(volume > 0)) {
        throw std::runtime_error("a tetrahedron is flat or inside out");
    }
    Eigen::Matrix<double, 3, 4> gradients;  // of the shape functions
    gradients.rightCols<3>() = edges.inverse().transpose();
    gradients.col(0) = -gradients.rightCols<3>().rowwise().sum();
    Eigen::Matrix<double, 6, 12> b = Eigen::Matrix<double, 6, 12>::Zero();
    for (int n = 0; n < 4; ++n) {
        const Vec3 g = gradients.col(n);
        b.block<3, 3>(0, 3 * n) = g.asDiagonal();
        b.block<3, 3>(3, 3 * n) << g.y(), g.x(), 0, 0, g.z(), g.y(), g.z(), 0, g.x();
    }
    return volume * b.transpose() * d * b;
}

/// Number of the unknown for each node and axis, -1 where supported; the count comes back.
int numberUnknowns(const ElasticSolid& solid, std::vector<std::array<int, 3>>& unknowns) {
    int count = 0;
    for (const std::array<bool, 3>& axes : solid.supported) {
        std::array<int, 3>& own = unknowns.emplace_back();
        for (int axis = 0; axis < 3; ++axis) {
            own[axis] = axes[axis] ? -1 : count++;
        }
    }
    return count;
}

}  // namespace

ElasticSolid solidBox(const Vec3& size, const std::array<int, 3>& cells) {
    ElasticSolid solid;
    const auto nodeAt = [&](const std::array<int, 3>& at) {
        return (at[0] * (cells[1] + 1) + at[1]) * (cells[2] + 1) + at[2];
    };
    for (int i = 0; i <= cells[0]; ++i) {
        for (int j = 0; j <= cells[1]; ++j) {
            for (int k = 0; k <= cells[2]; ++k) {
                solid.nodes.emplace_back(size.x() * (static_cast<double>(i) / cells[0] - 0.5),
                                         size.y() * (static_cast<double>(j) / cells[1] - 0.5),
                                         size.z() * (static_cast<double>(k) / cells[2] - 0.5));
            }
        }
    }
    // Kuhn's: from the low corner to the high one, one axis after the other.
    constexpr std::array<std::array<int, 3>, 6> orders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (int i = 0; i < cells[0]; ++i) {
        for (int j = 0; j < cells[1]; ++j) {
            for (int k = 0; k < cells[2]; ++k) {
                for (std::size_t order = 0; order < orders.size(); ++order) {
                    std::array<int, 3> at{i, j, k};
                    std::array<int, 4> tetrahedron{nodeAt(at)};
                    for (int n = 0; n < 3; ++n) {
                        ++at[orders[order][n]];
                        tetrahedron[n + 1] = nodeAt(at);
                    }
                    if (order >= 3) {  // odd permutations are mirrored
                        std::swap(tetrahedron[2], tetrahedron[3]);
                    }
                    solid.tetrahedra.push_back(tetrahedron);
                }
            }
        }
    }
    solid.loads.assign(solid.nodes.size(), Vec3::Zero());
    solid.supported.assign(solid.nodes.size(), {false, false, false});
    return solid;
}

std::vector<Vec3> solveElastic(const ElasticSolid& solid) {
    std::vector<std::array<int, 3>> unknowns;
    const int count = numberUnknowns(solid, unknowns);
    const Elasticity d = elasticity(solid.youngsModulus, solid.poissonRatio);
    std::vector<Eigen::Triplet<double>> entries;
    for (const std::array<int, 4>& nodes : solid.tetrahedra) {
        const Stiffness k = elementStiffness(solid, nodes, d);
        for (int row = 0; row < 12; ++row) {
            for (int column = 0; column < 12; ++column) {
                const int i = unknowns[nodes[row / 3]][row % 3];
                const int j = unknowns[nodes[column / 3]][column % 3];
                if (i >= 0 && j >= 0) {
                    entries.emplace_back(i, j, k(row, column));
                }
            }
        }
    }
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(count);
    for (std::size_t n = 0; n < solid.nodes.size(); ++n) {
        for (int axis = 0; axis < 3; ++axis) {
            if (unknowns[n][axis] >= 0) {
                forces[unknowns[n][axis]] = solid.loads[n][axis];
            }
        }
    }
    Eigen::SparseMatrix<double> stiffness(count, count);
    stiffness.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(stiffness);
    const Eigen::VectorXd pivots = solver.vectorD();
    if (solver.info() != Eigen::Success || pivots.minCoeff() <= 1e-9 * pivots.maxCoeff()) {
        throw std::runtime_error("the supports let the solid move freely");
    }
    const Eigen::VectorXd solution = solver.solve(forces);
    std::vector<Vec3> displacements(solid.nodes.size(), Vec3::Zero());
    for (std::size_t n = 0; n < solid.nodes.size(); ++n) {
        for (int axis = 0; axis < 3; ++axis) {
            if (unknowns[n][axis] >= 0) {
                displacements[n][axis] = solution[unknowns[n][axis]];
            }
        }
    }
    return displacements;
}

}  // namespace kerf::test
