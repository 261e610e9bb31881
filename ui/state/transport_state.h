#pragma once

#include <optional>

namespace kerf::ui {

/// The state of time.
struct TransportState {
    bool playing = false;
    bool recording = false;
    bool seeking = false;   ///< steps are computed to go to another one
    bool pulling = false;   ///< a hand moves the body while time is paused
    bool stroking = false;  ///< the pointer draws a stroke, or poses of one are still to come
    double speed = 1;       ///< wanted, of simulated time against the clock
    /// Simulated seconds over seconds of the clock, lately; none before time ran.
    std::optional<double> realTimeFactor;
    int step = 0;
    double time = 0;         ///< simulated, since the last restart [s]
    bool restarted = false;  ///< there was one
};

}  // namespace kerf::ui
