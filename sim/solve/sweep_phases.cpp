#include "sim/solve/sweep_phases.h"

#include <string>
#include <utility>

#include "shaders/shared/bindings.h"

namespace kerf {

namespace {

using gpu::Defines;
using gpu::TexelFormat;
using shared::uint;

/// What kernels call the types of constraints and the lists of their vertices.
const std::array<Defines, kConstraintTypes> kNames{{
#define KERF_NAMES(number, Name, list, Constraint, Gather) \
    {{"TYPE", #number},                                    \
     {"FETCH", "fetch" #Name},                             \
     {"SOLVE", "solve" #Name},                             \
     {"SUM", "sumOf" #Gather},                             \
     {"RANGES", "RANGES_OF_" #Gather},                     \
     {"ENTRIES", "ENTRIES_OF_" #Gather}},
    KERF_CONSTRAINTS(KERF_NAMES)
#undef KERF_NAMES
}};

/// A kernel for each type but edges.
std::array<gpu::Program, kConstraintTypes> compileForEach(const SolverBody& body,
                                                          const std::string& name) {
    std::array<gpu::Program, kConstraintTypes> kernels;
    for (uint type = 1; type < kConstraintTypes; ++type) {
        kernels[type] = body.compile(name, kNames[type]);
    }
    return kernels;
}

}  // namespace

SweepPhases::SweepPhases(SolverBody& body)
    : body_(body),
      stretch_(body.compile("stretch")),
      stretchAgain_(body.compile("stretch", {{"SWEEP_AGAIN", "1"}})),
      solve_(compileForEach(body, "constraint")),
      gather_(compileForEach(body, "gather_corrections")),
      pull_(gpu::Program::compute("sim/pull.comp")),
      floor_(body.compile("floor")),
      finish_(body.compile("finish")) {}

void SweepPhases::predictAndStretch() {
    body_.bind();
    bindLists(shared::kStretch);
    body_.run(stretch_, body_.uniforms.vertex_count);
}

void SweepPhases::stretchAgain() {
    std::swap(body_.state.displacement, body_.state.previous);
    body_.bind();
    body_.bindFetched(body_.state.previous, shared::kPreviousBinding, TexelFormat::float32x4);
    bindLists(shared::kStretch);
    body_.run(stretchAgain_, body_.uniforms.vertex_count);
}

void SweepPhases::bindLists(uint type) const {
    const ConstraintBuffers& buffers = body_.model.constraints[type];
    body_.bindFetched(buffers.ranges, shared::kRangesBinding, buffers.rangeTexels);
    body_.bindFetched(buffers.entries, shared::kEntriesBinding, buffers.entryTexels);
}

void SweepPhases::solve(uint type) {
    if (!body_.active(1u << type)) {
        return;
    }
    body_.bind();
    body_.bindFetched(body_.model.constraints[type].records, shared::kConstraintsBinding,
                      TexelFormat::uint32x4);
    const gpu::Buffer& corrections = body_.state.corrections;
    corrections.bindStorage(shared::kCorrectionsBinding);
    body_.bindFetched(corrections, shared::kCorrectionsBinding, TexelFormat::float32x4);
    body_.run(solve_[type], body_.uniforms.count[type]);
    bindLists(type);
    body_.run(gather_[type], body_.uniforms.vertex_count);
}

void SweepPhases::pull() {
    if (body_.uniforms.pull_count > 0) {
        body_.bind();
        body_.pulls.bindStorage(shared::kPullsBinding);
        body_.run(pull_, body_.uniforms.pull_count);
    }
}

void SweepPhases::collideFloor() {
    if (body_.active(shared::kFloorPart)) {
        body_.bind();
        body_.run(floor_, body_.uniforms.vertex_count);
    }
}

void SweepPhases::finish() {
    body_.bind();
    body_.run(finish_, body_.uniforms.vertex_count);
}

}  // namespace kerf
