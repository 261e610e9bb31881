#include "ui/shortcuts.h"

#include <array>
#include <cassert>

namespace kerf::ui {
namespace {

constexpr Modifiers kPlain{};
constexpr Modifiers kShift{.shift = true};
constexpr Modifiers kControl{.control = true};

constexpr Modifiers kControlShift{.shift = true, .control = true};

constexpr std::array kShortcuts{
    Shortcut{ActionId::openFile, Key::o, kControl, "Ctrl+O", "Open a model or a session...",
             "File"},
    Shortcut{ActionId::saveSession, Key::s, kControl, "Ctrl+S", "Save all since the start...",
             "File"},
    Shortcut{ActionId::exportBody, Key::e, kControl, "Ctrl+E", "Export the body...", "File"},
    Shortcut{ActionId::screenshot, Key::f12, kPlain, "F12", "Save a screenshot here", "File"},
    Shortcut{ActionId::sceneScreenshot, Key::f12, kControl, "Ctrl+F12",
             "Save the scene alone, on no ground", "File"},
    Shortcut{ActionId::quit, Key::q, kControl, "Ctrl+Q", "Leave", "File"},
    Shortcut{ActionId::undo, Key::z, kControl, "Ctrl+Z", "Undo", "Edit"},
    Shortcut{ActionId::redo, Key::z, kControlShift, "Ctrl+Shift+Z", "Redo", "Edit"},
    Shortcut{ActionId::redo, Key::y, kControl, "Ctrl+Y", "Redo", "Edit"},
    Shortcut{ActionId::cancel, Key::escape, kPlain, "Esc",
             "Stop the stroke, the loading, close the help", "Edit"},
    Shortcut{ActionId::toggleGravity, Key::v, kPlain, "V", "Gravity on or off", "Edit"},
    Shortcut{ActionId::toolStroke, Key::c, kPlain, "C", "Stroke: cut along the view", "Tool"},
    Shortcut{ActionId::toolScalpel, Key::s, kPlain, "S", "Scalpel: follow the surface", "Tool"},
    Shortcut{ActionId::toolGuillotine, Key::g, kPlain, "G", "Guillotine: pose the blade", "Tool"},
    Shortcut{ActionId::toolGrab, Key::d, kPlain, "D", "Grab: pull at the body", "Tool"},
    Shortcut{ActionId::toolPin, Key::p, kPlain, "P", "Pin: hold parts in place", "Tool"},
    Shortcut{ActionId::bringDown, Key::enter, kPlain, "Enter", "Bring the guillotine down", "Tool"},
    Shortcut{ActionId::freePins, Key::p, kShift, "Shift+P", "Free all that is pinned", "Tool"},
    Shortcut{ActionId::playPause, Key::space, kPlain, "Space", "Play or pause", "Time"},
    Shortcut{ActionId::letFall, Key::space, kShift, "Shift+Space",
             "Let it fall: gravity and time on", "Time"},
    Shortcut{ActionId::stepOnce, Key::period, kPlain, ".", "One step", "Time"},
    Shortcut{ActionId::reset, Key::r, kPlain, "R", "Back to the start", "Time"},
    Shortcut{ActionId::slower, Key::minus, kPlain, "-", "Half as fast", "Time"},
    Shortcut{ActionId::faster, Key::equal, kPlain, "=", "Twice as fast", "Time"},
    Shortcut{ActionId::record, Key::r, kControl, "Ctrl+R", "Record from the start, stop", "Time"},
    Shortcut{ActionId::loop, Key::l, kPlain, "L", "Repeat the session", "Time"},
    Shortcut{ActionId::frameBody, Key::f, kPlain, "F", "Bring the model into view", "View"},
    Shortcut{ActionId::resetView, Key::home, kPlain, "Home", "Back to the first view", "View"},
    Shortcut{ActionId::viewFront, Key::digit1, kPlain, "1", "From the front", "View"},
    Shortcut{ActionId::viewBack, Key::digit1, kControl, "Ctrl+1", "From the back", "View"},
    Shortcut{ActionId::viewRight, Key::digit3, kPlain, "3", "From the right", "View"},
    Shortcut{ActionId::viewLeft, Key::digit3, kControl, "Ctrl+3", "From the left", "View"},
    Shortcut{ActionId::viewTop, Key::digit7, kPlain, "7", "From the top", "View"},
    Shortcut{ActionId::viewBottom, Key::digit7, kControl, "Ctrl+7", "From below", "View"},
    Shortcut{ActionId::orthographic, Key::digit5, kPlain, "5", "Without perspective", "View"},
    Shortcut{ActionId::wireframe, Key::w, kPlain, "W", "Show the triangles", "View"},
    Shortcut{ActionId::showCutLines, Key::t, kPlain, "T", "Show the lines of cuts", "View"},
    Shortcut{ActionId::showApart, Key::a, kPlain, "A", "Show the pieces apart", "View"},
    Shortcut{ActionId::showEdges, Key::e, kPlain, "E", "Show the edge constraints", "View"},
    Shortcut{ActionId::showBends, Key::b, kPlain, "B", "Show the bending constraints", "View"},
    Shortcut{ActionId::showIspcs, Key::i, kPlain, "I", "Show the ISPCs", "View"},
    Shortcut{ActionId::showErrors, Key::x, kPlain, "X", "Colour them by their error", "View"},
    Shortcut{ActionId::showContacts, Key::k, kPlain, "K", "Show the contacts", "View"},
    Shortcut{ActionId::showBoxes, Key::o, kPlain, "O", "Show boxes around the pieces", "View"},
    Shortcut{ActionId::fineQuality, Key::q, kPlain, "Q", "Fine picture: soft shadows, smooth edges",
             "View"},
    Shortcut{ActionId::togglePanels, Key::tab, kPlain, "Tab", "Panels, or the view alone", "View"},
    Shortcut{ActionId::holdPlots, Key::h, kPlain, "H", "Hold the plots, or follow again", "View"},
    Shortcut{ActionId::fitPlots, Key::h, kShift, "Shift+H", "Show the plots from the start",
             "View"},
    Shortcut{ActionId::help, Key::f1, kPlain, "F1", "All keys", "Help"},
    Shortcut{ActionId::help, Key::questionMark, kPlain, "?", "All keys", "Help"},
};

constexpr std::array kPointerHints{
    PointerHint{"Left drag", "Cut, move a handle of the guillotine, pull or pin"},
    PointerHint{"Shift+left drag", "Stroke: straight, in steps of 15 degrees; pin: a box"},
    PointerHint{"Ctrl+left drag", "Pin: free again"},
    PointerHint{"Right drag, Alt+left drag", "Turn the view"},
    PointerHint{"Middle drag, Shift+right drag", "Move the view"},
    PointerHint{"Wheel", "Zoom to the pointer"},
    PointerHint{"Ctrl+click a slider", "Type a value"},
    PointerHint{"Wheel, drag over a plot", "Zoom and move along its time"},
    PointerHint{"Double click on a plot", "Show it from the start"},
    PointerHint{"Drag an edge of a panel", "Make it larger or smaller"},
    PointerHint{"Drop a file", "Open a model or a session"},
};

}  // namespace

std::span<const Shortcut> shortcutTable() {
    return kShortcuts;
}

std::span<const PointerHint> pointerTable() {
    return kPointerHints;
}

std::optional<ActionId> findAction(Key key, Modifiers modifiers) {
    for (const Shortcut& row : kShortcuts) {
        if (row.key == key && row.modifiers == modifiers) {
            return row.id;
        }
    }
    return std::nullopt;
}

const Shortcut& shortcutOf(ActionId id) {
    for (const Shortcut& row : kShortcuts) {
        if (row.id == id) {
            return row;
        }
    }
    assert(false && "every action stands in the shortcut table");
    return kShortcuts.front();
}

std::string keysOf(ActionId id) {
    std::string text;
    for (const Shortcut& row : kShortcuts) {
        if (row.id == id) {
            text += (text.empty() ? "" : ", ") + std::string(row.keyText);
        }
    }
    return text;
}

std::string shortcutsAsMarkdown() {
    std::string text = "| keys | what they do |\n|---|---|\n";
    const auto addRow = [&](std::string_view keys, std::string_view label) {
        text.append("| ").append(keys).append(" | ").append(label).append(" |\n");
    };
    for (const PointerHint& hint : kPointerHints) {
        addRow(hint.gesture, hint.label);
    }
    for (const Shortcut& row : kShortcuts) {
        if (&row == &shortcutOf(row.id)) {
            addRow(keysOf(row.id), row.label);
        }
    }
    return text;
}

std::string describeShortcut(ActionId id) {
    const Shortcut& row = shortcutOf(id);
    return std::string(row.label) + " (" + std::string(row.keyText) + ")";
}

}  // namespace kerf::ui
