#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/session/session.h"

namespace kerf::app {

/// What has become of the events of a session that is being made, with places as in its file.
struct SessionChange {
    std::size_t at = 0;       ///< so many events before stay
    std::size_t dropped = 0;  ///< so many behind these are gone
    /// In their place. None stands for what has a place in the list and is not saved.
    std::vector<std::optional<SessionEvent>> added;
    int steps = 0;  ///< of the session as it is now
};

}  // namespace kerf::app
