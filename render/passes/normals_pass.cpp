#include "render/passes/normals_pass.h"

#include "shaders/shared/render_bindings.h"

namespace kerf::render {

NormalsPass::NormalsPass() : program_(gpu::Program::compute("render/normals.comp")) {}

void NormalsPass::run(const BodyView& body) {
    normals_.resize(std::size_t(2) * body.vertexCount * sizeof(shared::vec4));
    body.positions->bindStorage(shared::kBindPositions);
    body.restPositions->bindStorage(shared::kBindRestPositions);
    body.cutSkinNormals->bindStorage(shared::kBindCutSkinNormals);
    body.triangles->bindStorage(shared::kBindTriangles);
    body.incidenceRanges->bindStorage(shared::kBindIncidenceRanges);
    body.incidence->bindStorage(shared::kBindIncidence);
    normals_.bindStorage(shared::kBindNormals);
    program_.use();
    program_.set("vertexCount", body.vertexCount);
    program_.dispatch(body.vertexCount, shared::kNormalsGroupSize);
    gpu::storageBarrier();
}

}  // namespace kerf::render
