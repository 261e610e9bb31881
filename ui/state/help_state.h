#pragma once

#include <string>
#include <vector>

#include "ui/state/action.h"
#include "ui/state/start_state.h"

namespace kerf::ui {

/// An action that a hint offers, with its label there.
struct HintChoice {
    ActionId id{};
    std::string label;
};

/// A sentence on what to do next.
struct Hint {
    std::string text;  ///< empty for no hint
    std::vector<HintChoice> choices;
};

/// Help that is offered.
struct HelpState {
    Hint hint;
    StartState start;
    bool open = false;  ///< the page of keys
};

}  // namespace kerf::ui
