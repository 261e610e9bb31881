#include "render/passes/surface_pass.h"

#include <glad/gl.h>

#include <string>

#include "render/scene/environment.h"
#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

void bindBody(const BodyView& body, const NormalsPass& shape) {
    body.positions->bindStorage(shared::kBindPositions);
    body.restPositions->bindStorage(shared::kBindRestPositions);
    body.triangles->bindStorage(shared::kBindTriangles);
    shape.normals().bindStorage(shared::kBindNormals);
    shape.cornerNormals().bindStorage(shared::kBindCornerNormals);
}

void setFinish(const gpu::Program& program, const Finish& finish) {
    program.set("roughness", finish.roughness);
    program.set("gloss", finish.gloss);
    program.set("glow", finish.glow);
    program.set("mirrorLevel", environmentLevel(finish.roughness));
}

}  // namespace

void SurfacePass::setDepth(const DepthField& depth) {
    depth_ = depth.values.empty() ? DepthTexture() : DepthTexture(depth);
}

const gpu::Program& SurfacePass::programOf(const Kind& kind) {
    const auto found = programs_.find(kind);
    if (found != programs_.end()) {
        return found->second;
    }
    gpu::Defines defines = defines_;
    const bool isWall = kind.surface == SurfaceKind::wall;
    defines.emplace_back(isWall ? "PATTERN" : "SKIN", std::to_string(kind.pattern));
    if (isWall) {
        defines.emplace_back("WALLS", "1");
    }
    if (kind.rounded) {
        defines.emplace_back("ROUNDED", "1");
    }
    if (kind.shading != Shading::lit) {
        defines.emplace_back("MATCAP", std::to_string(static_cast<int>(kind.shading)));
    }
    return programs_
        .emplace(kind,
                 gpu::Program::graphics("render/surface.vert", "render/surface.frag", defines))
        .first->second;
}

void SurfacePass::setLook(const gpu::Program& program, const SceneView& scene) const {
    const BodyLook& look = scene.look;
    const Bounds& bounds = scene.restBounds.empty() ? scene.focus : scene.restBounds;
    const Vec3 extent = 0.5 * (bounds.high - bounds.low);
    program.set("skinColor", look.skin);
    program.set("innerColor", look.inner);
    program.set("rindColor", look.rind);
    program.set("rindShare", look.rindShare);
    program.set("mottle", look.mottle);
    program.set("spots", look.spots);
    program.set("restCenter", Vec3f(bounds.center().cast<float>()));
    program.set("restExtent", Vec3f(extent.cwiseMax(1e-6).cast<float>()));
    program.set("hasDepthField", depth_.empty() ? 0.0f : 1.0f);
    program.set("fieldOrigin", depth_.origin());
    program.set("fieldScale", depth_.scale());
}

void SurfacePass::draw(const SceneView& scene, const Frame& frame, const NormalsPass& shape) {
    depth_.bind(shared::kUnitDepthField);
    bindBody(scene.body, shape);
    const BodyLook& look = scene.look;
    const bool rounded = shape.sidePieces() > 1;
    drawKind({SurfaceKind::skin, static_cast<int>(look.skinPattern), look.shading, rounded}, scene,
             frame, shape.sidePieces());
    if (scene.hasWalls) {
        drawKind({SurfaceKind::wall, static_cast<int>(look.pattern), look.shading, rounded}, scene,
                 frame, shape.sidePieces());
    }
}

void SurfacePass::drawKind(const Kind& kind, const SceneView& scene, const Frame& frame,
                           int sidePieces) {
    const gpu::Program& program = programOf(kind);
    program.use();
    setLight(program, frame);
    setLook(program, scene);
    setFinish(program,
              kind.surface == SurfaceKind::wall ? scene.look.cutFinish : scene.look.skinFinish);
    bindLooks(program, frame);
    program.set("viewProjection", frame.viewProjection);
    program.set("eye", frame.eye);
    program.set("bodySize", frame.bodySize);
    program.set("hasFloor", scene.floor ? 1.0f : 0.0f);
    program.set("floorHeight", float(scene.floor.value_or(0)));
    program.set("wireframe", scene.wireframe ? 1.0f : 0.0f);
    program.set("sidePieces", sidePieces);
    for (std::size_t i = 0; i < frame.mattLight.size(); ++i) {
        program.set("mattLight[" + std::to_string(i) + "]", frame.mattLight[i]);
    }
    glDrawArrays(GL_TRIANGLES, 0,
                 GLsizei(3 * sidePieces * sidePieces * int(scene.body.triangleCount)));
}

}  // namespace kerf::render
