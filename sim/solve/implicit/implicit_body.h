#pragma once

#include "gpu/buffer.h"
#include "shaders/shared/implicit_records.h"
#include "sim/solve/implicit/rest_inverse.h"
#include "sim/solve/implicit/row_lists.h"

namespace kerf {

/// The matrix of a stage. Lists are constant between cuts; factors, pulls and blocks are of the
/// present step.
struct MatrixBuffers {
    gpu::Buffer rows{gpu::Buffer::Readers::texels};
    gpu::Buffer blockList{gpu::Buffer::Readers::texels};
    gpu::Buffer ownShares{gpu::Buffer::Readers::texels};
    gpu::Buffer blockShares{gpu::Buffer::Readers::texels};
    gpu::Buffer rowOrder{gpu::Buffer::Readers::texels};
    gpu::Buffer pageTable{gpu::Buffer::Readers::texels};
    gpu::Buffer spokeOwners{gpu::Buffer::Readers::texels};
    // Written part by part where they exceed what shaders may write to at once.
    gpu::Buffer factors{gpu::Buffer::Readers::texels};
    gpu::Buffer blocks{gpu::Buffer::Readers::texels};
    gpu::Buffer pulls;
    std::array<std::uint32_t, kConstraintTypes> firstFactor{};  ///< of each type
    std::uint32_t blockCount = 0;                               ///< see RowLists
    std::uint32_t pageCount = 0;                                ///< of the table of pages

    /// `places`, `pagesOfPieces`: as VertexPages has them.
    void assign(const BodyModel& model, std::span<const std::uint32_t> places,
                std::span<const std::vector<std::uint32_t>> pagesOfPieces);
};

/// The preconditioner of a stage. Constant between cuts, but for turns, modes and turned.
struct InverseBuffers {
    gpu::Buffer pieces;
    std::vector<shared::ImplicitPiece> pieceRecords;  ///< as a step finds them
    gpu::Buffer aggregates{gpu::Buffer::Readers::texels};
    gpu::Buffer members{gpu::Buffer::Readers::texels};
    gpu::Buffer memberShares{gpu::Buffer::Readers::texels};
    gpu::Buffer patches{gpu::Buffer::Readers::texels};
    gpu::Buffer patchInverse{gpu::Buffer::Readers::texels};
    gpu::Buffer coarse{gpu::Buffer::Readers::texels};
    gpu::Buffer regions{gpu::Buffer::Readers::texels};
    gpu::Buffer levels{gpu::Buffer::Readers::texels};
    gpu::Buffer turns, modes, turned;
    std::uint32_t patchCount = 0;
    std::uint32_t aggregateCount = 0;
    std::uint32_t regionCount = 0;  ///< 0: each aggregate is one

    void assign(const BodyModel& model, const VertexGroups& groups, const RestInverse& inverse,
                std::span<const std::vector<std::uint32_t>> pagesOfPieces);
};

/// The vectors of a stage, and sums over their elements.
struct StageVectors {
    gpu::Buffer residual, total, answer, direction, image, way, firstWay, force;
    gpu::Buffer drift;  ///< the matrix times the way of what is held
    gpu::Buffer pressure, pressureImage;
    gpu::Buffer productSums, answerSums;
    gpu::Buffer motions, spins;  ///< of aggregates, of pieces

    void makeRoom(std::size_t vertexCount, std::size_t aggregates, std::size_t pieces);
    /// `pages`, `aggregates`: how many sums each slot has.
    void makeSlots(std::uint32_t slots, std::uint32_t pages, std::uint32_t aggregates);
};

/// What a body meets in a step: see shared::ContactRow.
struct ContactBuffers {
    gpu::Buffer rows, rowVertices, list, states, relatives;
    gpu::Buffer keptSlips;  ///< between steps
    gpu::Buffer forces;     ///< sums by vertex, 0 between the kernels that add and take them
    gpu::Buffer parents, reaches;
    gpu::Buffer firmness{gpu::Buffer::Readers::texels};
    gpu::Buffer unjoined{gpu::Buffer::Readers::texels};  ///< parents before a step
    /// The most that a contact of a piece pushes with.
    struct Most {
        double firmness = 0;  ///< of contactFirmness() [N/m]
        double mass = 0;      ///< of a vertex [kg]
        double depth = 0;     ///< [m]
    };
    std::vector<Most> most;  ///< by piece

    /// Of all vertices, pulls, and an edge that presses.
    void makeRows(std::size_t count);
    /// Keeps what pushed and held. `firmness`: contactFirmness(); `masses`: of the vertices [kg];
    /// `pages`: of all pieces.
    void assign(const BodyModel& model, std::span<const double> firmness,
                std::span<const double> masses, std::uint32_t pages);
};

/// What the implicit solver has of a body besides SolverModel. All that allocates throws
/// gpu::OutOfMemory.
struct ImplicitBody {
    MatrixBuffers matrix;
    InverseBuffers inverse;
    ContactBuffers contact;
    StageVectors vectors;

    /// In what forces of contact are added up. `stiffness`: ImplicitContact's [1/s^2].
    void setForceUnits(double stiffness);
};

}  // namespace kerf
