#pragma once

#include <vector>

#include "gpu/framebuffer.h"
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
    void drawPicture();

    gpu::Texture picture_;
    bool open_ = false;
};

}  // namespace kerf::ui
