#pragma once

#include "sim/body/body_model.h"
#include "sim/solve/implicit/constraint_pull.h"

namespace kerf {

/// Vertices that belong together.
using VertexGroup = std::vector<std::uint32_t>;

/// The ways in which the vertices of a body are grouped for the preconditioner of the implicit
/// solver. Each vertex that has a mass is in one group of each.
struct VertexGroups {
    std::vector<VertexGroup> patches;  ///< small ones, which hold together most firmly
    /// Larger ones, in which a path of constraints leads from each vertex to each other, so that
    /// none has both walls of a slit.
    std::vector<VertexGroup> aggregates;
    /// Larger ones yet, of whole aggregates that hang together, each its numbers. Where a piece has
    /// kMostAggregates at most, each is a region.
    std::vector<std::vector<std::uint32_t>> regions;

    VertexGroup verticesOf(const std::vector<std::uint32_t>& region) const;
    /// Whether any region has several aggregates.
    bool hasLevelBetween() const { return regions.size() < aggregates.size(); }
};

/// Where a vertex is among groups; group -1: in none.
struct Seat {
    int group = -1;
    int place = 0;
};
/// The seats of all vertices of a body.
std::vector<Seat> seatsOf(const std::vector<VertexGroup>& groups, std::size_t vertexCount);

inline constexpr std::size_t kPatchSize = 12;    ///< vertices of a patch, as a rule
inline constexpr std::size_t kMostOfPatch = 16;  ///< where leftovers have joined it
/// Of a piece, whose modes are inverted together: what that takes grows by the square.
inline constexpr std::size_t kMostAggregates = 128;
inline constexpr std::size_t kRegions = 96;  ///< of the largest piece, or up to twice as many
/// Groups the vertices of a body by its rest shape. `pulls`: pullsAtRest(). `aggregateSize`:
/// vertices of an aggregate, at most but for leftovers that joined it; with them twice as many,
/// shared::kMostMembers at most.
VertexGroups groupVertices(const BodyModel& model, std::span<const ConstraintPull> pulls,
                           std::size_t aggregateSize);

}  // namespace kerf
