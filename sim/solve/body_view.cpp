#include "sim/solve/body_view.h"

namespace kerf {

ContactBody contactBodyOf(const SolverBody& body) {
    const SolverModel& model = body.model;
    const ConstraintBuffers& columns = model.constraints[shared::kIspc];
    return {.positions = &body.state.positions,
            .velocities = &body.state.velocities,
            .displacement = &body.state.displacement,
            .restPositions = &model.restPositions,
            .links = &model.links,
            .pieces = &body.pieces.pieceBuffer,
            .triangles = &model.triangles,
            .incidenceRanges = &model.triangleIncidence.ranges,
            .incidence = &model.triangleIncidence.entries,
            .columns = &columns.records,
            .columnRanges = &columns.ranges,
            .columnShares = &columns.entries,
            .vertexCount = body.uniforms.vertex_count,
            .triangleCount = body.uniforms.triangle_count,
            .pieceCount = static_cast<std::uint32_t>(body.pieces.pieces().size())};
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
