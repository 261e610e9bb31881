#pragma once

#include "ui/state/action.h"

namespace kerf::ui {

struct PanelModel;

/// A box that finds actions, parameters and samples by words of their names, and carries one out.
/// It is open while HelpState::samples are there.
class CommandBox {
  public:
    void draw(const PanelModel& model, std::vector<Action>& actions);
    bool isOpen() const { return open_; }

  private:
    void drawFound(const PanelModel& model, std::vector<Action>& actions);

    std::array<char, 64> words_{};
    int chosen_ = 0;  ///< of what is found
    bool open_ = false;
};

}  // namespace kerf::ui
