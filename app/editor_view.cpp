#include "app/editor_state.h"

namespace kerf::app {
namespace {

std::optional<AxisView> axisViewOf(ui::ActionId id) {
    switch (id) {
        case ui::ActionId::viewFront:
            return AxisView::front;
        case ui::ActionId::viewBack:
            return AxisView::back;
        case ui::ActionId::viewRight:
            return AxisView::right;
        case ui::ActionId::viewLeft:
            return AxisView::left;
        case ui::ActionId::viewTop:
            return AxisView::top;
        case ui::ActionId::viewBottom:
            return AxisView::bottom;
        default:
            return std::nullopt;
    }
}

}  // namespace

void Editor::State::performOnView(ui::ActionId id) {
    switch (id) {
        case ui::ActionId::wireframe:
            wireframe = !wireframe;
            return;
        case ui::ActionId::orthographic:
            landCamera();
            camera.orthographic = !camera.orthographic;
            return;
        default:
            moveCamera(id);
    }
}

void Editor::State::moveCamera(ui::ActionId id) {
    render::Camera wanted = cameraFlight.destination(camera);
    if (id == ui::ActionId::frameBody) {
        wanted.frame(scene->bounds());
    } else if (id == ui::ActionId::resetView) {
        wanted = scene->document().camera;
    } else if (const std::optional<AxisView> axis = axisViewOf(id)) {
        lookAlong(wanted, *axis);
    } else {
        return;
    }
    cameraFlight.start(camera, wanted);
}

/// What is done while the camera flies is done in the view at the end.
void Editor::State::landCamera() {
    if (cameraFlight.flying()) {
        cameraFlight.land(camera);
        sceneChanged = true;
    }
}

}  // namespace kerf::app
