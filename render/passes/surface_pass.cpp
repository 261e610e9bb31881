#include "render/passes/surface_pass.h"

#include <glad/gl.h>

#include <algorithm>
#include <string>
#include <utility>

#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

// Of the line on the skin along a cut, on either side of it.
constexpr float kCutLineStrength = 0.75F;
constexpr float kCutLineShare = 1.0F / 800;  // of the picture's height, a pixel at least

void drawTriangles(std::uint32_t first, std::uint32_t count) {
    glDrawArrays(GL_TRIANGLES, GLint(3 * first), GLsizei(3 * count));
}

}  // namespace

void bindBody(const BodyView& body, const gpu::Buffer& normals) {
    body.positions->bindStorage(shared::kBindPositions);
    body.restPositions->bindStorage(shared::kBindRestPositions);
    body.triangles->bindStorage(shared::kBindTriangles);
    normals.bindStorage(shared::kBindNormals);
}

void setCutLines(const gpu::Program& program, const SceneView& scene, const Frame& frame) {
    program.set("cutLines", scene.cutLines ? kCutLineStrength : 0.0f);
    program.set("cutLineWidth", std::max(1.0f, kCutLineShare * float(frame.height)));
}

void setSection(const gpu::Program& program, const SceneView& scene) {
    const SectionPlane& plane = *scene.section;
    const Vec3f n = plane.normal.cast<float>();
    const auto offset = float(-plane.normal.dot(plane.point));
    program.set("sectionPlane", Eigen::Vector4f(n.x(), n.y(), n.z(), offset));
}

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

SurfacePass::Kind SurfacePass::skinOf(const SceneView& scene) {
    const bool painted = scene.paint != nullptr;
    return {.pattern = scene.look.spots > 0 && !painted ? 1 : 0,
            .opened = scene.section.has_value(),
            .painted = painted};
}

SurfacePass::Kind SurfacePass::wallsOf(const SceneView& scene) {
    return {.wall = true,
            .pattern = static_cast<int>(scene.look.pattern),
            .opened = scene.section.has_value()};
}

gpu::Defines SurfacePass::definesOf(const Kind& kind) const {
    gpu::Defines defines = defines_;
    const auto add = [&](bool wanted, const char* name, const std::string& value) {
        if (wanted) {
            defines.emplace_back(name, value);
        }
    };
    add(kind.wall, "WALLS", "1");
    add(kind.wall, "PATTERN", std::to_string(kind.pattern));
    add(!kind.wall && kind.pattern == 1, "SPOTS", "1");
    add(kind.opened, "SECTION", "1");
    add(kind.painted, "OWN_COLOURS", "1");
    return defines;
}

const gpu::Program& SurfacePass::programOf(const Kind& kind) {
    auto found = programs_.find(kind);
    if (found == programs_.end()) {
        gpu::Program program =
            gpu::Program::graphics("render/surface.vert", "render/surface.frag", definesOf(kind));
        found = programs_.emplace(kind, std::move(program)).first;
    }
    return found->second;
}

void SurfacePass::draw(const SceneView& scene, const Frame& frame, const gpu::Buffer& normals) {
    depth_.bind(shared::kUnitDepthField);
    bindBody(scene.body, normals);
    drawSkin(scene, frame);
    const gpu::Program& walls = programOf(wallsOf(scene));  // before a cut waits for it
    if (scene.hasWalls) {
        prepare(walls, scene, frame);
        drawTriangles(0, scene.body.triangleCount);
    }
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
    const gpu::Program& skin = programOf(skinOf(scene));
    prepare(skin, scene, frame);
    setCutLines(skin, scene, frame);
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
    if (scene.section) {
        setSection(program, scene);
    }
    bindLooks(program, frame);
    program.set("viewProjection", frame.viewProjection);
    program.set("eye", frame.eye);
    program.set("bodySize", frame.bodySize);
    program.set("hasFloor", scene.floor ? 1.0f : 0.0f);
    program.set("floorHeight", float(scene.floor.value_or(0)));
    program.set("wireframe", scene.wireframe ? 1.0f : 0.0f);
}

}  // namespace kerf::render
