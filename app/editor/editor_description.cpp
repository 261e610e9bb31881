#include "app/editor/editor_state.h"

namespace kerf::app {
namespace {

const Vec2 kNowhere(-1e5, -1e5);  // [px]

/// The world's axes as the view shows them.
ui::ViewAxes axesOf(const render::Camera& camera) {
    const Eigen::Matrix3d turn = camera.view().topLeftCorner<3, 3>().cast<double>();
    return {{turn.col(0), turn.col(1), turn.col(2)}};
}

}  // namespace

Situation Editor::State::situation() const {
    Situation now;
    now.tool = bladeTool.settings().tool;
    if (scene == nullptr) {
        return now;
    }
    now.open = true;
    now.playing = scene->playing;
    now.weightless = scene->simulation().params().gravity.norm() == 0;
    now.session = scene->playingBack();
    now.cutting = scene->stroke().drawing() || scene->stroke().pending() > 0;
    now.touching = pullTool.holds();
    now.pieces = scene->pieceCount();
    now.outcome = cutWatch.outcome();
    return now;
}

void Editor::State::followFirstSteps() {
    if (scene == nullptr) {
        return;
    }
    const StrokeOutcome before = cutWatch.outcome();
    const Situation now = situation();
    cutWatch.follow(now.cutting, now.pieces, scene->simulation().report().triangles);
    firstSteps.follow(situation());
    if (cutWatch.outcome() != before) {
        settleUpdates = kSettleUpdates;
    }
}

ui::Overlay Editor::State::overlayNow() {
    const Vec2 inView = interface.ownsPointer() ? kNowhere : pointer;
    ui::Overlay overlay = bladeTool.overlay(viewFrame(), inView, *scene);
    pullTool.addTo(overlay, viewFrame(), inView, bladeTool.settings(), *scene);
    return overlay;
}

void Editor::State::describe(bool withOverlay) {
    ui::Overlay before = std::move(model.overlay);
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
    model.hint = firstSteps.hint(situation());
    model.tools = bladeTool.settings();
    model.axes = axesOf(camera);
    model.orthographic = camera.orthographic;
    if (scene != nullptr) {
        model.ownSkin = render::toDisplay(ownLook().skin);
        model.ownFlesh = render::toDisplay(ownLook().inner);
        if (display.apart == 0) {
            model.overlay = withOverlay ? overlayNow() : std::move(before);
        }
        model.pinned = scene->simulation().pinnedVertices().size();
    }
    model.work = workState();
    model.recentFiles = recent.files();
    if (browser) {
        model.files = browser->state();
        model.files.preview = preview.lines();
    }
    if (asked) {
        model.question = asked->question;
    }
    toast.describe(model);
}

}  // namespace kerf::app
