#pragma once

#include <vector>

#include "sim/base/math.h"
#include "ui/state/fault_legend.h"
#include "ui/state/field_legend.h"

namespace kerf::ui {

/// The state of the looks and the legend.
struct LooksState {
    FieldLegend field;
    std::vector<FaultRow> faults;  ///< that are marked in the view
    /// The view shows a model that can't be cut, with its faults, instead of the body.
    bool showsFaulty = false;
    Vec3 ownSkin = Vec3::Zero();  ///< colours of the look itself (see DisplaySettings::colors)
    Vec3 ownFlesh = Vec3::Zero();
    bool hasOwnColors = false;  ///< the model's file has colours or images
};

}  // namespace kerf::ui
