#pragma once

#include "gpu/framebuffer.h"
#include "render/scene/image.h"
#include "ui/base/layout.h"
#include "ui/state/action.h"
#include "ui/state/window_state.h"

namespace kerf::ui {

/// A box that asks a question: in the middle of the window, or at the lower edge of the view.
class QuestionBox {
  public:
    /// `view` is the area free of panels [px].
    void draw(const Question& question, const Rect& view, std::vector<Action>& actions);
    /// Whether the box was open in the last update: then it takes all keys.
    bool isOpen() const { return open_; }
    /// Whether a point [px] was outside a box with Question::aside.
    bool leavesOpen(float x, float y) const;

  private:
    void drawPicture();
    void drawNumber(const AskedNumber& asked);

    gpu::Texture picture_;
    double number_ = 0;  ///< as it was typed
    bool open_ = false;
    bool aside_ = false;
    Rect place_;  ///< of the last box [px]
};

}  // namespace kerf::ui
