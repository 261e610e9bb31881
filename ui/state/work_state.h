#pragma once

#include <optional>
#include <string>

namespace kerf::ui {

/// Long work in the background.
struct WorkState {
    std::string title;                          ///< "Opening ball.ply"; empty for none
    std::string stage;                          ///< "Building the constraints"
    double done = 0;                            ///< parts
    double all = 0;                             ///< parts; 0 if unknown
    bool mayEnd = true;                         ///< can be cancelled
    double seconds = 0;                         ///< since it began
    std::optional<double> left = std::nullopt;  ///< [s], estimated; none if unknown
};

/// ", about 20 s left", or ", 12 s so far" where the end is not known.
std::string timeText(const WorkState& work);

}  // namespace kerf::ui
