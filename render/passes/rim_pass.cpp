#include "render/passes/rim_pass.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>

#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

constexpr float kStrength = 0.82F;
constexpr float kWidthShare = 1.0F / 520;  // of the picture's height
constexpr float kLeastWidth = 1.2F;        // [px]

}  // namespace

RimPass::RimPass()
    : program_(gpu::Program::graphics("render/rim_line.vert", "render/rim_line.frag")) {}

void RimPass::draw(const SceneView& scene, const Frame& frame, const NormalsPass& shape) const {
    scene.body.positions->bindStorage(shared::kBindPositions);
    scene.body.triangles->bindStorage(shared::kBindTriangles);
    shape.normals().bindStorage(shared::kBindNormals);
    shape.rims().bindStorage(shared::kBindRims);
    program_.use();
    bindLooks(program_, frame);
    program_.set("viewProjection", frame.viewProjection);
    program_.set("viewport", Eigen::Vector2f(float(frame.width), float(frame.height)));
    program_.set("width", std::max(kLeastWidth, kWidthShare * float(frame.height)));
    program_.set("strength", kStrength);
    program_.set("sidePieces", shape.sidePieces());
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    glBlendEquation(GL_MIN);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, shape.rims().id());
    glDrawArraysIndirect(GL_TRIANGLES, nullptr);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
}

}  // namespace kerf::render
