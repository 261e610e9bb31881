#include "bench/lab/fem/solid_solver.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>
#include <cmath>
#include <stdexcept>

#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

constexpr int kNodes = 10;
constexpr int kUnknowns = 3 * kNodes;
constexpr double kBalanced = 1e-9;  ///< residual at which a solid rests
constexpr int kMostNewtonSteps = 200;
constexpr double kFreePivot = 1e-10;  ///< least over largest pivot of what is held at all
constexpr double kSufficient = 1e-4;  ///< share of the expected fall that a step must bring
constexpr double kDrowned = 1e-9;     ///< a fall of this share of the energy drowns in rounding
constexpr double kNoStrain = 1e-5;    ///< its forces don't count
constexpr double kRounding = 1e-13;   ///< of energies, as a share of modulus times volume
constexpr double kShortestStep = 1e-8;
constexpr double kFirstShift = 1e-6;  ///< of the diagonal, where the tangent is indefinite
constexpr double kMostShift = 1e6;

using Gradients = Eigen::Matrix<double, kNodes, 3>;
using NodeForces = Eigen::Matrix<double, 3, kNodes>;
using Stiffness = Eigen::Matrix<double, kUnknowns, kUnknowns>;
using Sparse = Eigen::SparseMatrix<double>;

/// Derivatives of the shape functions by the coordinates of the reference tetrahedron, at the
/// point with these barycentric weights.
Gradients shapeGradients(const Eigen::Vector4d& w) {
    Eigen::Matrix<double, 4, 3> dw;  // of the weights
    dw << -1, -1, -1, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    Gradients g;
    for (int c = 0; c < 4; ++c) {
        g.row(c) = (4 * w[c] - 1) * dw.row(c);
    }
    for (int e = 0; e < 6; ++e) {
        const auto& [a, b] = SolidMesh::kEdges[e];
        g.row(4 + e) = 4 * (w[a] * dw.row(b) + w[b] * dw.row(a));
    }
    return g;
}

/// Values of the shape functions at that point.
Eigen::Matrix<double, kNodes, 1> shapeValues(const Eigen::Vector4d& w) {
    Eigen::Matrix<double, kNodes, 1> n;
    for (int c = 0; c < 4; ++c) {
        n[c] = w[c] * (2 * w[c] - 1);
    }
    for (int e = 0; e < 6; ++e) {
        const auto& [a, b] = SolidMesh::kEdges[e];
        n[4 + e] = 4 * w[a] * w[b];
    }
    return n;
}

/// The four points of integration, exact for polynomials of the second degree.
std::array<Eigen::Vector4d, 4> integrationPoints() {
    const double near = (5 + 3 * std::sqrt(5.0)) / 20;
    const double far = (5 - std::sqrt(5.0)) / 20;
    std::array<Eigen::Vector4d, 4> points;
    for (int i = 0; i < 4; ++i) {
        points[i].setConstant(far);
        points[i][i] = near;
    }
    return points;
}

/// A point of integration of a tetrahedron.
struct Sample {
    Gradients gradients;  ///< of the shape functions at rest [1/m]
    double volume = 0;    ///< that it stands for [m^3]
};

/// The solid as its solver needs it.
class Solid {
  public:
    explicit Solid(const SolidProblem& problem) : problem_(problem) {
        const std::array<Eigen::Vector4d, 4> points = integrationPoints();
        loads_ =
            problem.forces.empty() ? std::vector<Vec3>(nodeCount(), Vec3::Zero()) : problem.forces;
        for (const auto& nodes : problem.mesh.tetrahedra) {
            for (const Eigen::Vector4d& point : points) {
                addSample(nodes, point);
            }
        }
        numberUnknowns();
    }

    int unknowns() const { return count_; }

    /// Moves what is held to this share of its way.
    void hold(std::vector<Vec3>& positions, double share) const {
        forEachCoordinate([&](std::size_t n, int axis) {
            if (const std::optional<double>& held = problem_.held[n][axis]) {
                const double rest = problem_.mesh.nodes[n][axis];
                positions[n][axis] = rest + share * (*held - rest);
            }
        });
    }

    double elasticEnergy(const std::vector<Vec3>& positions) const {
        double sum = 0;
        forEachSample(positions, [&](const auto&, const Sample& s, const Eigen::Matrix3d& f) {
            sum += s.volume * problem_.material.energy(f);
        });
        return sum;
    }

    /// Energy of a strain of 1 [J], roughly.
    double energyOfStrain() const { return problem_.material.shear * volume_; }

    /// Elastic energy less the work of this share of the loads.
    double potential(const std::vector<Vec3>& positions, double share) const {
        double work = 0;
        for (std::size_t n = 0; n < nodeCount(); ++n) {
            work += loads_[n].dot(positions[n] - problem_.mesh.nodes[n]);
        }
        return elasticEnergy(positions) - share * work;
    }

    /// What pulls at each node: this share of the loads less the elastic forces [N].
    std::vector<Vec3> forces(const std::vector<Vec3>& positions, double share) const {
        std::vector<Vec3> sum(nodeCount());
        for (std::size_t n = 0; n < nodeCount(); ++n) {
            sum[n] = share * loads_[n];
        }
        forEachSample(positions, [&](const auto& nodes, const Sample& s, const Eigen::Matrix3d& f) {
            const NodeForces pull =
                s.volume * problem_.material.stress(f) * s.gradients.transpose();
            for (int a = 0; a < kNodes; ++a) {
                sum[nodes[a]] -= pull.col(a);
            }
        });
        return sum;
    }

    /// The forces on what is free, by unknown.
    Eigen::VectorXd ofUnknowns(const std::vector<Vec3>& forces) const {
        Eigen::VectorXd own(count_);
        forEachUnknown([&](std::size_t n, int axis, int number) { own[number] = forces[n][axis]; });
        return own;
    }

    /// How large the forces are that balance each other [N]: those on what is held, and the loads;
    /// where there are none, those of a strain that does not count.
    double scale(const std::vector<Vec3>& forces, double share) const {
        double holds = 0;
        double loads = 0;
        forEachCoordinate([&](std::size_t n, int axis) {
            holds += number_[n][axis] < 0 ? std::pow(forces[n][axis], 2) : 0.0;
            loads += std::pow(loads_[n][axis], 2);
        });
        const double strain = kNoStrain * problem_.material.shear * std::pow(volume_, 2.0 / 3);
        return std::sqrt(holds) + share * std::sqrt(loads) + strain;
    }

    /// The derivative of the elastic forces by the unknowns, its lower half.
    Sparse stiffness(const std::vector<Vec3>& positions) const {
        std::vector<Eigen::Triplet<double>> entries;
        entries.reserve(problem_.mesh.tetrahedra.size() * kUnknowns * (kUnknowns + 1) / 2);
        for (std::size_t t = 0; t < problem_.mesh.tetrahedra.size(); ++t) {
            const auto& nodes = problem_.mesh.tetrahedra[t];
            addEntries(entries, nodes, elementStiffness(positions, t));
        }
        Sparse matrix(count_, count_);
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
    }

    void move(std::vector<Vec3>& positions, const Eigen::VectorXd& by) const {
        forEachUnknown(
            [&](std::size_t n, int axis, int number) { positions[n][axis] += by[number]; });
    }

  private:
    std::size_t nodeCount() const { return problem_.mesh.nodes.size(); }

    void addSample(const std::array<int, kNodes>& nodes, const Eigen::Vector4d& point) {
        const Gradients reference = shapeGradients(point);
        Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
        for (int a = 0; a < kNodes; ++a) {
            jacobian += problem_.mesh.nodes[nodes[a]] * reference.row(a);
        }
        const double volume = jacobian.determinant() / 24;
        if (!(volume > 0)) {
            throw std::runtime_error("a tetrahedron is flat or inside out");
        }
        volume_ += volume;
        samples_.push_back({reference * jacobian.inverse(), volume});
        const Vec3 weight = problem_.density * volume * problem_.gravity;
        const Eigen::Matrix<double, kNodes, 1> values = shapeValues(point);
        for (int a = 0; a < kNodes; ++a) {
            loads_[nodes[a]] += values[a] * weight;
        }
    }

    void numberUnknowns() {
        number_.assign(nodeCount(), {-1, -1, -1});
        forEachCoordinate([&](std::size_t n, int axis) {
            if (!problem_.held[n][axis]) {
                number_[n][axis] = count_++;
            }
        });
    }

    template <class Use>
    void forEachCoordinate(Use&& use) const {
        for (std::size_t n = 0; n < nodeCount(); ++n) {
            for (int axis = 0; axis < 3; ++axis) {
                use(n, axis);
            }
        }
    }

    /// Calls use(node, axis, number of the unknown) for each of them.
    template <class Use>
    void forEachUnknown(Use&& use) const {
        forEachCoordinate([&](std::size_t n, int axis) {
            if (number_[n][axis] >= 0) {
                use(n, axis, number_[n][axis]);
            }
        });
    }

    static Eigen::Matrix3d deformation(const std::vector<Vec3>& positions,
                                       const std::array<int, kNodes>& nodes, const Sample& s) {
        Eigen::Matrix3d f = Eigen::Matrix3d::Zero();
        for (int a = 0; a < kNodes; ++a) {
            f += positions[nodes[a]] * s.gradients.row(a);
        }
        return f;
    }

    /// Calls use(nodes, sample, deformation gradient) for each point of integration.
    template <class Use>
    void forEachSample(const std::vector<Vec3>& positions, Use&& use) const {
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const auto& nodes = problem_.mesh.tetrahedra[i / 4];
            use(nodes, samples_[i], deformation(positions, nodes, samples_[i]));
        }
    }

    Stiffness elementStiffness(const std::vector<Vec3>& positions, std::size_t t) const {
        const auto& nodes = problem_.mesh.tetrahedra[t];
        Stiffness sum = Stiffness::Zero();
        for (std::size_t i = 4 * t; i < 4 * t + 4; ++i) {
            const Sample& s = samples_[i];
            Eigen::Matrix<double, 9, kUnknowns> strains =
                Eigen::Matrix<double, 9, kUnknowns>::Zero();
            for (int a = 0; a < kNodes; ++a) {
                for (int column = 0; column < 3; ++column) {
                    strains.block<3, 3>(3 * column, 3 * a)
                        .diagonal()
                        .setConstant(s.gradients(a, column));
                }
            }
            const Eigen::Matrix<double, 9, kUnknowns> stresses =
                s.volume * problem_.material.tangent(deformation(positions, nodes, s)) * strains;
            sum.noalias() += strains.transpose() * stresses;
        }
        return sum;
    }

    void addEntries(std::vector<Eigen::Triplet<double>>& entries,
                    const std::array<int, kNodes>& nodes, const Stiffness& k) const {
        for (int i = 0; i < kUnknowns; ++i) {
            for (int j = 0; j < kUnknowns; ++j) {
                const int row = number_[nodes[i / 3]][i % 3];
                const int column = number_[nodes[j / 3]][j % 3];
                if (column >= 0 && row >= column) {
                    entries.emplace_back(row, column, k(i, j));
                }
            }
        }
    }

    const SolidProblem& problem_;
    std::vector<Sample> samples_;             ///< four for each tetrahedron
    std::vector<Vec3> loads_;                 ///< on each node [N]
    std::vector<std::array<int, 3>> number_;  ///< of the unknown of a node and axis; -1: held
    int count_ = 0;
    double volume_ = 0;  ///< at rest [m^3]
};

using Factors = Eigen::SimplicialLDLT<Sparse>;

/// The least pivot over the largest one: not positive where the matrix is not positive definite.
double leastPivot(const Factors& factors) {
    const Eigen::VectorXd pivots = factors.vectorD();
    return factors.info() == Eigen::Success ? pivots.minCoeff() / pivots.maxCoeff() : -1.0;
}

/// Newton's method on a solid.
class Newton {
  public:
    explicit Newton(const SolidProblem& problem) : solid_(problem), rest_(problem.mesh.nodes) {
        const Sparse stiffness = solid_.stiffness(rest_);
        factors_.analyzePattern(stiffness);
        factors_.factorize(stiffness);
        if (!(leastPivot(factors_) > kFreePivot)) {
            throw std::runtime_error("what holds the solid lets it move freely");
        }
    }

    /// The rest under the whole load, which comes in so many steps.
    SolidState run(int loadSteps) {
        SolidState state;
        state.positions = rest_;
        for (int i = 1; i <= loadSteps; ++i) {
            balance(state, static_cast<double>(i) / loadSteps);
        }
        state.energy = solid_.elasticEnergy(state.positions);
        return state;
    }

  private:
    /// Steps until the forces are in balance at this share of the load.
    void balance(SolidState& state, double share) {
        solid_.hold(state.positions, share);
        for (int step = 0; step < kMostNewtonSteps; ++step) {
            const std::vector<Vec3> all = solid_.forces(state.positions, share);
            const Eigen::VectorXd forces = solid_.ofUnknowns(all);
            const double scale = solid_.scale(all, share);
            state.residual = scale > 0 ? forces.norm() / scale : 0;
            if (state.residual <= kBalanced) {
                return;
            }
            advance(state, forces, share);
            ++state.newtonSteps;
        }
        throw std::runtime_error("a solid did not come to rest");
    }

    /// One step, shortened until the potential falls as a step downhill must let it fall. Where
    /// the fall would drown in rounding, the whole step.
    void advance(SolidState& state, const Eigen::VectorXd& forces, double share) {
        const Eigen::VectorXd way = downhill(solid_.stiffness(state.positions), forces);
        const double before = solid_.potential(state.positions, share);
        const double slope = forces.dot(way);
        const bool isLast = slope < kDrowned * solid_.elasticEnergy(state.positions) +
                                        kRounding * solid_.energyOfStrain();
        for (double part = 1; part > kShortestStep; part /= 2) {
            std::vector<Vec3> moved = state.positions;
            solid_.move(moved, part * way);
            const double fall = before - solid_.potential(moved, share);
            if (isLast || fall >= kSufficient * part * slope) {
                state.positions = std::move(moved);
                return;
            }
        }
        throw std::runtime_error("a solid did not come to rest: no step lowers its energy");
    }

    /// The step of Newton's method. Where the tangent is not positive definite, its diagonal is
    /// raised until it is.
    Eigen::VectorXd downhill(Sparse stiffness, const Eigen::VectorXd& forces) {
        const Eigen::VectorXd diagonal = stiffness.diagonal().cwiseAbs();
        double raised = 0;
        factors_.factorize(stiffness);
        for (double shift = kFirstShift; !(leastPivot(factors_) > 0); shift *= 10) {
            if (shift > kMostShift) {
                throw std::runtime_error("a solid did not come to rest: it has no stiffness");
            }
            stiffness.diagonal() += (shift - raised) * diagonal;
            raised = shift;
            factors_.factorize(stiffness);
        }
        return factors_.solve(forces);
    }

    Solid solid_;
    const std::vector<Vec3>& rest_;
    Factors factors_;
};

}  // namespace

SolidState relaxSolid(const SolidProblem& problem) {
    return Newton(problem).run(problem.loadSteps);
}

double solidVolume(const SolidMesh& mesh, const std::vector<Vec3>& positions) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.skin) {
        sum += tetrahedronVolume(positions[a], positions[b], positions[c]);
    }
    return sum;
}

}  // namespace kerf
