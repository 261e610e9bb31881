#include "render/passes/rim_pass.h"

#include <glad/gl.h>

#include <algorithm>

#include "render/passes/surface_pass.h"
#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

constexpr float kRimStrength = 0.82F;
constexpr float kWidthShare = 1.0F / 520;  // of the picture's height
constexpr float kLeastWidth = 1.2F;        // [px]

gpu::Program program(const gpu::Defines& defines) {
    return gpu::Program::graphics("render/rim_line.vert", "render/rim_line.frag", defines);
}

}  // namespace

RimPass::RimPass() : whole_(program({})) {}

const gpu::Program& RimPass::openedOne() {
    if (!opened_) {
        opened_.emplace(program({{"SECTION", "1"}}));
    }
    return *opened_;
}

void RimPass::draw(const SceneView& scene, const Frame& frame, const NormalsPass& shape) {
    const gpu::Program& lines = scene.section ? openedOne() : whole_;
    scene.body.positions->bindStorage(shared::kBindPositions);
    scene.body.triangles->bindStorage(shared::kBindTriangles);
    shape.normals().bindStorage(shared::kBindNormals);
    shape.skinCorners().bindStorage(shared::kBindSkinCorners);
    lines.use();
    bindLooks(lines, frame);
    lines.set("viewProjection", frame.viewProjection);
    lines.set("viewport", Eigen::Vector2f(float(frame.width), float(frame.height)));
    lines.set("width", std::max(kLeastWidth, kWidthShare * float(frame.height)));
    lines.set("strength", kRimStrength);
    lines.set("triangleCount", scene.body.triangleCount);
    lines.set("sidePieces", shape.sidePieces());
    if (scene.section) {
        setSection(lines, scene);
        glEnable(GL_CLIP_DISTANCE0);
    }
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    glBlendEquation(GL_MIN);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, shape.skinCorners().id());
    gpu::beforeDrawingIndirect();
    glDrawArraysIndirect(GL_TRIANGLES, nullptr);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_CLIP_DISTANCE0);
}

}  // namespace kerf::render
