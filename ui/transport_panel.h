#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/session_panel.h"

namespace kerf::ui {

/// How time runs.
struct TransportState {
    bool playing = false;
    bool recording = false;
    bool stroking = false;  ///< the pointer draws a stroke, or poses of one are still to come
    double speed = 1;       ///< of simulated time against the clock
    int step = 0;
    double time = 0;  ///< simulated [s]
};

/// Draws the buttons that play, pause, step, reset and record, and the simulated time.
void drawTransport(const TransportState& transport, const PlaybackState& playback,
                   std::vector<Action>& actions);

}  // namespace kerf::ui
