#include "render/passes/surface_pass.h"

#include <glad/gl.h>

#include <algorithm>

#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

// Of the line on the skin along a cut, on either side of it.
constexpr float kCutLineStrength = 0.75F;
constexpr float kCutLineShare = 1.0F / 800;  // of the picture's height, a pixel at least

void bindBody(const BodyView& body, const gpu::Buffer& normals) {
    body.positions->bindStorage(shared::kBindPositions);
    body.restPositions->bindStorage(shared::kBindRestPositions);
    body.triangles->bindStorage(shared::kBindTriangles);
    normals.bindStorage(shared::kBindNormals);
}

void drawTriangles(std::uint32_t first, std::uint32_t count) {
    glDrawArrays(GL_TRIANGLES, GLint(3 * first), GLsizei(3 * count));
}

gpu::Program program(gpu::Defines defines, const gpu::Defines& own) {
    defines.insert(defines.end(), own.begin(), own.end());
    return gpu::Program::graphics("render/surface.vert", "render/surface.frag", defines);
}

}  // namespace

SurfacePass::SurfacePass(const gpu::Defines& defines)
    : defines_(defines),
      skins_{program(defines, {}), program(defines, {{"SPOTS", "1"}})},
      walls_{program(defines, {{"WALLS", "1"}, {"PATTERN", "0"}}),
             program(defines, {{"WALLS", "1"}, {"PATTERN", "1"}}),
             program(defines, {{"WALLS", "1"}, {"PATTERN", "2"}})} {}

void SurfacePass::setDepth(const DepthField& depth) {
    depth_ = depth.values.empty() ? DepthTexture() : DepthTexture(depth);
}

void SurfacePass::setLook(const gpu::Program& program, const SceneView& scene) const {
    const BodyLook& look = scene.look;
    const Bounds& bounds = scene.restBounds.empty() ? scene.focus : scene.restBounds;
    const Vec3 extent = 0.5 * (bounds.high - bounds.low);
    program.set("skinColor", look.skin);
    program.set("innerColor", look.inner);
    program.set("rindColor", look.rind);
    program.set("mottle", look.mottle);
    program.set("spots", look.spots);
    program.set("facets", look.facets);
    program.set("restCenter", Vec3f(bounds.center().cast<float>()));
    program.set("restExtent", Vec3f(extent.cwiseMax(1e-6).cast<float>()));
    program.set("hasDepthField", depth_.empty() ? 0.0f : 1.0f);
    program.set("fieldOrigin", depth_.origin());
    program.set("fieldScale", depth_.scale());
}

void SurfacePass::draw(const SceneView& scene, const Frame& frame, const gpu::Buffer& normals) {
    depth_.bind(shared::kUnitDepthField);
    bindBody(scene.body, normals);
    drawSkin(scene, frame);
    if (scene.hasWalls) {
        prepare(walls_[static_cast<std::size_t>(scene.look.pattern)], scene, frame);
        drawTriangles(0, scene.body.triangleCount);
    }
}

/// Programs for models with colours are compiled once there is one.
const gpu::Program& SurfacePass::skinProgram(const SceneView& scene) {
    if (scene.paint == nullptr) {
        return skins_[scene.look.spots > 0 ? 1 : 0];
    }
    if (!painted_) {
        painted_.emplace(program(defines_, {{"OWN_COLOURS", "1"}}));
    }
    return *painted_;
}

void SurfacePass::upload(const std::shared_ptr<const SkinPaint>& paint) {
    if (paint == paint_) {
        return;
    }
    paintRecords_.assign(paint->records);
    if (!textures_.areOf(paint->appearance)) {
        textures_ = SkinTextures(paint->appearance);
    }
    paint_ = paint;
}

void SurfacePass::drawSkin(const SceneView& scene, const Frame& frame) {
    const gpu::Program& skin = skinProgram(scene);
    prepare(skin, scene, frame);
    skin.set("cutLines", scene.cutLines ? kCutLineStrength : 0.0f);
    skin.set("cutLineWidth", std::max(1.0f, kCutLineShare * float(frame.height)));
    if (scene.paint == nullptr) {
        drawTriangles(0, scene.body.triangleCount);
        return;
    }
    upload(scene.paint);
    paintRecords_.bindStorage(shared::kBindSkin);
    for (const SkinPaint::Range& range : paint_->ranges) {
        skin.set("hasSkinPicture", range.image >= 0 ? 1.0f : 0.0f);
        if (range.image >= 0) {
            textures_.bind(range.image, shared::kUnitSkin);
        }
        drawTriangles(range.first, range.count);
    }
}

void SurfacePass::prepare(const gpu::Program& program, const SceneView& scene,
                          const Frame& frame) const {
    program.use();
    setLight(program, frame);
    setLook(program, scene);
    bindLooks(program, frame);
    program.set("viewProjection", frame.viewProjection);
    program.set("eye", frame.eye);
    program.set("bodySize", frame.bodySize);
    program.set("hasFloor", scene.floor ? 1.0f : 0.0f);
    program.set("floorHeight", float(scene.floor.value_or(0)));
    program.set("wireframe", scene.wireframe ? 1.0f : 0.0f);
}

}  // namespace kerf::render
