#include "app/editor/editor_state.h"

namespace kerf::app {
namespace {

/// The world's axes as the view shows them.
ui::ViewAxes axesOf(const render::Camera& camera) {
    const Eigen::Matrix3d turn = camera.view().topLeftCorner<3, 3>().cast<double>();
    return {{turn.col(0), turn.col(1), turn.col(2)}};
}

}  // namespace

void Editor::State::describe(bool withOverlay) {
    ui::PanelModel& model = panels.model;
    ui::Overlay before = std::move(model.overlay);
    panels.describe();
    if (scene != nullptr) {
        scene->describe(model);
        if (view.display.settings.apart == 0) {
            model.overlay = withOverlay ? view.overlay(!panels.interface.ownsPointer(), *scene)
                                        : std::move(before);
        }
    }
    view.display.describe(scene.get(), model);
    model.axes = axesOf(view.camera.shown());
    model.orthographic = view.camera.shown().orthographic;
    model.tools = view.bladeTool.settings();
    model.speed = clock.speed();
    model.hint = guide.hint(scene.get(), view);
    experiments.describe(scene.get(), model);
    chooser.describe(model);
    model.work = work.state();
    if (asked) {
        model.question = asked->question;
    }
    toast.describe(model);
}

}  // namespace kerf::app
