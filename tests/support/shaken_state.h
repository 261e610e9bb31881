#pragma once

#include "tests/support/reference/reference_solver.h"

namespace kerf::test {

/// A body out of shape, in the middle of a substep: every coordinate of the positions is off by up
/// to `offset`, every one of the displacements is up to `displacement` [m].
ReferenceState shakenState(const BodyModel& model, unsigned seed, double offset,
                           double displacement);

}  // namespace kerf::test
