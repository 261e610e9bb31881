#include "app/editor/editor_state.h"
#include "ui/display_switch.h"

namespace kerf::app {
namespace {

constexpr double kApart = 0.5;  // of DisplaySettings::apart, by its key

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

void Editor::State::setDisplay(const ui::DisplaySettings& settings) {
    renderer.setQuality(settings.quality);
    display = settings;
    sceneChanged = true;
    settlePasses = kSettlePasses;
}

void Editor::State::performOnView(ui::ActionId id) {
    if (bool* shown = ui::displaySwitch(display, id)) {
        *shown = !*shown;
        return;
    }
    switch (id) {
        case ui::ActionId::fineQuality: {
            const bool fine = display.quality == render::Quality::full;
            ui::DisplaySettings wanted = display;
            wanted.quality = fine ? render::Quality::light : render::Quality::full;
            setDisplay(wanted);
            return;
        }
        case ui::ActionId::showApart:
            display.apart = display.apart > 0 || scene->pieceCount() < 2 ? 0 : kApart;
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
