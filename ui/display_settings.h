#pragma once

#include "render/material.h"
#include "render/overlays.h"
#include "render/renderer.h"

namespace kerf::ui {

/// How the body is shown. Nothing of it changes the simulation.
struct DisplaySettings {
    render::Quality quality = render::Quality::full;
    bool wireframe = false;
    render::Overlays overlays;
    render::ChosenColors colors;  ///< instead of the model's own
    bool operator==(const DisplaySettings&) const = default;
};

}  // namespace kerf::ui
