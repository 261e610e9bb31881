#pragma once

#include "ui/panel_model.h"

namespace kerf::ui {

/// A row per piece: triangles, volume, share of its rest volume.
void drawPieces(const PanelModel& model);

}  // namespace kerf::ui
