#include "render/passes/surroundings_pass.h"

#include <glad/gl.h>

#include <Eigen/Geometry>

#include "shaders/shared/render_bindings.h"

namespace kerf::render {

namespace {

constexpr double kFadeReach = 9.0;   // of the larger of body and viewing distance
constexpr double kFadeBegin = 0.08;  // of the reach
constexpr float kPoolSize = 1.6F;    // of the body's size

bool isSeenFromBelow(double height, const Frame& frame) {
    return frame.eye.y() < float(height);
}

void setBackdrop(const gpu::Program& program, const Frame& frame) {
    const auto rayOf = [&](float x, float y) -> Vec3f {
        const Eigen::Vector4f ray = frame.pictureToWorld * Eigen::Vector4f(x, y, 1, 1);
        return ray.hnormalized();
    };
    const Vec3f corner = rayOf(-1, -1);
    program.set("bright", frame.bright ? 1.0f : 0.0f);
    program.set("rayCorner", corner);
    program.set("rayAcross", Vec3f(rayOf(1, -1) - corner));
    program.set("rayUp", Vec3f(rayOf(-1, 1) - corner));
}

/// Side of a small grid cell for a body of this size: 1 or 2 times a power of ten, about a twelfth
/// [m].
double gridCell(double bodySize) {
    const double wanted = bodySize / 12;
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    return wanted / power < 1.5 ? power : (wanted / power < 5 ? 2 * power : 10 * power);
}

using shared::uint;
using Corners = std::array<uint, 4>;  // of a triangle; the last word is unused

// Corner i of a box takes the high side along axis k where bit k of i is set. Two triangles a face,
// so that corner 0 of each is a right angle: box.vert relies on that.
constexpr std::array<Corners, 12> kTriangles{{{0, 4, 2, 0},
                                              {6, 2, 4, 0},
                                              {1, 3, 5, 0},
                                              {7, 5, 3, 0},
                                              {0, 1, 4, 0},
                                              {5, 4, 1, 0},
                                              {2, 6, 3, 0},
                                              {7, 3, 6, 0},
                                              {0, 2, 1, 0},
                                              {3, 1, 2, 0},
                                              {4, 5, 6, 0},
                                              {7, 6, 5, 0}}};

}  // namespace

FloorPass::FloorPass()
    : backdrop_(gpu::Program::graphics("render/fullscreen.vert", "render/background.frag")),
      floor_(gpu::Program::graphics("render/floor.vert", "render/floor.frag")) {}

void FloorPass::draw(std::optional<double> height, const Frame& frame, const Camera& camera) const {
    if (!height || isSeenFromBelow(*height, frame)) {
        drawBackdrop(height.has_value(), frame);
    }
    if (height) {
        drawFloor(*height, frame, camera);
        if (!isSeenFromBelow(*height, frame)) {  // the floor has the backdrop in it
            drawBackdrop(true, frame);
        }
    }
}

void FloorPass::drawBackdrop(bool hasFloor, const Frame& frame) const {
    backdrop_.use();
    backdrop_.set("hasFloor", hasFloor ? 1.0f : 0.0f);
    setBackdrop(backdrop_, frame);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthMask(GL_TRUE);
}

void FloorPass::drawFloor(double height, const Frame& frame, const Camera& camera) const {
    const double distance = (camera.eye - camera.target).norm();
    const float reach = float(kFadeReach * std::max(double(frame.bodySize), distance));
    floor_.use();
    floor_.set("keyDirection", frame.keyDirection);
    floor_.set("viewProjection", frame.viewProjection);
    floor_.set("eye", frame.eye);
    floor_.set("pixel", Eigen::Vector2f(1.0F / float(frame.width), 1.0F / float(frame.height)));
    setBackdrop(floor_, frame);
    floor_.set("shadeMatrix", frame.shadeMatrix);
    floor_.set("hasBody", frame.hasBody ? 1.0f : 0.0f);
    floor_.set("floorHeight", float(height));
    floor_.set("floorCenter", Eigen::Vector2f(float(camera.target.x()), float(camera.target.z())));
    floor_.set("floorReach", reach);
    floor_.set("poolSize", kPoolSize * frame.bodySize);
    floor_.set("fadeStart", float(kFadeBegin * reach));
    floor_.set("fadeEnd", reach);
    floor_.set("cell", float(gridCell(frame.bodySize)));
    glDepthFunc(GL_LESS);
    if (isSeenFromBelow(height, frame)) {
        glEnable(GL_BLEND);
    }
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_BLEND);
}

BoxPass::BoxPass(const gpu::Defines& defines)
    : program_(gpu::Program::graphics("render/box.vert", "render/box.frag", defines)) {}

void BoxPass::update(const SceneView& scene) {
    std::vector<shared::vec4> positions;
    std::vector<Corners> triangles;
    for (const StaticBox& box : scene.boxes) {
        const auto first = static_cast<uint>(positions.size());
        for (const Corners& t : kTriangles) {
            triangles.push_back({first + t[0], first + t[1], first + t[2], 0});
        }
        for (int i = 0; i < 8; ++i) {
            const Vec3f p = box.corner(i).cast<float>();
            positions.push_back({p.x(), p.y(), p.z(), 1});
        }
    }
    triangleCount_ = static_cast<uint>(triangles.size());
    if (triangles.empty()) {
        return;
    }
    positions_.assign(positions);
    triangles_.assign(triangles);
}

void BoxPass::draw(const Frame& frame) const {
    if (triangleCount_ == 0) {
        return;
    }
    positions_.bindStorage(shared::kBindPositions);
    triangles_.bindStorage(shared::kBindTriangles);
    program_.use();
    setLight(program_, frame);
    program_.set("viewProjection", frame.viewProjection);
    program_.set("eye", frame.eye);
    program_.set("edgeWidth", 0.012f * frame.bodySize);
    program_.set("hasBody", frame.hasBody ? 1.0f : 0.0f);
    glDepthFunc(GL_LESS);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(3 * triangleCount_));
}

BodyView BoxPass::view() const {
    BodyView view;
    view.positions = &positions_;
    view.triangles = &triangles_;
    view.triangleCount = triangleCount_;
    return view;
}

}  // namespace kerf::render
