#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/action.h"
#include "ui/layout.h"

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

/// Draws the work that takes long, its stage and its time, at the upper edge of the view, with
/// a button to give it up where it may end; nothing where the title is empty.
void drawWork(const WorkState& work, const Rect& view, std::vector<Action>& actions);

}  // namespace kerf::ui
