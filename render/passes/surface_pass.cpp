#include "render/passes/surface_pass.h"

#include <glad/gl.h>

#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

constexpr int kDepthResolution = 56;

void bindBody(const BodyView& body, const gpu::Buffer& normals) {
    body.positions->bindStorage(shared::kBindPositions);
    body.restPositions->bindStorage(shared::kBindRestPositions);
    body.triangles->bindStorage(shared::kBindTriangles);
    normals.bindStorage(shared::kBindNormals);
}

}  // namespace

SurfacePass::SurfacePass(const gpu::Defines& defines)
    : program_(gpu::Program::graphics("render/surface.vert", "render/surface.frag", defines)) {}

void SurfacePass::setRestShape(const SurfaceMesh& uncut) {
    depth_ = uncut.aliveTriangles() > 0 ? DepthTexture(measureDepth(uncut, kDepthResolution))
                                        : DepthTexture();
}

void SurfacePass::setMaterial(const SceneView& scene) const {
    const Material& material = scene.material;
    const Bounds& bounds = scene.restBounds.empty() ? scene.focus : scene.restBounds;
    const Vec3 extent = 0.5 * (bounds.high - bounds.low);
    program_.set("skinColor", material.skin);
    program_.set("innerColor", material.inner);
    program_.set("rindColor", material.rind);
    program_.set("pattern", static_cast<int>(material.pattern));
    program_.set("mottle", material.mottle);
    program_.set("spots", material.spots);
    program_.set("facets", material.facets);
    program_.set("restCenter", Vec3f(bounds.center().cast<float>()));
    program_.set("restExtent", Vec3f(extent.cwiseMax(1e-6).cast<float>()));
    program_.set("hasDepthField", depth_.empty() ? 0.0f : 1.0f);
    program_.set("fieldOrigin", depth_.origin());
    program_.set("fieldScale", depth_.scale());
}

void SurfacePass::draw(const SceneView& scene, const Frame& frame,
                       const gpu::Buffer& normals) const {
    program_.use();
    setLight(program_, frame);
    setMaterial(scene);
    program_.set("viewProjection", frame.viewProjection);
    program_.set("eye", frame.eye);
    program_.set("bodySize", frame.bodySize);
    program_.set("hasFloor", scene.floor ? 1.0f : 0.0f);
    program_.set("floorHeight", float(scene.floor.value_or(0)));
    program_.set("wireframe", scene.wireframe ? 1.0f : 0.0f);
    depth_.bind(shared::kUnitDepthField);
    bindBody(scene.body, normals);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(3 * scene.body.triangleCount));
}

}  // namespace kerf::render
