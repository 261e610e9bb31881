#include "sim/solve/implicit/rest_inverse.h"

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
          aggregates_(groups.aggregates, rest, masses),
          regions_(vertexGroupsOf(groups), rest, masses),
          hasLevelBetween_(groups.hasLevelBetween()),
          shared_(groups.aggregates.size(), true) {
        for (const VertexGroup& patch : groups.patches) {
            const auto rows = static_cast<Eigen::Index>(3 * patch.size());
            out_.patches.push_back(MatrixXd::Zero(rows, rows));
        }
        out_.own.assign(groups.aggregates.size(), CoarseMatrix::Block::Zero());
        std::vector<int> coarse(model.pieces.size(), -1);
        for (std::uint32_t r = 0; r < groups.regions.size(); ++r) {
            const std::vector<std::uint32_t>& region = groups.regions[r];
            if (region.size() == 1) {
                shared_[region[0]] = false;
            }
            int& piece = coarse[model.pieceOfVertex[groups.aggregates[region[0]][0]]];
            if (piece < 0) {
                piece = static_cast<int>(out_.pieces.size());
                out_.pieces.emplace_back();
            }
            row_.push_back(static_cast<int>(out_.pieces[piece].regions.size()));
            pieceOf_.push_back(piece);
            out_.pieces[piece].regions.push_back(r);
        }
        for (const CoarsePiece& piece : out_.pieces) {
            coarse_.emplace_back(static_cast<int>(piece.regions.size()));
        }
    }

    void addMass(std::uint32_t v, double inertia) {
        if (const Seat& seat = patchSeats_[v]; seat.group >= 0) {
            const double own = masses_[v] > 0 ? inertia * masses_[v] : 1.0;
            out_.patches[seat.group].diagonal().segment<3>(3 * seat.place).array() += own;
        }
        const int region = regions_.seats[v].group;
        if (region < 0 || masses_[v] <= 0) {
            return;
        }
        addMassTo(blockOf(region, region), inertia * masses_[v], regions_.shares[v]);
        if (const int aggregate = aggregates_.seats[v].group; shared_[aggregate]) {
            addMassTo(out_.own[aggregate], inertia * masses_[v], aggregates_.shares[v]);
        }
    }

    void addPull(const ConstraintPull& pull, double stiffness) {
        addToPatches(pull, stiffness);
        addByModes(pull, stiffness, regions_, [&](int i, int j) { return &blockOf(i, j); });
        if (hasLevelBetween_) {
            addByModes(pull, stiffness, aggregates_,
                       [&](int i, int j) { return i == j && shared_[i] ? &out_.own[i] : nullptr; });
        }
    }

    RestInverse inverted() {
        for (MatrixXd& patch : out_.patches) {
            invertPatch(patch);
        }
        for (std::size_t piece = 0; piece < coarse_.size(); ++piece) {
            holdStill(coarse_[piece], out_.pieces[piece].regions);
            out_.pieces[piece].inverse = coarse_[piece].invert();
        }
        for (std::size_t a = 0; a < shared_.size(); ++a) {
            if (CoarseMatrix::Block& own = out_.own[a]; shared_[a]) {
                holdStill(own, aggregates_.idle[a], largestOf(own));
                own = own.llt().solve(CoarseMatrix::Block::Identity()).eval();
            }
        }
        out_.frames = std::move(aggregates_.frames);
        out_.regionFrames = std::move(regions_.frames);
        return std::move(out_);
    }

  private:
    using Modes = Eigen::Matrix<double, AggregateFrame::kModes, 1>;

    /// Groups whose vertices move by modes.
    struct Moved {
        Moved(const std::vector<VertexGroup>& groups, std::span<const Vec3> rest,
              std::span<const double> masses)
            : seats(seatsOf(groups, rest.size())), shares(rest.size()) {
            for (const VertexGroup& group : groups) {
                frames.push_back(frameOf(group, rest));
                Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
                for (const std::uint32_t v : group) {
                    shares[v] = frames.back().sharesAt(rest[v]);
                    if (masses[v] > 0) {
                        squares += shares[v] * shares[v].transpose();
                    }
                }
                idle.push_back(idleOf(squares));
            }
        }
        std::vector<Seat> seats;
        std::vector<AggregateFrame> frames;
        std::vector<Eigen::Vector4d> shares;
        std::vector<Eigen::Matrix4d> idle;  ///< onto what moves none of its vertices
    };

    /// The projection onto sums of modes that hardly move any vertex, as across a flat wall.
    /// Rounded to floats, what answers to those would drown the rest.
    static Eigen::Matrix4d idleOf(const Eigen::Matrix4d& squares) {
        constexpr double kHardly = 1e-3;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> modes(squares);
        Eigen::Matrix4d idle = Eigen::Matrix4d::Zero();
        for (int m = 0; m < 4; ++m) {
            const Eigen::Vector4d mode = modes.eigenvectors().col(m);
            if (!(modes.eigenvalues()[m] > kHardly * modes.eigenvalues()[3])) {
                idle += mode * mode.transpose();
            }
        }
        return idle;
    }

    static std::vector<VertexGroup> vertexGroupsOf(const VertexGroups& groups) {
        std::vector<VertexGroup> regions;
        for (const std::vector<std::uint32_t>& region : groups.regions) {
            regions.push_back(groups.verticesOf(region));
        }
        return regions;
    }

    static void addMassTo(CoarseMatrix::Block& block, double own, const Eigen::Vector4d& shares) {
        for (int m = 0; m < 4; ++m) {
            for (int n = 0; n < 4; ++n) {
                for (int axis = 0; axis < 3; ++axis) {
                    block(3 * m + axis, 3 * n + axis) += own * shares[m] * shares[n];
                }
            }
        }
    }

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

    /// Most constraints lie inside a group: so its vertices are summed up first. `blockAt`: of two
    /// groups, the second no later one; null: not asked for.
    template <class BlockAt>
    void addByModes(const ConstraintPull& pull, double stiffness, const Moved& moved,
                    const BlockAt& blockAt) {
        std::array<int, 4> groups{};
        std::array<Modes, 4> gradients;  // by modes
        int count = 0;
        for (int i = 0; i < pull.count; ++i) {
            const std::uint32_t v = pull.vertices[i];
            if (moved.seats[v].group < 0 || !moves(v)) {
                continue;
            }
            const auto end = groups.begin() + count;
            const auto place = std::find(groups.begin(), end, moved.seats[v].group);
            Modes& gradient = gradients[place - groups.begin()];
            if (place == end) {
                groups[count++] = moved.seats[v].group;
                gradient.setZero();
            }
            for (int m = 0; m < 4; ++m) {
                gradient.segment<3>(3 * m) += moved.shares[v][m] * pull.gradients[i];
            }
        }
        for (int i = 0; i < count; ++i) {
            for (int j = 0; j < count; ++j) {
                CoarseMatrix::Block* block =
                    groups[i] >= groups[j] ? blockAt(groups[i], groups[j]) : nullptr;
                if (block != nullptr) {
                    const Modes force = stiffness * gradients[i];
                    for (int column = 0; column < block->cols(); ++column) {
                        block->col(column) += gradients[j][column] * force;
                    }
                }
            }
        }
    }

    /// Of two regions of a piece, not before the second.
    CoarseMatrix::Block& blockOf(int region, int other) {
        return coarse_[pieceOf_[region]].at(row_[region], row_[other]);
    }

    static double largestOf(const CoarseMatrix::Block& block) {
        const double largest = block.diagonal().maxCoeff();
        return largest > 0 ? largest : 1.0;
    }
    void holdStill(CoarseMatrix& matrix, std::span<const std::uint32_t> regions) {
        double largest = 0;
        for (int r = 0; r < matrix.count(); ++r) {
            largest = std::max(largest, largestOf(matrix.at(r, r)));
        }
        for (int r = 0; r < matrix.count(); ++r) {
            holdStill(matrix.at(r, r), regions_.idle[regions[r]], largest);
        }
    }
    /// Lets modes that move nothing answer to nothing.
    static void holdStill(CoarseMatrix::Block& block, const Eigen::Matrix4d& idle,
                          double firmness) {
        for (int m = 0; m < 4; ++m) {
            for (int n = 0; n < 4; ++n) {
                block.block<3, 3>(3 * m, 3 * n).diagonal().array() += firmness * idle(m, n);
            }
        }
    }

    std::span<const Vec3> rest_;
    std::span<const double> masses_;
    std::vector<Seat> patchSeats_;
    Moved aggregates_, regions_;
    bool hasLevelBetween_;
    std::vector<bool> shared_;          ///< by aggregate: its region has others
    std::vector<int> row_;              ///< of each region in the matrix of its piece
    std::vector<int> pieceOf_;          ///< RestInverse::pieces of each region
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
    const double s = stageOf(step);
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
