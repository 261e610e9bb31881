#include "ui/action_table.h"

#include "sim/base/text.h"

namespace kerf::ui {
namespace {

/// "Right drag, Alt+left drag"
std::string dragsThat(ViewMotion motion, MouseScheme scheme) {
    std::vector<std::string> names;
    for (const ViewDrag& drag : rowOf(scheme).drags) {
        if (drag.motion == motion) {
            names.emplace_back(drag.name);
        }
    }
    return joined(names, ", ");
}

}  // namespace

std::vector<PointerHint> pointerTable(MouseScheme scheme) {
    const std::string zoom = dragsThat(ViewMotion::zoom, scheme);
    return {
        {"Left drag", "Cut, move a handle, pull, pin or hold open"},
        {"Shift+left drag", "Stroke: straight, in steps of 15 degrees; pin: a box"},
        {"Ctrl+left drag", "Pin: free again; a gizmo: in round steps"},
        {"Right click on a hook", "Remove its retractor"},
        {dragsThat(ViewMotion::orbit, scheme), "Turn the view"},
        {dragsThat(ViewMotion::pan, scheme), "Move the view"},
        {zoom.empty() ? "Wheel" : "Wheel, " + zoom, "Zoom to the pointer"},
        {"Ctrl+click a number", "Type a value"},
        {"Wheel, drag over a plot", "Zoom and move along its time"},
        {"Double click on a plot", "Show it from the start"},
        {"Drag an edge of a panel", "Make it larger or smaller"},
        {"Drop a file", "Open a model or a session"},
    };
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
    for (const PointerHint& hint : pointerTable(MouseScheme::kerf)) {
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
