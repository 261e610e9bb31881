#include "app/editor/editor_state.h"

namespace kerf::app {

void Editor::State::setDisplay(const ui::DisplaySettings& settings) {
    renderer.setQuality(settings.quality);
    display = settings;
    sceneChanged = true;
    settleUpdates = kSettleUpdates;
}

/// What is done while the camera flies is done in the view at the end.
void Editor::State::landCamera() {
    if (cameraFlight.flying()) {
        cameraFlight.land(camera);
        sceneChanged = true;
    }
}

}  // namespace kerf::app
