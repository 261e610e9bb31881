#include "render/passes/floor_pass.h"

#include <glad/gl.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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

}  // namespace kerf::render
