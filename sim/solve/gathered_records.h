#pragma once

#include <cstdint>
#include <vector>

#include "shaders/shared/body_records.h"
#include "sim/body/body_updater.h"

namespace kerf {

// The constraints of a body as the solver's kernels read them: seen from their vertices, at the
// places of the model's incidence lists.

/// The spoke at a place of the list of the edges that is in use.
shared::Spoke spokeAt(const BodyModel& model, std::uint32_t place);
/// All spokes, shape [edgeIncidence.entries]; places that are not in use are zero.
std::vector<shared::Spoke> allSpokes(const BodyModel& model);
/// Ascending: the places whose spoke a change touched, by an edge of theirs or by the number of
/// those at its far end.
std::vector<std::uint32_t> changedSpokes(const BodyModel& model, const BodyChange& change);

shared::BendRecord bendRecord(const BendConstraint& bend);
std::vector<shared::BendRecord> allBendRecords(const BodyModel& model);

/// The lists of the bends at the vertices, those of which a vertex is an end of the edge first.
struct BendLists {
    std::vector<shared::BendRange> ranges;  ///< shape [vertexCount]
    std::vector<std::uint32_t> entries;     ///< shape [bendIncidence.entries], see BendRange

    void assign(const BodyModel& model);
    /// Follows the lists of these vertices.
    void update(const BodyModel& model, const std::vector<std::uint32_t>& vertices);
};

/// The share at a place of the list of the ISPCs that is in use.
shared::IspcShare ispcShareAt(const BodyModel& model, std::uint32_t place);
/// All shares, shape [ispcIncidence.entries]; places that are not in use are zero.
std::vector<shared::IspcShare> allIspcShares(const BodyModel& model);
/// Ascending: the places whose share a change touched.
std::vector<std::uint32_t> changedIspcShares(const BodyModel& model, const BodyChange& change);

/// Ascending: the places of `vertices` in the lists of an incidence.
std::vector<std::uint32_t> placesOf(const Incidence& incidence,
                                    const std::vector<std::uint32_t>& vertices);

}  // namespace kerf
