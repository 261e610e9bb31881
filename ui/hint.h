#pragma once

#include <string>
#include <vector>

#include "ui/action.h"
#include "ui/layout.h"

namespace kerf::ui {

struct PanelModel;

/// An action that a hint offers, with its label there.
struct HintChoice {
    ActionId id{};
    std::string label;
};
/// A sentence that says what to do first or next.
struct Hint {
    std::string text;  ///< empty for no hint
    std::vector<HintChoice> choices;
};

/// Help that is offered.
struct HelpState {
    Hint hint;
    bool open = false;  ///< the page of keys
};

/// Draws what to do first or next into the view: at its lower edge, or in its middle while nothing
/// is open. It takes no input but on the buttons of its choices.
void drawHint(const PanelModel& model, const Rect& view, std::vector<Action>& actions);

/// While no side panel is shown: draws a button with the key that brings them back, where the menu
/// was.
void drawPanelsHint(const Settings& settings, const Rect& view, std::vector<Action>& actions);

}  // namespace kerf::ui
