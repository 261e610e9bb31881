#pragma once

#include <optional>
#include <string>

namespace kerf::ui {

/// Long work in the background.
struct WorkState {
    std::string title;  ///< "Opening ball.ply"; empty for none
    std::string stage;  ///< "Building the constraints"
    double seconds = 0;
    /// The share done, 0 to 1; none if unknown.
    std::optional<double> share = std::nullopt;
    bool mayEnd = true;  ///< can be cancelled
};

}  // namespace kerf::ui
