#pragma once

#include <optional>
#include <string>

namespace kerf::ui {

/// Something that takes long while the editor goes on.
struct WorkState {
    std::string title;  ///< "Opening ball.ply"; empty while there is nothing to tell
    std::string stage;  ///< "Building the constraints"
    double seconds = 0;
    /// What is done of it, 0 to 1; none where that is not known.
    std::optional<double> share = std::nullopt;
    bool mayEnd = true;  ///< before it is done, if the person wishes
};

}  // namespace kerf::ui
