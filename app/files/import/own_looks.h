#pragma once

#include "render/scene/appearance.h"
#include "sim/mesh/skin_attributes.h"

namespace kerf::app {

/// The model's own looks.
struct OwnLooks {
    SkinAttributes skin;                                             ///< by triangle slot
    std::shared_ptr<const render::Appearance> appearance = nullptr;  ///< none: no materials

    /// Whether it has colours to show.
    bool colored() const { return appearance != nullptr || !skin.colors.empty(); }
};

}  // namespace kerf::app
