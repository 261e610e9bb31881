#include "ui/action_table.h"

namespace kerf::ui {
namespace {

constexpr std::array kPointerHints{
    PointerHint{"Left drag", "Cut, move a handle of the guillotine, pull or pin"},
    PointerHint{"Shift+left drag", "Stroke: straight, in steps of 15 degrees; pin: a box"},
    PointerHint{"Ctrl+left drag", "Pin: free again"},
    PointerHint{"Right drag, Alt+left drag", "Turn the view"},
    PointerHint{"Middle drag, Shift+right drag", "Move the view"},
    PointerHint{"Wheel", "Zoom to the pointer"},
    PointerHint{"Ctrl+click a number", "Type a value"},
    PointerHint{"Wheel, drag over a plot", "Zoom and move along its time"},
    PointerHint{"Double click on a plot", "Show it from the start"},
    PointerHint{"Drag an edge of a panel", "Make it larger or smaller"},
    PointerHint{"Drop a file", "Open a model or a session"},
};

}  // namespace

std::span<const PointerHint> pointerTable() {
    return kPointerHints;
}

std::optional<ActionId> findAction(Key key, Modifiers modifiers) {
    for (const ActionRow& row : kActions) {
        if (row.shortcut.presses(key, modifiers) || row.second.presses(key, modifiers)) {
            return row.id;
        }
    }
    return std::nullopt;
}

std::string keysOf(ActionId id) {
    const std::string_view second = rowOf(id).second.text;
    return std::string(keyOf(id)) + (second.empty() ? "" : ", " + std::string(second));
}

std::string actionsAsMarkdown() {
    std::string text = "| keys | what they do |\n|---|---|\n";
    const auto addRow = [&](std::string_view keys, std::string_view label) {
        text.append("| ").append(keys).append(" | ").append(label).append(" |\n");
    };
    for (const PointerHint& hint : kPointerHints) {
        addRow(hint.gesture, hint.label);
    }
    for (const ActionRow& row : kActions) {
        addRow(keysOf(row.id), row.label);
    }
    return text;
}

std::string describeAction(ActionId id) {
    return std::string(rowOf(id).label) + " (" + std::string(keyOf(id)) + ")";
}

}  // namespace kerf::ui
