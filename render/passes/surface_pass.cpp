#include "render/passes/surface_pass.h"

#include <glad/gl.h>

#include <algorithm>

#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

// Of the line on the skin along a cut, on either side of it.
constexpr float kCutLineStrength = 0.75F;
constexpr float kCutLineShare = 1.0F / 800;  // of the picture's height, a pixel at least

gpu::Program program(gpu::Defines defines, const gpu::Defines& own) {
    defines.insert(defines.end(), own.begin(), own.end());
    return gpu::Program::graphics("render/surface.vert", "render/surface.frag", defines);
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

SurfacePass::Programs::Programs(const gpu::Defines& defines)
    : skins{program(defines, {}), program(defines, {{"SPOTS", "1"}})},
      walls{program(defines, {{"WALLS", "1"}, {"PATTERN", "0"}}),
            program(defines, {{"WALLS", "1"}, {"PATTERN", "1"}}),
            program(defines, {{"WALLS", "1"}, {"PATTERN", "2"}})} {}

SurfacePass::SurfacePass(const gpu::Defines& defines) : defines_(defines), whole_(defines) {}

const SurfacePass::Programs& SurfacePass::programsFor(const SceneView& scene) {
    if (!scene.section) {
        return whole_;
    }
    if (!opened_) {
        gpu::Defines defines = defines_;
        defines.emplace_back("SECTION", "1");
        opened_.emplace(defines);
    }
    return *opened_;
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

void SurfacePass::draw(const SceneView& scene, const Frame& frame, const gpu::Buffer& normals) {
    const Programs& programs = programsFor(scene);
    depth_.bind(shared::kUnitDepthField);
    bindBody(scene.body, normals);
    const gpu::Program& skin = programs.skins[scene.look.spots > 0 ? 1 : 0];
    skin.use();
    setCutLines(skin, scene, frame);
    drawKind(skin, scene, frame);
    if (scene.hasWalls) {
        drawKind(programs.walls[static_cast<std::size_t>(scene.look.pattern)], scene, frame);
    }
}

void SurfacePass::drawKind(const gpu::Program& program, const SceneView& scene,
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
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(3 * scene.body.triangleCount));
}

}  // namespace kerf::render
