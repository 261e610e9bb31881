#include "tests/support/reference/implicit/preconditioner.h"

namespace kerf {

namespace {

/// The rotation that fits best from the rest shape of a group to where it is.
Eigen::Matrix3d turnOf(const VertexGroup& group, std::span<const Vec3> rest,
                       std::span<const Vec3> positions) {
    Vec3 restCenter = Vec3::Zero();
    Vec3 center = Vec3::Zero();
    for (const std::uint32_t v : group) {
        restCenter += rest[v] / static_cast<double>(group.size());
        center += positions[v] / static_cast<double>(group.size());
    }
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const std::uint32_t v : group) {
        moments += (positions[v] - center) * (rest[v] - restCenter).transpose();
    }
    if (!(moments.norm() > 1e-20)) {
        return Eigen::Matrix3d::Identity();
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moments, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Vec3 signs = Vec3::Ones();
    signs.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant();
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace

Preconditioner::Preconditioner(const BodyModel& model, const VertexGroups& groups,
                               const RestInverse& inverse, std::span<const double> masses)
    : groups_(groups),
      inverse_(inverse),
      masses_(masses),
      rest_(restPlaces(model)),
      patchTurns_(groups.patches.size(), Eigen::Matrix3d::Identity()),
      aggregateTurns_(groups.aggregates.size(), Eigen::Matrix3d::Identity()),
      regionTurns_(groups.regions.size(), Eigen::Matrix3d::Identity()) {
    for (const std::vector<std::uint32_t>& region : groups.regions) {
        regions_.push_back(groups.verticesOf(region));
    }
}

void Preconditioner::turn(std::span<const Vec3> positions) {
    const auto turnAll = [&](const std::vector<VertexGroup>& groups,
                             std::vector<Eigen::Matrix3d>& turns) {
        for (std::size_t g = 0; g < groups.size(); ++g) {
            turns[g] = turnOf(groups[g], rest_, positions);
        }
    };
    turnAll(groups_.patches, patchTurns_);
    turnAll(groups_.aggregates, aggregateTurns_);
    turnAll(regions_, regionTurns_);
}

Vectors Preconditioner::apply(std::span<const Vec3> residual) const {
    Vectors out(residual.size(), Vec3::Zero());
    addPatches(residual, out);
    if (groups_.hasLevelBetween()) {
        addAggregates(residual, out);
    }
    addRegions(residual, out);
    for (std::size_t v = 0; v < out.size(); ++v) {
        if (masses_[v] <= 0) {
            out[v].setZero();
        }
    }
    return out;
}

void Preconditioner::addPatches(std::span<const Vec3> residual, Vectors& out) const {
    for (std::size_t g = 0; g < groups_.patches.size(); ++g) {
        const VertexGroup& patch = groups_.patches[g];
        Eigen::VectorXd local(3 * patch.size());
        for (std::size_t k = 0; k < patch.size(); ++k) {
            local.segment<3>(3 * k) = patchTurns_[g].transpose() * residual[patch[k]];
        }
        local = (inverse_.patches[g] * local).eval();
        for (std::size_t k = 0; k < patch.size(); ++k) {
            out[patch[k]] += patchTurns_[g] * local.segment<3>(3 * k);
        }
    }
}

void Preconditioner::addAggregates(std::span<const Vec3> residual, Vectors& out) const {
    for (std::size_t a = 0; a < groups_.aggregates.size(); ++a) {
        const Moved aggregate{groups_.aggregates[a], inverse_.frames[a], aggregateTurns_[a]};
        addMotion(aggregate, inverse_.own[a] * residualOf(aggregate, residual), out);
    }
}

void Preconditioner::addRegions(std::span<const Vec3> residual, Vectors& out) const {
    constexpr int kModes = AggregateFrame::kModes;
    const auto moved = [&](std::uint32_t r) {
        return Moved{regions_[r], inverse_.regionFrames[r], regionTurns_[r]};
    };
    for (const CoarsePiece& piece : inverse_.pieces) {
        const auto& [places, matrix] = piece.inverse;
        Eigen::VectorXd coarse(matrix.rows());
        for (std::size_t k = 0; k < piece.regions.size(); ++k) {
            coarse.segment<kModes>(kModes * places[k]) =
                residualOf(moved(piece.regions[k]), residual);
        }
        coarse = (matrix * coarse).eval();
        for (std::size_t k = 0; k < piece.regions.size(); ++k) {
            addMotion(moved(piece.regions[k]), coarse.segment<kModes>(kModes * places[k]), out);
        }
    }
}

Preconditioner::Modes Preconditioner::residualOf(const Moved& group,
                                                 std::span<const Vec3> residual) const {
    Modes modes = Modes::Zero();
    for (const std::uint32_t v : group.vertices) {
        const Eigen::Vector4d shares = group.frame.sharesAt(rest_[v]);
        const Vec3 turned = group.turn.transpose() * residual[v];
        for (int m = 0; m < 4 && masses_[v] > 0; ++m) {
            modes.segment<3>(3 * m) += shares[m] * turned;
        }
    }
    return modes;
}

void Preconditioner::addMotion(const Moved& group, const Modes& modes, Vectors& out) const {
    for (const std::uint32_t v : group.vertices) {
        const Eigen::Vector4d shares = group.frame.sharesAt(rest_[v]);
        for (int m = 0; m < 4; ++m) {
            out[v] += group.turn * (shares[m] * modes.segment<3>(3 * m)).eval();
        }
    }
}

}  // namespace kerf
