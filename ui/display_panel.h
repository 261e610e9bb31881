#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/fault_legend.h"
#include "ui/field_legend.h"

namespace kerf::ui {

struct PanelModel;

/// What the looks of the body and the legend are drawn from.
struct LooksState {
    FieldLegend field;
    std::vector<FaultRow> faults;  ///< that are marked in the view
    /// A model that can't be cut stands in the view, with its faults, instead of the body.
    bool showsFaulty = false;
    Vec3 ownSkin = Vec3::Zero();  ///< colours of the look itself (see DisplaySettings::colors)
    Vec3 ownFlesh = Vec3::Zero();
    bool hasOwnColors = false;  ///< the model's file has colours or images
};

/// Draws the switches of all that is drawn over the body, and the choosers of its colours.
void drawDisplay(const PanelModel& model, std::vector<Action>& actions);

/// Draws the meaning of the colours of the overlays, and of the body where they show a quantity, at
/// the right of the view, while any is shown.
void drawLegend(const LooksState& looks, const DisplaySettings& display, const Rect& view,
                float scale);

}  // namespace kerf::ui
