#include "sim/solve/solver_views.h"

namespace kerf {

ContactBody contactBodyOf(const SolverBody& body) {
    const SolverModel& model = body.model;
    return {.positions = &body.state.positions,
            .velocities = &body.state.velocities,
            .displacement = &body.state.displacement,
            .restPositions = &model.restPositions,
            .links = &model.links,
            .pieces = &body.pieces.pieceBuffer,
            .triangles = &model.triangles,
            .incidenceRanges = &model.triangleIncidence.ranges,
            .incidence = &model.triangleIncidence.entries,
            .vertexCount = body.uniforms.vertex_count,
            .triangleCount = body.uniforms.triangle_count};
}

SmallBodyBuffers smallBodyBuffersOf(const SolverBody& body) {
    const SolverModel& model = body.model;
    const SolverState& state = body.state;
    const SolverPieces& pieces = body.pieces;
    return {.uniforms = &body.uniformBuffer,
            .positions = &state.positions,
            .velocities = &state.velocities,
            .displacement = &state.displacement,
            .swept = &state.previous,
            .links = &model.links,
            .constraints = model.constraints,
            .neighbourRanges = &model.neighbours.ranges,
            .neighbours = &model.neighbours.entries,
            .places = &pieces.placeBuffer,
            .corrections = &state.corrections,
            .gradients = &state.gradients,
            .impulses = &pieces.impulses,
            .pieces = &pieces.pieceBuffer,
            .blocks = &pieces.blockBuffer,
            .pages = &pieces.pageBuffer,
            .pulls = &body.pulls};
}

UnfoldingBody unfoldingBodyOf(const SolverBody& body) {
    return {.uniforms = &body.uniformBuffer,
            .positions = &body.state.positions,
            .velocities = &body.state.velocities,
            .restPositions = &body.model.restPositions,
            .bends = &body.model.constraints[shared::kBend].records,
            .neighbourRanges = &body.model.neighbours.ranges,
            .neighbours = &body.model.neighbours.entries,
            .vertexCount = body.uniforms.vertex_count,
            .bendCount = body.uniforms.count[shared::kBend]};
}

BodyView bodyViewOf(const SolverBody& body) {
    const SolverModel& model = body.model;
    return {.positions = &body.state.positions,
            .restPositions = &model.restPositions,
            .cutSkinNormals = &model.cutSkinNormals,
            .triangles = &model.triangles,
            .incidenceRanges = &model.triangleIncidence.ranges,
            .incidence = &model.triangleIncidence.entries,
            .vertexCount = body.uniforms.vertex_count,
            .triangleCount = body.uniforms.triangle_count};
}

ConstraintView constraintViewOf(const SolverBody& body, const ContactSolver& contacts) {
    ConstraintView view;
    view.bends = &body.model.constraints[shared::kBend].records;
    view.ispcs = &body.model.constraints[shared::kIspc].records;
    view.pulls = &body.pulls;
    view.bendCount = body.uniforms.count[shared::kBend];
    view.ispcCount = body.uniforms.count[shared::kIspc];
    view.pullCount = body.uniforms.pull_count;
    if (contacts.enabled() && contacts.records().size() > 0) {
        view.contacts = &contacts.records();
        view.contactState = &contacts.state();
        view.mostContacts = body.uniforms.vertex_count;
    }
    return view;
}

}  // namespace kerf
