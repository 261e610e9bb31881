#pragma once

#include <string>

#include "sim/run/parts/command.h"

namespace kerf::app {

/// Captions of a film about events of its session.
class FilmCaptions {
  public:
    /// `speed`: simulated seconds in a second of the film.
    explicit FilmCaptions(double speed);

    /// Records a command at a time of the film [s].
    void note(const Command& command, double filmTime);
    /// The caption at a time of the film, at simulated `time` [s]: "0.65 s, 4 times slower. Cut 1".
    /// The last event is shown for a while, a cut as long as its blade is down.
    std::string at(double filmTime, double time) const;

  private:
    void tell(std::string words, double filmTime);

    std::string pace_;   ///< ", 4 times slower"; empty in real time
    std::string words_;  ///< empty for none
    double since_ = 0;   ///< of the film [s]
    bool bladeIsDown_ = false;
    int cuts_ = 0;
};

}  // namespace kerf::app
