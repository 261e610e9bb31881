#include <glad/gl.h>

#include <array>
#include <cmath>

#include "app/editor/editor_state.h"

namespace kerf::app {
namespace {

constexpr std::array<float, 3> kEmptyColor{0.06F, 0.065F, 0.08F};  // while nothing is open

constexpr float kPanelRounding = 8;  // [px] at scale 1, at least that of the theme

}  // namespace

void Editor::State::ensurePicture() {
    if (picture.width() != options.width || picture.height() != options.height) {
        picture = gpu::Framebuffer(GL_RGBA8, GL_DEPTH_COMPONENT24, options.width, options.height);
        sceneChanged = true;
    }
}

render::BodyLook Editor::State::ownLook() const {
    return render::lookFor(scene->document().session.model.name());
}

/// Their rounded corners are left out.
std::vector<render::PixelRect> Editor::State::coveredPixels() const {
    const int inset = static_cast<int>(std::ceil(kPanelRounding * scale()));
    std::vector<render::PixelRect> hidden;
    for (const ui::Rect& rect : interface.covered()) {
        const int x = static_cast<int>(std::ceil(rect.x)) + inset;
        const int y = static_cast<int>(std::ceil(rect.y)) + inset;
        hidden.push_back({x, y, static_cast<int>(rect.x + rect.width) - inset - x,
                          static_cast<int>(rect.y + rect.height) - inset - y});
    }
    return hidden;
}

void Editor::State::addOverlays(render::SceneView& view) const {
    view.overlays = display.overlays;
    view.constraints = scene->simulation().constraintView();
    if (scene->simulation().hands().empty()) {
        view.constraints.pullCount = 0;  // those of a step before it let go
    }
    view.pieceBoxes = scene->simulation().pieceBounds();
    view.pinned = scene->simulation().pinnedVertices();
}

Bounds Editor::State::shownBounds(const std::vector<render::PieceLook>& looks) const {
    Bounds shown;
    for (std::size_t p = 0; p < looks.size(); ++p) {
        if (const Bounds& piece = scene->simulation().pieceBounds()[p]; !piece.empty()) {
            shown.add(Vec3(piece.low + looks[p].shift));
            shown.add(Vec3(piece.high + looks[p].shift));
        }
    }
    return shown;
}

/// What is shown apart is not where it is: whoever touches it has it together first. Whether it was
/// apart.
bool Editor::State::joinPieces() {
    const bool wasApart = display.apart > 0;
    display.apart = 0;
    sceneChanged |= wasApart;
    return wasApart;
}

void Editor::State::drawScene() {
    const std::vector<render::PixelRect> hidden = coveredPixels();
    sceneChanged = sceneChanged || hidden != covered;
    if (scene == nullptr || !sceneChanged) {
        return;
    }
    covered = hidden;
    render::SceneView view = sceneToDraw();
    view.covered = covered;
    sceneTimer.begin();
    renderer.draw(view, camera, options.width, options.height);
    sceneTimer.end();
    sceneChanged = false;
}

/// Adds all that the person chose to see.
render::SceneView Editor::State::sceneToDraw() {
    render::SceneView view = scene->view();
    view.wireframe = display.wireframe;
    view.cutLines = display.cutLines;
    view.look = render::colored(ownLook(), display.colors);
    view.pieces = pieceDisplay.looks(scene->simulation().pieceBounds(), display.apart);
    if (display.apart > 0) {
        view.focus = shownBounds(view.pieces);
    } else {
        addOverlays(view);
    }
    return view;
}

void Editor::State::draw() {
    ensurePicture();
    drawScene();
    if (scene != nullptr) {
        // The panels go over a copy, so that they can move while the scene stands still.
        renderer.target().blitColorTo(picture);
    } else {
        picture.bind();
        glClearColor(kEmptyColor[0], kEmptyColor[1], kEmptyColor[2], 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    interface.draw(picture);
}

}  // namespace kerf::app
