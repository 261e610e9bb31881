#pragma once

#include <vector>

#include "ui/state/action.h"
#include "ui/state/session_state.h"
#include "ui/state/transport_state.h"

namespace kerf::ui {

/// Draws the buttons that play, pause, step, reset and record, and the simulated time.
void drawTransport(const TransportState& transport, const PlaybackState& playback,
                   std::vector<Action>& actions);

}  // namespace kerf::ui
