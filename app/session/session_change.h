#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/session/session.h"

namespace kerf::app {

/// A change of the events of a session being made, with positions as in its file.
struct SessionChange {
    std::size_t at = 0;       ///< number of unchanged events before
    std::size_t dropped = 0;  ///< number of removed events there
    /// Their replacement. None for an entry that is not saved.
    std::vector<std::optional<SessionEvent>> added;
    int steps = 0;  ///< of the present session
};

}  // namespace kerf::app
