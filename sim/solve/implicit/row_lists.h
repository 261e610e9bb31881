#pragma once

#include "shaders/shared/implicit_records.h"
#include "sim/body/body_model.h"

namespace kerf {

/// Where the factors of the constraints of each type begin (shaders/sim/implicit/factors.comp).
struct FactorPlaces {
    std::array<std::uint32_t, kConstraintTypes> first{};
    std::uint32_t count = 0;  ///< of all

    explicit FactorPlaces(const BodyModel& model);
};

/// The blocks beside the diagonal in the matrix of an implicit stage, row by row, and which
/// constraints add up to each.
struct RowLists {
    std::vector<IncidenceRange> rows;           ///< of each vertex: its blocks
    std::vector<shared::ImplicitBlock> blocks;  ///< sorted for their kernel, see `place`
    std::vector<IncidenceRange> own;            ///< of each vertex: shares of its own forces
    std::vector<std::uint32_t> shares;          ///< see shared::kSlotBits
};

/// Of a body whose edges lie on the GPU at the places of its incidence lists.
RowLists rowListsOf(const BodyModel& model);

/// The vertex of each place of the lists of edges; shared::kNoVertex for those not in use.
std::vector<std::uint32_t> spokeOwners(const BodyModel& model);

/// The vertices on each page, long rows first, so that threads beside each other end together.
/// `places`: as VertexPages has them, shared::kNoVertex for holes.
std::vector<std::uint32_t> rowOrder(const RowLists& lists, std::span<const std::uint32_t> places);

}  // namespace kerf
