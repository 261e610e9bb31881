#pragma once

#include <Eigen/Dense>

#include "sim/base/params.h"
#include "sim/solve/implicit/coarse_matrix.h"
#include "sim/solve/implicit/vertex_groups.h"

namespace kerf {

/// An aggregate or a region moves as an affine map of its rest shape would: of a vertex at rest
/// position p the first three modes are translations, the others those times (p - center) / size,
/// axis by axis.
struct AggregateFrame {
    static constexpr int kModes = CoarseMatrix::kRows;

    Vec3 center = Vec3::Zero();  ///< [m]
    Vec3 size = Vec3::Ones();    ///< [m]

    /// The shares of a vertex at rest position `p` in four modes that move it along one axis: mode
    /// 3 m + axis has the share m.
    Eigen::Vector4d sharesAt(const Vec3& p) const;
};

/// The regions of a piece and the inverse of the system for their modes.
struct CoarsePiece {
    std::vector<std::uint32_t> regions;
    CoarseMatrix::Inverse inverse;  ///< a row of blocks for each of `regions` [m/N]
};

/// What an implicit stage does to a body at rest, inverted by parts. A function of the model, the
/// parameters and the pins alone. Near another shape of the body the parts are still good if they
/// turn with their vertices.
struct RestInverse {
    std::vector<Eigen::MatrixXd> patches;  ///< of each patch, three rows for each vertex [m/N]
    std::vector<AggregateFrame> frames;    ///< of each aggregate
    /// Of each aggregate, the inverse of the system for its modes alone; 0 of one that is a region
    /// [m/N].
    std::vector<CoarseMatrix::Block> own;
    std::vector<AggregateFrame> regionFrames;
    std::vector<CoarsePiece> pieces;
};

/// The system of a stage: M / s^2 + (1 + 2 beta / h) K.
struct StageScale {
    double stage = 0;    ///< s = (1 - sqrt(1/2)) h, of SDIRK2 [s]
    double inertia = 0;  ///< 1 / s^2 [1/s^2]
    double damped = 1;   ///< 1 + 2 beta / h
};
/// Of steps of h = `step`, with damping beta [s].
StageScale stageScale(double step, double damping);

/// The modulus of each type of constraints by the parameters.
TypeModuli typeModuli(const Params& params);
/// The masses of all vertices, those of `pinned` 0 [kg].
std::vector<double> massesWithout(const BodyModel& model, double density,
                                  std::span<const std::uint32_t> pinned);

/// By which contacts of each vertex are firm, besides mass * contactRate()^2 [N/m]: see
/// shared::kContactShare. `pulls`: pullsAtRest().
std::vector<double> contactFirmness(std::span<const ConstraintPull> pulls, std::size_t vertexCount);
/// In steps of this length [s]: at which mass is stopped by a contact [1/s].
double contactRate(double step);

/// `pulls`: pullsAtRest(); `masses`: of the vertices [kg]; those of 0 do not move.
RestInverse invertAtRest(const BodyModel& model, std::span<const ConstraintPull> pulls,
                         const VertexGroups& groups, std::span<const double> masses,
                         const StageScale& scale);

}  // namespace kerf
