#pragma once

#include "ui/action.h"
#include "ui/display_settings.h"

namespace kerf::ui {

/// What an action switches on and off in the picture, of DisplaySettings or const DisplaySettings;
/// nullptr where it is not such an action.
template <class Settings>
auto displaySwitch(Settings& display, ActionId id) -> decltype(&display.wireframe) {
    switch (id) {
        case ActionId::wireframe:
            return &display.wireframe;
        case ActionId::showCutLines:
            return &display.cutLines;
        case ActionId::showEdges:
            return &display.overlays.edges;
        case ActionId::showBends:
            return &display.overlays.bends;
        case ActionId::showIspcs:
            return &display.overlays.ispcs;
        case ActionId::showErrors:
            return &display.overlays.errors;
        case ActionId::showContacts:
            return &display.overlays.contacts;
        case ActionId::showBoxes:
            return &display.overlays.boxes;
        default:
            return nullptr;
    }
}

}  // namespace kerf::ui
