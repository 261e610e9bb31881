#pragma once

#include "shaders/shared/body_records.h"
#include "sim/body/body_model.h"

namespace kerf {

// The constraints of a body as the solver's kernels read them: their records, and what they are
// seen from their vertices, at the places of the model's incidence lists.

/// The record on the GPU: that of the CPU, except for bends. `rest`: of all vertices [m].
template <class Constraint>
const Constraint& recordOf(const Constraint& constraint, const std::vector<Vec3f>&) {
    return constraint;
}
shared::BendRecord recordOf(const BendConstraint& bend, const std::vector<Vec3f>& rest);

/// The list of a vertex. Bends with it at an end of their edge come first.
template <class Gather>
const typename Gather::Range& rangeAt(Gather, const Incidence& incidence, std::uint32_t vertex) {
    return incidence.ranges[vertex];
}
shared::BendRange rangeAt(WingPulls, const Incidence& incidence, std::uint32_t vertex);

// What lies at a place of the lists that is in use.
shared::Spoke entryAt(Spokes, const std::vector<EdgeConstraint>& edges, const Incidence& incidence,
                      std::uint32_t place);
std::uint32_t entryAt(WingPulls, const std::vector<BendConstraint>& bends,
                      const Incidence& incidence, std::uint32_t place);
template <class Constraint>
shared::ConstraintShare entryAt(Shares, const std::vector<Constraint>& constraints,
                                const Incidence& incidence, std::uint32_t place) {
    const std::uint32_t entry = incidence.entries[place];
    return {entry / 4, weightsOf(constraints[entry / 4])[entry % 4]};
}

/// Ascending: the places of `vertices` in the lists of an incidence.
std::vector<std::uint32_t> placesOf(const Incidence& incidence,
                                    const std::vector<std::uint32_t>& vertices);

/// Ascending: the places with entries that a change of the lists of `vertices` touched.
template <class Gather, class Constraint>
std::vector<std::uint32_t> changedPlaces(Gather, const std::vector<Constraint>&,
                                         const Incidence& incidence,
                                         const std::vector<std::uint32_t>& vertices) {
    return placesOf(incidence, vertices);
}
/// A spoke stores the number of spokes at its far end.
std::vector<std::uint32_t> changedPlaces(Spokes, const std::vector<EdgeConstraint>& edges,
                                         const Incidence& incidence,
                                         std::vector<std::uint32_t> vertices);

}  // namespace kerf
