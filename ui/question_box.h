#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// A box in the middle of the window that asks a question.
class QuestionBox {
  public:
    void draw(const Question& question, std::vector<Action>& actions);
    /// Whether the box was there in the last update: then no key means anything else.
    bool isOpen() const { return open_; }

  private:
    bool open_ = false;
};

}  // namespace kerf::ui
