#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// The question in the middle of everything.
class QuestionBox {
  public:
    void draw(const Question& question, std::vector<Action>& actions);
    /// Whether it was there in the last pass: then no key means anything else.
    bool isOpen() const { return open_; }

  private:
    bool open_ = false;
};

}  // namespace kerf::ui
