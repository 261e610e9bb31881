#pragma once

#include <deque>
#include <vector>

#include "ui/base/input.h"

namespace kerf::app {

/// Input waits here until the editor takes it, one batch per update of the panels. A pointer move
/// and a button change never share a batch, nor do two changes of buttons or of one key: however
/// slow the frames and fast the hand, no click is lost and every press happens where the pointer
/// was.
class InputQueue {
  public:
    void push(ui::InputEvent event) { events_.push_back(std::move(event)); }
    bool empty() const { return events_.empty(); }

    /// The longest start of the queue that keeps the rule; empty only where the queue is.
    std::vector<ui::InputEvent> takeBatch();

  private:
    std::deque<ui::InputEvent> events_;
};

}  // namespace kerf::app
