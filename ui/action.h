#pragma once

#include <cstdint>
#include <variant>

#include "sim/command.h"

namespace kerf::ui {

/// What a shortcut or a button asks for: the rows of the shortcut table.
enum class ActionId : std::uint8_t {
    playPause,
    stepOnce,
    reset,
    toggleGravity,
    cancel,
    frameBody,
    resetView,
    viewFront,
    viewRight,
    viewTop,
    wireframe,
    screenshot,
    help,
    quit,
};

/// All that panels answer with. The editor drains them once per frame; panels change nothing.
using Action = std::variant<ActionId, SetParam>;

}  // namespace kerf::ui
