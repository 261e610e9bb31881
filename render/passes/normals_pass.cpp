#include "render/passes/normals_pass.h"

#include "shaders/shared/render_bindings.h"

namespace kerf::render {

NormalsPass::NormalsPass(const Roundness& roundness)
    : program_(gpu::Program::compute("render/normals.comp")), roundness_(roundness) {}

int NormalsPass::sidePiecesOf(std::uint32_t triangles) const {
    const double pieces = std::sqrt(roundness_.shownTriangles / std::max(triangles, 1U));
    return std::clamp(static_cast<int>(pieces), 1, roundness_.mostSidePieces);
}

void NormalsPass::run(const BodyView& body, double hardEdges, bool flat) {
    normals_.resize(std::size_t(2) * body.vertexCount * sizeof(shared::vec4));
    // Each vertex of a rim begins an edge of it, some begin two.
    const std::size_t words =
        std::size_t(3) * body.triangleCount + std::size_t(2) * body.vertexCount;
    skinCorners_.resize(sizeof(shared::vec4) + words * sizeof(std::uint32_t));
    sidePieces_ = flat ? 1 : sidePiecesOf(body.triangleCount);
    const std::array<std::uint32_t, 4> noRims{6 * static_cast<std::uint32_t>(sidePieces_), 0, 0, 0};
    skinCorners_.write<std::uint32_t>(0, noRims);
    body.positions->bindStorage(shared::kBindPositions);
    body.restPositions->bindStorage(shared::kBindRestPositions);
    body.cutSkinNormals->bindStorage(shared::kBindCutSkinNormals);
    body.triangles->bindStorage(shared::kBindTriangles);
    body.incidenceRanges->bindStorage(shared::kBindIncidenceRanges);
    body.incidence->bindStorage(shared::kBindIncidence);
    normals_.bindStorage(shared::kBindNormals);
    skinCorners_.bindStorage(shared::kBindSkinCorners);
    program_.use();
    program_.set("vertexCount", body.vertexCount);
    program_.set("triangleCount", body.triangleCount);
    const double angle = std::clamp(hardEdges, 0.0, 180.0) * std::numbers::pi / 180;
    program_.set("hardCosine", float(std::cos(angle)));
    program_.set("hardHalfCosine", float(std::cos(angle / 2)));
    program_.dispatch(body.vertexCount);
}

}  // namespace kerf::render
