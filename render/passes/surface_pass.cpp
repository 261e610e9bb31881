#include "render/passes/surface_pass.h"

#include <glad/gl.h>

#include <string>
#include <utility>

#include "render/scene/environment.h"
#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

void drawTriangles(std::uint32_t first, std::uint32_t count) {
    glDrawArrays(GL_TRIANGLES, GLint(3 * first), GLsizei(3 * count));
}

/// All triangles, divided as they are shown.
void drawBody(const gpu::Program& program, const BodyView& body, const NormalsPass& shape) {
    const auto side = static_cast<std::uint32_t>(shape.sidePieces());
    program.set("sidePieces", shape.sidePieces());
    drawTriangles(0, side * side * body.triangleCount);
}

void setFinish(const gpu::Program& program, const Finish& finish) {
    program.set("roughness", finish.roughness);
    program.set("gloss", finish.gloss);
    program.set("glow", finish.glow);
    const MirrorLevel mirror = mirrorLevel(finish.roughness);
    program.set("mirrorLevel", float(mirror.level));
    program.set("mirrorReach", mirror.reach);
}

}  // namespace

void bindBody(const BodyView& body, const NormalsPass& shape) {
    body.positions->bindStorage(shared::kBindPositions);
    body.restPositions->bindStorage(shared::kBindRestPositions);
    body.triangles->bindStorage(shared::kBindTriangles);
    shape.normals().bindStorage(shared::kBindNormals);
    shape.skinCorners().bindStorage(shared::kBindSkinCorners);
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
    program.set("rindShare", look.rindShare);
    program.set("mottle", look.mottle);
    program.set("spots", look.spots);
    program.set("restCenter", Vec3f(bounds.center().cast<float>()));
    program.set("restExtent", Vec3f(extent.cwiseMax(1e-9).cast<float>()));
    program.set("hasDepthField", depth_.empty() ? 0.0f : 1.0f);
    program.set("fieldOrigin", depth_.origin());
    program.set("fieldScale", depth_.scale());
}

SurfacePass::Kind SurfacePass::kindOf(const SceneView& scene, const NormalsPass& shape, bool wall) {
    const BodyLook& look = scene.look;
    const bool painted = !wall && scene.paint != nullptr;
    const int skin = painted ? 0 : static_cast<int>(look.skinPattern);
    return {.wall = wall,
            .pattern = wall ? static_cast<int>(look.pattern) : skin,
            .shading = look.shading,
            .rounded = shape.sidePieces() > 1,
            .opened = scene.section.has_value(),
            .painted = painted};
}

gpu::Defines SurfacePass::definesOf(const Kind& kind) const {
    gpu::Defines defines = defines_;
    const auto add = [&](bool wanted, const char* name, const std::string& value) {
        if (wanted) {
            defines.emplace_back(name, value);
        }
    };
    add(kind.wall, "WALLS", "1");
    add(true, kind.wall ? "PATTERN" : "SKIN", std::to_string(kind.pattern));
    add(kind.rounded, "ROUNDED", "1");
    add(kind.shading != Shading::lit, "MATCAP", std::to_string(static_cast<int>(kind.shading)));
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

void SurfacePass::linkEvery() {
    constexpr std::array kShadings{Shading::lit, Shading::matcapClay, Shading::matcapSteel,
                                   Shading::normals};
    for (int choice = 0; choice < 8; ++choice) {
        const bool wall = (choice & 1) != 0;
        const std::size_t patterns = wall ? kFleshPatterns : kSkinPatterns;
        for (const Shading shading : kShadings) {
            Kind kind{.wall = wall,
                      .shading = shading,
                      .rounded = (choice & 2) != 0,
                      .opened = (choice & 4) != 0};
            for (std::size_t pattern = 0; pattern < patterns; ++pattern) {
                kind.pattern = static_cast<int>(pattern);
                programOf(kind);
            }
            if (!wall) {
                kind.pattern = 0;
                kind.painted = true;
                programOf(kind);
            }
        }
    }
}

void SurfacePass::draw(const SceneView& scene, const Frame& frame, const NormalsPass& shape) {
    depth_.bind(shared::kUnitDepthField);
    bindBody(scene.body, shape);
    drawSkin(scene, frame, shape);
    const gpu::Program& walls = programOf(kindOf(scene, shape, true));  // before a cut waits for it
    if (scene.hasWalls) {
        prepare(walls, scene, frame);
        setFinish(walls, scene.look.cutFinish);
        drawBody(walls, scene.body, shape);
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

void SurfacePass::drawSkin(const SceneView& scene, const Frame& frame, const NormalsPass& shape) {
    const gpu::Program& skin = programOf(kindOf(scene, shape, false));
    prepare(skin, scene, frame);
    setFinish(skin, scene.look.skinFinish);
    if (scene.paint == nullptr) {
        drawBody(skin, scene.body, shape);
        return;
    }
    upload(scene.paint);
    drawPainted(skin);
}

void SurfacePass::drawPainted(const gpu::Program& skin) {
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
    for (std::size_t i = 0; i < frame.mattLight.size(); ++i) {
        program.set("mattLight[" + std::to_string(i) + "]", frame.mattLight[i]);
    }
}

}  // namespace kerf::render
