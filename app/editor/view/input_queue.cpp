#include "app/editor/view/input_queue.h"

namespace kerf::app {
namespace {

bool changesButtons(const ui::InputEvent& event) {
    return std::holds_alternative<ui::ButtonChange>(event) ||
           std::holds_alternative<ui::FocusLost>(event);
}

bool movesPointer(const ui::InputEvent& event) {
    return std::holds_alternative<ui::PointerMove>(event) ||
           std::holds_alternative<ui::Wheel>(event);
}

/// Whether both may be seen by the panels at once.
bool mayShare(const ui::InputEvent& first, const ui::InputEvent& second) {
    if (changesButtons(first)) {
        return !changesButtons(second) && !movesPointer(second);
    }
    if (changesButtons(second)) {
        return !movesPointer(first);
    }
    const auto* key = std::get_if<ui::KeyChange>(&first);
    const auto* otherKey = std::get_if<ui::KeyChange>(&second);
    if (key == nullptr || otherKey == nullptr) {
        return true;
    }
    // The first may close the field or the dialog that the keyboard belongs to.
    return key->key != otherKey->key && !(key->down && otherKey->down);
}

}  // namespace

std::vector<ui::InputEvent> InputQueue::takeBatch() {
    std::vector<ui::InputEvent> batch;
    while (!events_.empty() && std::ranges::all_of(batch, [&](const auto& e) {
        return mayShare(e, events_.front());
    })) {
        batch.push_back(std::move(events_.front()));
        events_.pop_front();
    }
    return batch;
}

}  // namespace kerf::app
