#pragma once

#include "ui/state/action.h"

namespace kerf::ui {

struct PanelModel;

/// A box that finds actions, parameters and samples by words of their names, and carries one out,
/// or gives an action other keys. It is open while HelpState::samples are there.
class CommandBox {
  public:
    void draw(const PanelModel& model, std::vector<Action>& actions);
    bool isOpen() const { return open_; }

  private:
    void drawSearch(bool opens);
    void drawFound(const PanelModel& model, std::vector<Action>& actions);
    /// Instead of what is found, until keys are pressed for an action.
    void drawKeys(const PanelModel& model, std::vector<Action>& actions);

    std::array<char, 64> words_{};
    int chosen_ = 0;                 ///< of what is found
    std::optional<ActionId> keyed_;  ///< the action that gets other keys
    std::string refused_;            ///< why those pressed are not taken
    bool open_ = false;
};

}  // namespace kerf::ui
