#include "render/passes/section_pass.h"

#include <glad/gl.h>

#include <Eigen/Geometry>

#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

constexpr double kMargin = 1.05;     // of the square that is filled, beyond the body
constexpr double kFlattest = 1e-4;   // side of a body's box, of its diagonal
constexpr double kLeastSide = 1e-9;  // [m]

gpu::Program filling(const gpu::Defines& defines) {
    return gpu::Program::graphics("render/section.vert", "render/section.frag", defines);
}

void beginCounting() {
    glEnable(GL_STENCIL_TEST);
    glEnable(GL_CLIP_DISTANCE0);
    glEnable(GL_DEPTH_CLAMP);  // what lies before or behind the picture counts too
    glDisable(GL_DEPTH_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glStencilMask(0xff);
    glStencilFunc(GL_ALWAYS, 0, 0xff);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
}

void endCounting() {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_CLIP_DISTANCE0);
    glStencilFunc(GL_NOTEQUAL, 0, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

Vec3f floats(const Vec3& v) {
    return v.cast<float>();
}

/// A square of the plane that holds all of the section.
void setSquare(const gpu::Program& program, const SceneView& scene) {
    const SectionPlane& plane = *scene.section;
    const Vec3 center = scene.focus.center();
    const double half = kMargin * 0.5 * scene.focus.diagonal();
    const Vec3 along = plane.normal.unitOrthogonal();
    program.set("sectionMiddle", floats(center - plane.distance(center) * plane.normal));
    program.set("sectionAlong", floats(half * along));
    program.set("sectionAcross", floats(half * plane.normal.cross(along)));
    program.set("sectionNormal", floats(plane.normal));
}

/// What maps the body as it is onto its rest shape, roughly: box onto box.
void setBody(const gpu::Program& program, const SceneView& scene) {
    const double least = std::max(kFlattest * scene.focus.diagonal(), kLeastSide);
    const Vec3 extent = (0.5 * (scene.focus.high - scene.focus.low)).cwiseMax(least);
    program.set("bodyCenter", floats(scene.focus.center()));
    program.set("bodyExtent", floats(extent));
    program.set("wholeBody", scene.hasWalls ? 0.0F : 1.0F);
}

}  // namespace

SectionPass::SectionPass()
    : count_(gpu::Program::graphics("render/shadow.vert", "render/depth_only.frag",
                                    {{"SECTION", "1"}})),
      plain_(filling({{"PLAIN", "1"}})) {}

void SectionPass::draw(const SceneView& scene, const Frame& frame, const Camera& camera,
                       const SurfacePass& surface) {
    const SectionPlane& plane = *scene.section;
    if (plane.normal.dot(camera.towardsEye(plane.point)) <= 0) {
        return;  // seen from behind, where the body hides it
    }
    count(scene, frame);
    fill(scene, frame, surface);
    glDisable(GL_STENCIL_TEST);
}

void SectionPass::count(const SceneView& scene, const Frame& frame) const {
    beginCounting();
    scene.body.positions->bindStorage(shared::kBindPositions);
    scene.body.triangles->bindStorage(shared::kBindTriangles);
    count_.use();
    count_.set("lightMatrix", frame.viewProjection);
    bindLooks(count_, frame);
    setSection(count_, scene);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(3 * scene.body.triangleCount));
    endCounting();
}

const gpu::Program& SectionPass::fillingOf(FleshPattern pattern) {
    auto found = flesh_.find(pattern);
    if (found == flesh_.end()) {
        const std::string number = std::to_string(static_cast<int>(pattern));
        found = flesh_.emplace(pattern, filling({{"PATTERN", number}})).first;
    }
    return found->second;
}

void SectionPass::linkEvery() {
    for (std::size_t pattern = 0; pattern < kFleshPatterns; ++pattern) {
        fillingOf(static_cast<FleshPattern>(pattern));
    }
}

void SectionPass::fill(const SceneView& scene, const Frame& frame, const SurfacePass& surface) {
    const bool plain = scene.field.choice.field != SurfaceField::look;
    const gpu::Program& program = plain ? plain_ : fillingOf(scene.look.pattern);
    program.use();
    setLight(program, frame);
    surface.setLook(program, scene);
    setSquare(program, scene);
    setBody(program, scene);
    program.set("viewProjection", frame.viewProjection);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace kerf::render
