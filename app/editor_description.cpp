#include "app/editor_state.h"

namespace kerf::app {
namespace {

const Vec2 kNowhere(-1e5, -1e5);  // [px]

/// As the view shows them.
ui::ViewAxes axesOf(const render::Camera& camera) {
    const Eigen::Matrix3d turn = camera.view().topLeftCorner<3, 3>().cast<double>();
    return {{turn.col(0), turn.col(1), turn.col(2)}};
}

}  // namespace

std::string Editor::State::hint() const {
    if (scene == nullptr) {
        return "Drop a model (OBJ, PLY, STL) or a session here to open it, or choose an experiment "
               "at the left.";
    }
    if (scene->playing || bodyHand.holds()) {
        return "";
    }
    const ui::Tool tool = hand.settings().tool;
    if (tool == ui::Tool::grab) {
        return "Drag the body to pull at it: time runs while you hold it.";
    }
    if (tool == ui::Tool::pin) {
        return "Drag over the body to pin it there. Shift+drag pins a box, Ctrl+drag frees.";
    }
    return scene->pieceCount() > 1 ? hintForPieces() : hintForBlade(tool);
}

std::string Editor::State::hintForPieces() const {
    const bool weightless = scene->simulation().params().gravity.norm() == 0;
    return weightless ? "Press V for gravity, then Space to let the pieces fall."
                      : "Press Space to let the pieces fall.";
}

std::string Editor::State::hintForBlade(ui::Tool tool) const {
    if (strokedOnce) {
        return "";
    }
    if (tool == ui::Tool::scalpel) {
        return "Drag over the surface to cut into it.";
    }
    if (tool == ui::Tool::guillotine) {
        return "Drag the four handles to pose the blade, then press Enter to bring it down.";
    }
    return scene->playingBack()
               ? "Press Space to play the session, or drag across the model to cut it."
               : "Drag across the model to cut it.";
}

void Editor::State::describe() {
    const ui::PanelModel blank;  // GCC 12 takes parts of a temporary for uninitialized
    model = blank;
    model.helpOpen = helpOpen;
    model.display = display;
    model.history = &noHistory;
    if (scene != nullptr) {
        scene->describe(model);
        pieceDisplay.describe(model);
    }
    experiments.describe(scene.get(), model);
    model.settings = settingsFile.now;
    model.plotView = plotView;
    model.speed = clock.speed();
    model.device = options.device;
    model.hint = hint();
    model.tools = hand.settings();
    model.axes = axesOf(camera);
    model.orthographic = camera.orthographic;
    if (scene != nullptr) {
        model.ownSkin = render::toDisplay(ownMaterial().skin);
        model.ownFlesh = render::toDisplay(ownMaterial().inner);
        const Vec2 inView = interface.ownsPointer() ? kNowhere : pointer;
        model.overlay = hand.overlay(viewFrame(), inView, *scene);
        bodyHand.addTo(model.overlay, viewFrame(), inView, hand.settings(), *scene);
        model.pinned = scene->simulation().pinnedVertices().size();
    }
    model.work = workState();
    model.recentFiles = recent.files();
    if (browser) {
        model.files = browser->state();
        model.files.preview = preview.lines();
    }
    if (fault) {
        model.question = fault->question;
    }
    toast.describe(model);
}

}  // namespace kerf::app
