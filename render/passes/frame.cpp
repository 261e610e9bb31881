#include "render/passes/frame.h"

#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

const Vec3 kKeyDirection = Vec3(-0.18, 0.86, 0.48).normalized();
constexpr double kShadeRange = 2.0;   // of the body's size: heights that are told apart
constexpr double kFarAway = 1e4;      // of the distance between eye and target
constexpr double kShadeMargin = 0.2;  // of the body's size, around the darkened floor

Bounds focusOf(const SceneView& scene) {
    if (!scene.focus.empty()) {
        return scene.focus;
    }
    if (!scene.restBounds.empty()) {
        return scene.restBounds;
    }
    return {Vec3::Constant(-0.5), Vec3::Constant(0.5)};
}

/// Parallel rays come, near enough, from very far away.
Vec3 shadingEye(const Camera& camera) {
    const Vec3 arm = camera.eye - camera.target;
    return camera.orthographic ? Vec3(camera.target + kFarAway * arm) : camera.eye;
}

/// The backdrop keeps its gradient in an orthographic view.
Eigen::Matrix4f perspectiveOf(Camera camera, double aspect) {
    camera.orthographic = false;
    return camera.projection(aspect);
}

/// Boxes around the body cast and catch its shadow; those farther away would only coarsen it.
Bounds withBoxes(const Bounds& focus, const std::vector<StaticBox>& boxes) {
    constexpr double kReach = 0.75;  // of the body's diagonal
    Bounds reach = focus;
    reach.widen(kReach * focus.diagonal());
    Bounds out = focus;
    for (const StaticBox& box : boxes) {
        const Bounds bounds = box.bounds();
        if (bounds.overlaps(reach)) {
            out.add(Bounds{bounds.low.cwiseMax(reach.low), bounds.high.cwiseMin(reach.high)});
        }
    }
    return out;
}

/// Rounds up in steps of 1/16 of its power of two, so that a moving body changes it rarely.
double steppedUp(double radius) {
    const double step = std::exp2(std::floor(std::log2(radius))) / 16;
    return std::ceil(radius / step) * step;
}

/// An orthographic light around the focus. Centre and size move in whole texels and steps: the edge
/// of the shadow doesn't shimmer while the body moves.
void aimKeyLight(Frame& frame, int shadowSize) {
    const double radius = steppedUp(std::max(0.505 * frame.focus.diagonal(), 1e-9));
    const double texel = 2 * radius / (shadowSize - 2);
    const double reach = 0.5 * texel * shadowSize;
    const Vec3 z = kKeyDirection;
    const Vec3 x = Vec3::UnitY().cross(z).normalized();
    const Vec3 y = z.cross(x);
    const Vec3 center = frame.focus.center();
    const auto snapped = [&](const Vec3& axis) {
        return std::round(center.dot(axis) / texel) * texel;
    };
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.block<1, 3>(0, 0) = x.transpose() / reach;
    m.block<1, 3>(1, 0) = y.transpose() / reach;
    m.block<1, 3>(2, 0) = -z.transpose() / reach;
    m(0, 3) = -snapped(x) / reach;
    m(1, 3) = -snapped(y) / reach;
    m(2, 3) = snapped(z) / reach;
    frame.keyDirection = z.cast<float>();
    frame.lightMatrix = m.cast<float>();
    frame.shadowTexel = float(texel);
}

/// The floor's rectangle that the focus can darken (x and z), margin included.
Bounds shadedFloor(const Frame& frame, double floor) {
    const double height = std::max(frame.focus.high.y() - floor, 0.0);
    const Vec3 shift = -kKeyDirection * (height / kKeyDirection.y());
    Bounds shaded = frame.focus;
    shaded.add(frame.focus.low + shift);
    shaded.add(frame.focus.high + shift);
    shaded.widen(kShadeMargin * frame.bodySize);
    return shaded;
}

void aimFloorShade(Frame& frame, double floor) {
    const Bounds shaded = shadedFloor(frame, floor);
    const Vec3 center = shaded.center();
    const Vec3 half = 0.5 * (shaded.high - shaded.low);
    const double reach = steppedUp(std::max(half.x(), half.z()));
    const double range = kShadeRange * frame.bodySize;
    Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
    m(0, 0) = 1 / reach;
    m(0, 3) = -center.x() / reach;
    m(1, 2) = 1 / reach;
    m(1, 3) = -center.z() / reach;
    m(2, 1) = 2 / range;
    m(2, 3) = -2 * floor / range - 1;
    m(3, 3) = 1;
    Eigen::Matrix4d shear = Eigen::Matrix4d::Identity();
    for (const int axis : {0, 2}) {
        const double slope = kKeyDirection[axis] / kKeyDirection.y();
        shear(axis, 1) = -slope;
        shear(axis, 3) = slope * floor;
    }
    frame.shadeMatrix = m.cast<float>();
    frame.shadeMatrixAlongKey = (m * shear).cast<float>();
    frame.shadeRange = float(range);
    frame.shadeReach = float(reach);
}

}  // namespace

Frame frameOf(const SceneView& scene, const Camera& camera, int width, int height, int shadowSize) {
    Frame frame;
    frame.width = width;
    frame.height = height;
    const Eigen::Matrix4f projection = camera.projection(double(width) / height);
    Eigen::Matrix4f turn = camera.view();
    frame.viewProjection = projection * turn;
    turn.topRightCorner<3, 1>().setZero();
    frame.pictureToWorld = (perspectiveOf(camera, double(width) / height) * turn).inverse();
    frame.eye = shadingEye(camera).cast<float>();
    frame.hasBody = scene.body.positions != nullptr && scene.body.triangleCount > 0;
    frame.bright = scene.bright;
    frame.focus = focusOf(scene);
    const Bounds& sized = scene.restBounds.empty() ? frame.focus : scene.restBounds;
    frame.bodySize = float(std::max(sized.diagonal(), 1e-9));
    frame.focus = withBoxes(frame.focus, scene.boxes);
    aimKeyLight(frame, shadowSize);
    if (scene.floor) {
        aimFloorShade(frame, *scene.floor);
    }
    return frame;
}

void bindLooks(const gpu::Program& program, const Frame& frame) {
    frame.looks->bindStorage(shared::kBindLooks);
    program.set("lookCount", frame.lookCount);
}

void bindNoLooks(const gpu::Program& program, const Frame& frame) {
    frame.looks->bindStorage(shared::kBindLooks);
    program.set("lookCount", std::uint32_t{0});
}

void setLight(const gpu::Program& program, const Frame& frame) {
    program.set("keyDirection", frame.keyDirection);
    program.set("lightMatrix", frame.lightMatrix);
    program.set("shadowTexel", frame.shadowTexel);
}

}  // namespace kerf::render
