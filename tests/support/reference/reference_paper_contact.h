#pragma once

#include "shaders/shared/contact_records.h"
#include "sim/body/body_model.h"

namespace kerf {

/// Computes what PaperContact does, in double precision, with the paper's octree instead of the
/// grid, pair by pair: the reference for tests of the kernels. All vertices are free. `uniforms`:
/// see paperContactUniforms(). Returns how many pairs of triangles meet.
int respondAsThePaper(const BodyModel& model, const shared::ContactUniforms& uniforms,
                      BodyState& state);

}  // namespace kerf
