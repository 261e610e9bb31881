#pragma once

namespace kerf::ui {

/// The state of time.
struct TransportState {
    bool playing = false;
    bool recording = false;
    bool stroking = false;  ///< the pointer draws a stroke, or poses of one are still to come
    double speed = 1;       ///< of simulated time against the clock
    int step = 0;
    double time = 0;  ///< simulated [s]
};

}  // namespace kerf::ui
