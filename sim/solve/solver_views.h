#pragma once

#include "sim/contact/contact_solver.h"
#include "sim/solve/body_view.h"
#include "sim/solve/solver_body.h"

namespace kerf {

// The buffers of a body on the GPU as those see them who work on it or draw it; valid while the
// body is neither uploaded nor updated.

ContactBody contactBodyOf(const SolverBody& body);
BodyView bodyViewOf(const SolverBody& body);
/// The constraints to draw, with `contacts` if they are on and were searched.
ConstraintView constraintViewOf(const SolverBody& body, const ContactSolver& contacts);

}  // namespace kerf
