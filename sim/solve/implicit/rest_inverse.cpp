#include "sim/solve/implicit/rest_inverse.h"

#include <algorithm>
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
    const double least = 2 * kFlattest * half.maxCoeff() + 1e-9;
    return {bounds.center(), half.cwiseMax(least)};
}

/// Adds up the system in parts while the constraints are gone through.
class RestSystem {
  public:
    RestSystem(const BodyModel& model, const VertexGroups& groups, std::span<const Vec3> rest,
               std::span<const double> masses)
        : rest_(rest),
          masses_(masses),
          patchSeats_(seatsOf(groups.patches, rest.size())),
          seats_(seatsOf(groups.aggregates, rest.size())) {
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
            corner_.push_back(AggregateFrame::kModes *
                              static_cast<int>(out_.pieces[piece].aggregates.size()));
            pieceOf_.push_back(piece);
            out_.pieces[piece].aggregates.push_back(a);
        }
        for (CoarsePiece& piece : out_.pieces) {
            const auto rows =
                static_cast<Eigen::Index>(AggregateFrame::kModes * piece.aggregates.size());
            piece.inverse = MatrixXd::Zero(rows, rows);
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
        const Eigen::Vector4d shares = out_.frames[aggregate].sharesAt(rest_[v]);
        MatrixXd& matrix = out_.pieces[pieceOf_[aggregate]].inverse;
        for (int m = 0; m < 4; ++m) {
            for (int n = 0; n < 4; ++n) {
                for (int axis = 0; axis < 3; ++axis) {
                    matrix(corner_[aggregate] + 3 * m + axis, corner_[aggregate] + 3 * n + axis) +=
                        inertia * masses_[v] * shares[m] * shares[n];
                }
            }
        }
    }

    void addPull(const ConstraintPull& pull, double stiffness) {
        for (int i = 0; i < pull.count; ++i) {
            for (int j = 0; j < pull.count; ++j) {
                addToPatch(pull, i, j, stiffness);
                addToCoarse(pull, i, j, stiffness);
            }
        }
    }

    RestInverse inverted() {
        for (MatrixXd& patch : out_.patches) {
            patch = patch.llt().solve(MatrixXd::Identity(patch.rows(), patch.cols())).eval();
        }
        for (CoarsePiece& piece : out_.pieces) {
            invertCoarse(piece.inverse);
        }
        return std::move(out_);
    }

  private:
    bool moves(std::uint32_t v) const { return masses_[v] > 0; }

    void addToPatch(const ConstraintPull& pull, int i, int j, double stiffness) {
        const Seat& a = patchSeats_[pull.vertices[i]];
        const Seat& b = patchSeats_[pull.vertices[j]];
        if (a.group >= 0 && a.group == b.group && moves(pull.vertices[i]) &&
            moves(pull.vertices[j])) {
            out_.patches[a.group].block<3, 3>(3 * a.place, 3 * b.place) +=
                stiffness * pull.gradients[i] * pull.gradients[j].transpose();
        }
    }

    void addToCoarse(const ConstraintPull& pull, int i, int j, double stiffness) {
        const std::uint32_t v = pull.vertices[i];
        const std::uint32_t w = pull.vertices[j];
        const int a = seats_[v].group;
        const int b = seats_[w].group;
        if (a < 0 || b < 0 || !moves(v) || !moves(w)) {
            return;
        }
        const Eigen::Matrix3d block = stiffness * pull.gradients[i] * pull.gradients[j].transpose();
        const Eigen::Vector4d left = out_.frames[a].sharesAt(rest_[v]);
        const Eigen::Vector4d right = out_.frames[b].sharesAt(rest_[w]);
        MatrixXd& matrix = out_.pieces[pieceOf_[a]].inverse;
        for (int m = 0; m < 4; ++m) {
            for (int n = 0; n < 4; ++n) {
                matrix.block<3, 3>(corner_[a] + 3 * m, corner_[b] + 3 * n) +=
                    left[m] * right[n] * block;
            }
        }
    }

    /// Flat aggregates and those of few vertices have modes that move nothing.
    static void invertCoarse(MatrixXd& matrix) {
        const double largest = matrix.diagonal().maxCoeff();
        for (Eigen::Index k = 0; k < matrix.rows(); ++k) {
            double& own = matrix(k, k);
            own = own > 0 ? own * (1 + 1e-9) + 1e-13 * largest : std::max(largest, 1.0);
        }
        matrix = matrix.llt().solve(MatrixXd::Identity(matrix.rows(), matrix.cols())).eval();
    }

    std::span<const Vec3> rest_;
    std::span<const double> masses_;
    std::vector<Seat> patchSeats_;
    std::vector<Seat> seats_;   ///< among the aggregates
    std::vector<int> corner_;   ///< first row of each aggregate in the matrix of its piece
    std::vector<int> pieceOf_;  ///< RestInverse::pieces of each aggregate
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

std::vector<double> contactFirmness(const BodyModel& model, const TypeModuli& moduli) {
    std::vector<double> firmness(model.restPositions.size());
    forEachPull(
        model, moduli, bendSteepness(model), restPlaces(model), [&](const ConstraintPull& pull) {
            for (int k = 0; k < pull.count; ++k) {
                firmness[pull.vertices[k]] +=
                    shared::kContactShare * pull.stiffness * pull.gradients[k].squaredNorm() / 3;
            }
        });
    return firmness;
}

RestInverse invertAtRest(const BodyModel& model, const TypeModuli& moduli,
                         const VertexGroups& groups, std::span<const double> masses,
                         const StageScale& scale) {
    const std::vector<Vec3> rest = restPlaces(model);
    RestSystem system(model, groups, rest, masses);
    for (std::uint32_t v = 0; v < rest.size(); ++v) {
        system.addMass(v, scale.inertia);
    }
    forEachPull(model, moduli, bendSteepness(model), rest, [&](const ConstraintPull& pull) {
        system.addPull(pull, pull.stiffness * scale.damped);
    });
    return system.inverted();
}

}  // namespace kerf
