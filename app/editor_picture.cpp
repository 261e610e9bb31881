#include <glad/gl.h>

#include <array>

#include "app/editor_state.h"

namespace kerf::app {
namespace {

constexpr std::array<float, 3> kEmptyColor{0.06F, 0.065F, 0.08F};  // while nothing is open

}  // namespace

void Editor::State::ensurePicture() {
    if (picture.width() != options.width || picture.height() != options.height) {
        picture = gpu::Framebuffer(GL_RGBA8, GL_DEPTH_COMPONENT24, options.width, options.height);
        sceneChanged = true;
    }
}

void Editor::State::drawScene() {
    if (scene == nullptr || !sceneChanged) {
        return;
    }
    render::SceneView view = scene->view();
    view.wireframe = wireframe;
    view.pieces = pieceDisplay.looks(scene->simulation().pieceBounds().size());
    sceneTimer.begin();
    renderer.draw(view, camera, options.width, options.height);
    sceneTimer.end();
    sceneChanged = false;
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
