#include "app/editor/view/editor_picture.h"

#include <glad/gl.h>

#include "sim/mesh/triangle.h"
#include "sim/run/simulation.h"

namespace kerf::app {
namespace {

// While nothing is open, in the dark theme and in the bright one.
constexpr std::array<float, 3> kEmptyColor{0.06F, 0.065F, 0.08F};
constexpr std::array<float, 3> kBrightEmptyColor{0.86F, 0.87F, 0.89F};

std::optional<Vec3> ledTo(const BusyScene& scene) {
    const std::vector<Blade> way = scene.stroke().wayAhead();
    return way.empty() ? std::nullopt : std::optional(way.back().b);
}

}  // namespace

void EditorPicture::drawScene(const BusyScene& scene, const Shot& shot, bool transparent) {
    render::SceneView view = shot.display.viewOf(scene);
    view.covered = shot.covered;
    view.transparent = transparent;
    view.bright = shot.bright;
    renderer_.setQuality(shot.display.settings.quality);
    renderer_.draw(view, shot.frame.camera, shot.frame.width, shot.frame.height);
    if (view.field.choice.field != render::SurfaceField::look) {
        fieldRange_ = renderer_.fieldRange();
    }
}

void EditorPicture::fit(const EditorView& view) {
    if (target_.width() != view.width || target_.height() != view.height) {
        target_ = gpu::Framebuffer(GL_RGBA8, GL_DEPTH_COMPONENT24, view.width, view.height);
    }
}

void EditorPicture::keep(const EditorView& view) {
    fit(view);
    if (drawn_) {
        renderer_.target().blitColorTo(target_);
    }
}

void EditorPicture::draw(const BusyScene& scene, const EditorView& view,
                         std::vector<render::PixelRect> covered, bool changed) {
    fit(view);
    if (!scene) {
        target_.bind();
        const auto& color = view.bright ? kBrightEmptyColor : kEmptyColor;
        glClearColor(color[0], color[1], color[2], 1);
        glClear(GL_COLOR_BUFFER_BIT);
        return;
    }
    if (Shot shot{view.frame(), view.display, std::move(covered), view.bright, true, ledTo(scene)};
        changed || drawn_ != shot) {
        sceneTimer_.begin();
        drawScene(scene, shot, false);
        sceneTimer_.end();
        drawn_ = std::move(shot);
    }
    renderer_.target().blitColorTo(target_);  // The panels move while the scene stands still.
}

void EditorPicture::drawModel(const render::SceneView& model, const EditorView& view,
                              bool changed) {
    fit(view);
    Shot shot{view.frame(), view.display, model.covered, model.bright, false};
    if (changed || drawn_ != shot) {
        renderer_.setQuality(view.display.settings.quality);
        renderer_.draw(model, shot.frame.camera, shot.frame.width, shot.frame.height);
        drawn_ = std::move(shot);
    }
    renderer_.target().blitColorTo(target_);
}

std::optional<double> EditorPicture::fieldAt(EditorScene& scene, const SurfacePoint& point) const {
    const SurfaceMesh& mesh = scene.simulation().meshAsRead();
    const Triangle& corners = mesh.triangle(point.triangle);
    const bool onWall = mesh.kind(point.triangle) == SurfaceKind::wall;
    const auto [a, b, c] = cornersOf(mesh, point.triangle);
    const Vec3 shares = closestWeights(point.position, a, b, c);
    double value = 0;
    for (int i = 0; i < 3; ++i) {
        const auto vertex = static_cast<std::uint32_t>(corners[i]);
        const std::optional<float> at =
            renderer_.fieldAt(scene.simulation().bodyRevision(), vertex, onWall);
        if (!at) {
            return std::nullopt;
        }
        value += shares[i] * *at;
    }
    return value;
}

render::Image EditorPicture::readFree(const EditorView& view) const {
    render::Image whole = read();
    const auto clamped = [](float value, int most) {
        return std::clamp(static_cast<int>(value), 0, most);
    };
    const int left = clamped(view.free.x, whole.width);
    const int top = clamped(view.free.y, whole.height);
    const int right = clamped(view.free.x + view.free.width, whole.width);
    const int bottom = clamped(view.free.y + view.free.height, whole.height);
    if (right <= left || bottom <= top) {
        return whole;
    }
    render::Image part{right - left, bottom - top, {}};
    for (int y = top; y < bottom; ++y) {
        const auto row = whole.pixels.begin() + std::ptrdiff_t(4) * (y * whole.width + left);
        part.pixels.insert(part.pixels.end(), row, row + std::ptrdiff_t(4) * part.width);
    }
    return part;
}

render::Image EditorPicture::readScene(EditorScene& scene, const EditorView& view) {
    drawn_.reset();
    drawScene({&scene, false}, {view.frame(), view.display, {}, false}, true);
    render::Image image = renderer_.readPicture();
    render::divideByAlpha(image);
    return image;
}

}  // namespace kerf::app
