#pragma once

#include <deque>

#include "ui/base/input.h"

namespace kerf::app {

/// Queue of input for the editor, one batch per update of the panels. A pointer move and a button
/// change never share a batch, nor do two changes of buttons or of one key: so no click is lost,
/// however slow the frames, and every press happens where the pointer was.
class InputQueue {
  public:
    void push(ui::InputEvent event) { events_.push_back(std::move(event)); }
    bool empty() const { return events_.empty(); }

    /// The longest start of the queue that keeps the rule; empty only if the queue is.
    std::vector<ui::InputEvent> takeBatch();

  private:
    std::deque<ui::InputEvent> events_;
};

}  // namespace kerf::app
