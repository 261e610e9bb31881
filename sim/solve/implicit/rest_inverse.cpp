#include "sim/solve/implicit/rest_inverse.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "shaders/shared/implicit_records.h"
#include "sim/body/piece_masses.h"
#include "sim/body/solver_uniforms.h"

namespace kerf {

namespace {

using Eigen::MatrixXd;

AggregateFrame frameOf(const VertexGroup& group, std::span<const Vec3> rest) {
    constexpr double kFlattest = 0.1;
    Bounds bounds;
    for (const std::uint32_t v : group) {
        bounds.add(rest[v]);
    }
    const Vec3 half = 0.5 * (bounds.high - bounds.low);
    const double least = 2 * kFlattest * half.maxCoeff();
    if (!(least > 0)) {
        return {bounds.center(), Vec3::Ones()};  // of one vertex
    }
    return {bounds.center(), half.cwiseMax(least)};
}

/// Inverts a symmetric matrix in place, a vertex at a time (Gauss and Jordan). Reads what is at and
/// below the diagonal.
void invertPatch(MatrixXd& patch) {
    const Eigen::Index size = patch.rows();
    using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;
    for (Eigen::Index k = 0; k < size; k += 3) {
        Columns links(size, 3);
        links << patch.block(k, 0, 3, k).transpose(), Eigen::Matrix3d::Zero(),
            patch.block(k + 3, k, size - k - 3, 3);
        const Eigen::Matrix3d own = patch.block<3, 3>(k, k).selfadjointView<Eigen::Lower>();
        const Eigen::Matrix3d inverse = own.inverse();
        const Columns shares = links.lazyProduct(inverse);
        for (Eigen::Index j = 0; j < size; ++j) {
            patch.col(j).tail(size - j).noalias() -=
                links.bottomRows(size - j).lazyProduct(shares.row(j).transpose());
        }
        patch.block(k, 0, 3, k) = shares.topRows(k).transpose();
        patch.block(k, k, size - k, 3) = shares.bottomRows(size - k);
        patch.block<3, 3>(k, k) = -inverse;
    }
    patch = -MatrixXd(patch.selfadjointView<Eigen::Lower>());
}

/// Adds up the system in parts while the constraints are gone through.
class RestSystem {
  public:
    RestSystem(const BodyModel& model, const VertexGroups& groups, std::span<const Vec3> rest,
               std::span<const double> masses)
        : rest_(rest),
          masses_(masses),
          patchSeats_(seatsOf(groups.patches, rest.size())),
          seats_(seatsOf(groups.aggregates, rest.size())),
          shares_(rest.size()) {
        for (const VertexGroup& patch : groups.patches) {
            const auto rows = static_cast<Eigen::Index>(3 * patch.size());
            out_.patches.push_back(MatrixXd::Zero(rows, rows));
        }
        std::vector<int> coarse(model.pieces.size(), -1);
        for (std::uint32_t a = 0; a < groups.aggregates.size(); ++a) {
            const VertexGroup& group = groups.aggregates[a];
            out_.frames.push_back(frameOf(group, rest));
            int& piece = coarse[model.pieceOfVertex[group[0]]];
            if (piece < 0) {
                piece = static_cast<int>(out_.pieces.size());
                out_.pieces.emplace_back();
            }
            row_.push_back(static_cast<int>(out_.pieces[piece].aggregates.size()));
            pieceOf_.push_back(piece);
            out_.pieces[piece].aggregates.push_back(a);
        }
        for (const CoarsePiece& piece : out_.pieces) {
            coarse_.emplace_back(static_cast<int>(piece.aggregates.size()));
        }
    }

    void addMass(std::uint32_t v, double inertia) {
        if (const Seat& seat = patchSeats_[v]; seat.group >= 0) {
            const double own = masses_[v] > 0 ? inertia * masses_[v] : 1.0;
            out_.patches[seat.group].diagonal().segment<3>(3 * seat.place).array() += own;
        }
        const int aggregate = seats_[v].group;
        if (aggregate < 0 || masses_[v] <= 0) {
            return;
        }
        const Eigen::Vector4d& shares = shares_[v] = out_.frames[aggregate].sharesAt(rest_[v]);
        CoarseMatrix::Block& block = blockOf(aggregate, aggregate);
        for (int m = 0; m < 4; ++m) {
            for (int n = 0; n < 4; ++n) {
                for (int axis = 0; axis < 3; ++axis) {
                    block(3 * m + axis, 3 * n + axis) +=
                        inertia * masses_[v] * shares[m] * shares[n];
                }
            }
        }
    }

    void addPull(const ConstraintPull& pull, double stiffness) {
        addToPatches(pull, stiffness);
        addToCoarse(pull, stiffness);
    }

    RestInverse inverted() {
        for (MatrixXd& patch : out_.patches) {
            invertPatch(patch);
        }
        for (std::size_t piece = 0; piece < coarse_.size(); ++piece) {
            makeDefinite(coarse_[piece]);
            out_.pieces[piece].inverse = coarse_[piece].invert();
        }
        return std::move(out_);
    }

  private:
    using Modes = Eigen::Matrix<double, AggregateFrame::kModes, 1>;

    bool moves(std::uint32_t v) const { return masses_[v] > 0; }

    void addToPatches(const ConstraintPull& pull, double stiffness) {
        for (int i = 0; i < pull.count; ++i) {
            for (int j = 0; j < pull.count; ++j) {
                const Seat& a = patchSeats_[pull.vertices[i]];
                const Seat& b = patchSeats_[pull.vertices[j]];
                if (a.group >= 0 && a.group == b.group && a.place >= b.place &&
                    moves(pull.vertices[i]) && moves(pull.vertices[j])) {
                    out_.patches[a.group].block<3, 3>(3 * a.place, 3 * b.place) +=
                        stiffness * pull.gradients[i] * pull.gradients[j].transpose();
                }
            }
        }
    }

    /// Most constraints lie inside an aggregate: so its vertices are summed up first.
    void addToCoarse(const ConstraintPull& pull, double stiffness) {
        std::array<int, 4> aggregates{};
        std::array<Modes, 4> gradients;  // by modes
        int count = 0;
        for (int i = 0; i < pull.count; ++i) {
            const std::uint32_t v = pull.vertices[i];
            if (seats_[v].group < 0 || !moves(v)) {
                continue;
            }
            const auto end = aggregates.begin() + count;
            const auto place = std::find(aggregates.begin(), end, seats_[v].group);
            Modes& gradient = gradients[place - aggregates.begin()];
            if (place == end) {
                aggregates[count++] = seats_[v].group;
                gradient.setZero();
            }
            for (int m = 0; m < 4; ++m) {
                gradient.segment<3>(3 * m) += shares_[v][m] * pull.gradients[i];
            }
        }
        for (int i = 0; i < count; ++i) {
            for (int j = 0; j < count; ++j) {
                if (aggregates[i] >= aggregates[j]) {
                    CoarseMatrix::Block& block = blockOf(aggregates[i], aggregates[j]);
                    const Modes force = stiffness * gradients[i];
                    for (int column = 0; column < block.cols(); ++column) {
                        block.col(column) += gradients[j][column] * force;
                    }
                }
            }
        }
    }

    /// Of two aggregates of a piece, not before the second.
    CoarseMatrix::Block& blockOf(int aggregate, int other) {
        return coarse_[pieceOf_[aggregate]].at(row_[aggregate], row_[other]);
    }

    /// Flat aggregates and those of few vertices have modes that move nothing.
    static void makeDefinite(CoarseMatrix& matrix) {
        double largest = 0;
        for (int a = 0; a < matrix.count(); ++a) {
            largest = std::max(largest, matrix.at(a, a).diagonal().maxCoeff());
        }
        for (int a = 0; a < matrix.count(); ++a) {
            for (double& own : matrix.at(a, a).diagonal()) {
                own = own > 0 ? own * (1 + 1e-9) + 1e-13 * largest : (largest > 0 ? largest : 1.0);
            }
        }
    }

    std::span<const Vec3> rest_;
    std::span<const double> masses_;
    std::vector<Seat> patchSeats_;
    std::vector<Seat> seats_;  ///< among the aggregates
    std::vector<Eigen::Vector4d> shares_;
    std::vector<int> row_;              ///< of each aggregate in the matrix of its piece
    std::vector<int> pieceOf_;          ///< RestInverse::pieces of each aggregate
    std::vector<CoarseMatrix> coarse_;  ///< of each of these pieces
    RestInverse out_;
};

}  // namespace

Eigen::Vector4d AggregateFrame::sharesAt(const Vec3& p) const {
    Eigen::Vector4d shares;
    shares << 1, (p - center).cwiseQuotient(size);
    return shares;
}

StageScale stageScale(double step, double damping) {
    const double s = (1 - std::sqrt(0.5)) * step;
    return {s, 1 / (s * s), 1 + 2 * damping / step};
}

TypeModuli typeModuli(const Params& params) {
    TypeModuli moduli{};
    constexpr double kFirmest = 1000;  // as firm as a part gets that the parameters call rigid
    for (std::uint32_t type = 0; type < kConstraintTypes; ++type) {
        moduli[type] = params.youngsModulus * std::min(modulusFactor(type, params), kFirmest);
    }
    return moduli;
}

std::vector<double> massesWithout(const BodyModel& model, double density,
                                  std::span<const std::uint32_t> pinned) {
    std::vector<double> masses = unitMasses(model);
    for (double& mass : masses) {
        mass *= density;
    }
    for (const std::uint32_t v : pinned) {
        masses[v] = 0;
    }
    return masses;
}

double contactRate(double step) {
    return std::max<double>(shared::kContactRate, shared::kContactTurn / step);
}

std::vector<double> contactFirmness(std::span<const ConstraintPull> pulls,
                                    std::size_t vertexCount) {
    std::vector<double> firmness(vertexCount);
    for (const ConstraintPull& pull : pulls) {
        for (int k = 0; k < pull.count; ++k) {
            firmness[pull.vertices[k]] +=
                shared::kContactShare * pull.stiffness * pull.gradients[k].squaredNorm() / 3;
        }
    }
    return firmness;
}

RestInverse invertAtRest(const BodyModel& model, std::span<const ConstraintPull> pulls,
                         const VertexGroups& groups, std::span<const double> masses,
                         const StageScale& scale) {
    const std::vector<Vec3> rest = restPlaces(model);
    RestSystem system(model, groups, rest, masses);
    for (std::uint32_t v = 0; v < rest.size(); ++v) {
        system.addMass(v, scale.inertia);
    }
    for (const ConstraintPull& pull : pulls) {
        system.addPull(pull, pull.stiffness * scale.damped);
    }
    return system.inverted();
}

}  // namespace kerf
