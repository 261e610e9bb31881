#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/action.h"
#include "ui/input.h"
#include "ui/mouse_scheme.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// The name of something that a key, a row of a menu or a button asks for, in the order of
/// kActions. The handlers in app/editor/editor_actions.cpp do it.
enum class ActionId : std::uint8_t {
    openFile,
    addModel,
    saveSession,
    saveTest,
    exportBody,
    makeFilm,
    screenshot,
    sceneScreenshot,
    quit,
    undo,
    redo,
    cancel,
    toggleGravity,
    remesh,
    partModel,
    firstTool,  ///< one for each Tool, see actionOf()
    bringDown = firstTool + kTools,
    freePins,
    removeRetractor,
    playPause,
    letFall,
    timeWhileCutting,
    stepOnce,
    reset,
    slower,
    faster,
    record,
    loop,
    addPicture,
    addCheck,
    addExport,
    addCamera,
    useView,
    frameBody,
    resetView,
    viewFront,
    viewBack,
    viewRight,
    viewLeft,
    viewTop,
    viewBottom,
    orthographic,
    wireframe,
    showCutLines,
    showApart,
    showEdges,
    showBends,
    showIspcs,
    showErrors,
    showContacts,
    showBoxes,
    nextField,
    section,
    fineQuality,
    togglePanels,
    holdPlots,
    fitPlots,
    help,
    count
};

/// A key with its modifiers that asks for an action; no key where there is none.
struct Shortcut {
    Key key = Key::none;
    Modifiers modifiers;
    std::string_view text;  ///< as people read it: "Ctrl+O"

    bool presses(Key other, const Modifiers& with) const {
        return key != Key::none && key == other && modifiers == with;
    }
};

/// One row of the table that dispatch, menus, buttons, the help overlay and the docs share.
struct ActionRow {
    using Condition = bool (*)(const PanelModel&);

    ActionId id = ActionId::count;
    Shortcut shortcut;
    std::string_view label;  ///< what it does: "Play or pause"
    std::string_view group;  ///< its menu, and its heading in the help
    Condition available;     ///< whether it would do something now
    Condition on = nullptr;  ///< whether it is on; nullptr where it switches nothing
    Shortcut second = {};    ///< another key that does it too
};

// The words of the rows.
inline constexpr Modifiers kPlain{};
inline constexpr Modifiers kShift{.shift = true};
inline constexpr Modifiers kControl{.control = true};
inline constexpr Modifiers kControlShift{.shift = true, .control = true};

constexpr Shortcut at(Key key, const Modifiers& modifiers, std::string_view text) {
    return {key, modifiers, text};
}
constexpr bool always(const PanelModel& /*model*/) {
    return true;
}
inline bool withBody(const PanelModel& model) {
    return !model.name.empty();
}
template <Tool tool>
bool holds(const PanelModel& model) {
    return model.tools.tool == tool;
}
template <bool DisplaySettings::*member>
bool shows(const PanelModel& model) {
    return model.display.*member;
}
template <bool render::Overlays::*member>
bool draws(const PanelModel& model) {
    return model.display.overlays.*member;
}

/// The action that takes a tool.
constexpr ActionId actionOf(Tool tool) {
    return static_cast<ActionId>(static_cast<int>(ActionId::firstTool) + static_cast<int>(tool));
}
/// Rows in the order of ActionId: `others`, and among them what `toRow` makes for each tool.
template <class Row, std::size_t count, class ToRow>
constexpr auto withTools(const std::array<Row, count>& others, ToRow toRow) {
    constexpr auto first = static_cast<std::size_t>(ActionId::firstTool);
    return [&]<std::size_t... before, std::size_t... tool, std::size_t... behind>(
        std::index_sequence<before...>, std::index_sequence<tool...>,
        std::index_sequence<behind...>) {
        return std::array{others[before]...,
                          toRow.template operator()<static_cast<Tool>(tool)>()...,
                          others[first + behind]...};
    }
    (std::make_index_sequence<first>{}, std::make_index_sequence<kTools>{},
     std::make_index_sequence<count - first>{});
}

/// All actions but those that take a tool, in the order of the menus.
inline constexpr std::array kOtherActions{
    ActionRow{ActionId::openFile, at(Key::o, kControl, "Ctrl+O"), "Open a model or a session...",
              "File", always},
    ActionRow{ActionId::addModel, at(Key::o, kControlShift, "Ctrl+Shift+O"),
              "Add a model to the scene...", "File", withBody},
    ActionRow{ActionId::saveSession, at(Key::s, kControl, "Ctrl+S"), "Save all since the start...",
              "File", withBody},
    ActionRow{ActionId::saveTest, at(Key::t, kControl, "Ctrl+T"), "Save as a test...", "File",
              withBody},
    ActionRow{ActionId::exportBody, at(Key::e, kControl, "Ctrl+E"), "Export the body...", "File",
              withBody},
    ActionRow{ActionId::makeFilm, at(Key::m, kControl, "Ctrl+M"),
              "Make a film of all since the start...", "File", withBody},
    ActionRow{ActionId::screenshot, at(Key::f12, kPlain, "F12"), "Save a screenshot here", "File",
              always},
    ActionRow{ActionId::sceneScreenshot, at(Key::f12, kControl, "Ctrl+F12"),
              "Save the scene alone, on no ground", "File", withBody},
    ActionRow{ActionId::quit, at(Key::q, kControl, "Ctrl+Q"), "Leave", "File", always},
    ActionRow{ActionId::undo, at(Key::z, kControl, "Ctrl+Z"), "Undo", "Edit",
              [](const PanelModel& m) { return m.changes.done > 0; }},
    ActionRow{ActionId::redo, at(Key::z, kControlShift, "Ctrl+Shift+Z"), "Redo", "Edit",
              [](const PanelModel& m) { return m.changes.done < m.changes.rows.size(); }, nullptr,
              at(Key::y, kControl, "Ctrl+Y")},
    ActionRow{ActionId::cancel, at(Key::escape, kPlain, "Esc"),
              "Stop the stroke, the loading, close the help", "Edit", withBody},
    ActionRow{ActionId::toggleGravity, at(Key::v, kPlain, "V"), "Gravity on or off", "Edit",
              withBody, [](const PanelModel& m) { return m.parameters.now.gravity.norm() > 0; }},
    ActionRow{ActionId::remesh, at(Key::r, kShift, "Shift+R"), "Remesh: even triangles", "Edit",
              withBody},
    ActionRow{ActionId::partModel, at(Key::o, kShift, "Shift+O"),
              "Part: a model for each object of the file", "Edit",
              [](const PanelModel& m) { return m.model.objects > 1; }},
    ActionRow{
        ActionId::bringDown, at(Key::enter, kPlain, "Enter"), "Bring the guillotine down", "Tool",
        [](const PanelModel& m) { return withBody(m) && !rowOf(m.tools.tool).trigger.empty(); }},
    ActionRow{ActionId::freePins, at(Key::p, kShift, "Shift+P"), "Free all that is pinned", "Tool",
              [](const PanelModel& m) { return m.body.pinned > 0; }},
    ActionRow{ActionId::removeRetractor, at(Key::del, kPlain, "Delete"),
              "Remove the retractor under the pointer, or the last", "Tool",
              [](const PanelModel& m) { return m.body.hooks > 0; }},
    ActionRow{ActionId::playPause, at(Key::space, kPlain, "Space"), "Play or pause", "Time",
              withBody, [](const PanelModel& m) { return m.transport.playing; }},
    ActionRow{ActionId::letFall, at(Key::space, kShift, "Shift+Space"),
              "Let it fall: gravity and time on", "Time", withBody},
    ActionRow{ActionId::timeWhileCutting, at(Key::t, kShift, "Shift+T"),
              "Let time run while cutting in a pause", "Time", always,
              [](const PanelModel& m) { return m.settings.timeRunsWhileCutting; }},
    ActionRow{ActionId::stepOnce, at(Key::period, kPlain, "."), "One step", "Time", withBody},
    ActionRow{ActionId::reset, at(Key::r, kPlain, "R"), "Back to the start", "Time", withBody},
    ActionRow{ActionId::slower, at(Key::minus, kPlain, "-"), "Half as fast", "Time", withBody},
    ActionRow{ActionId::faster, at(Key::equal, kPlain, "="), "Twice as fast", "Time", withBody},
    ActionRow{ActionId::record, at(Key::r, kControl, "Ctrl+R"), "Record from the start, stop",
              "Time", withBody, [](const PanelModel& m) { return m.transport.recording; }},
    ActionRow{ActionId::loop, at(Key::l, kPlain, "L"), "Repeat the session", "Time",
              [](const PanelModel& m) { return m.session.playback.steps > 0; },
              [](const PanelModel& m) { return m.session.playback.loop; }},
    ActionRow{ActionId::addPicture, at(Key::f12, kShift, "Shift+F12"),
              "Add a picture of this step to the session", "Time", withBody},
    ActionRow{ActionId::addCheck, at(Key::c, kShift, "Shift+C"),
              "Add a check of this step to the session", "Time", withBody},
    ActionRow{ActionId::addExport, at(Key::e, kShift, "Shift+E"),
              "Add an export of this step to the session", "Time", withBody},
    ActionRow{ActionId::addCamera, at(Key::m, kShift, "Shift+M"),
              "Let the camera of films be here at this step", "Time", withBody},
    ActionRow{ActionId::useView, at(Key::home, kShift, "Shift+Home"),
              "Use this view for the session's pictures", "Time", withBody},
    ActionRow{ActionId::frameBody, at(Key::f, kPlain, "F"), "Bring the model into view", "View",
              withBody},
    ActionRow{ActionId::resetView, at(Key::home, kPlain, "Home"), "Back to the first view", "View",
              withBody},
    ActionRow{ActionId::viewFront, at(Key::digit1, kPlain, "1"), "From the front", "View",
              withBody},
    ActionRow{ActionId::viewBack, at(Key::digit1, kControl, "Ctrl+1"), "From the back", "View",
              withBody},
    ActionRow{ActionId::viewRight, at(Key::digit3, kPlain, "3"), "From the right", "View",
              withBody},
    ActionRow{ActionId::viewLeft, at(Key::digit3, kControl, "Ctrl+3"), "From the left", "View",
              withBody},
    ActionRow{ActionId::viewTop, at(Key::digit7, kPlain, "7"), "From the top", "View", withBody},
    ActionRow{ActionId::viewBottom, at(Key::digit7, kControl, "Ctrl+7"), "From below", "View",
              withBody},
    ActionRow{ActionId::orthographic, at(Key::digit5, kPlain, "5"), "Without perspective", "View",
              withBody, [](const PanelModel& m) { return m.view.orthographic; }},
    ActionRow{ActionId::wireframe, at(Key::w, kPlain, "W"), "Show the triangles", "View", withBody,
              shows<&DisplaySettings::wireframe>},
    ActionRow{ActionId::showCutLines, at(Key::t, kPlain, "T"), "Show the lines of cuts", "View",
              withBody, shows<&DisplaySettings::cutLines>},
    ActionRow{ActionId::showApart, at(Key::a, kPlain, "A"), "Show the pieces apart", "View",
              [](const PanelModel& m) { return m.pieces.rows.size() > 1; },
              [](const PanelModel& m) { return m.display.apart > 0; }},
    ActionRow{ActionId::showEdges, at(Key::e, kPlain, "E"), "Show the edge constraints", "View",
              withBody, draws<&render::Overlays::edges>},
    ActionRow{ActionId::showBends, at(Key::b, kPlain, "B"), "Show the bending constraints", "View",
              withBody, draws<&render::Overlays::bends>},
    ActionRow{ActionId::showIspcs, at(Key::i, kPlain, "I"), "Show the ISPCs", "View", withBody,
              draws<&render::Overlays::ispcs>},
    ActionRow{ActionId::showErrors, at(Key::x, kPlain, "X"), "Colour them by their error", "View",
              withBody, draws<&render::Overlays::errors>},
    ActionRow{ActionId::showContacts, at(Key::k, kPlain, "K"), "Show the contacts", "View",
              withBody, draws<&render::Overlays::contacts>},
    ActionRow{ActionId::showBoxes, at(Key::o, kPlain, "O"), "Show boxes around the pieces", "View",
              withBody, draws<&render::Overlays::boxes>},
    ActionRow{
        ActionId::nextField, at(Key::j, kPlain, "J"),
        "Colour by the look, strain, area change, thickness in turn", "View", withBody,
        [](const PanelModel& m) { return m.display.field.field != render::SurfaceField::look; }},
    ActionRow{ActionId::section, at(Key::n, kPlain, "N"), "Section plane: look inside", "View",
              withBody, [](const PanelModel& m) { return m.display.section.has_value(); }},
    ActionRow{ActionId::fineQuality, at(Key::q, kPlain, "Q"),
              "Fine picture: soft shadows, smooth edges", "View", withBody,
              [](const PanelModel& m) { return m.display.quality == render::Quality::full; }},
    ActionRow{ActionId::togglePanels, at(Key::tab, kPlain, "Tab"), "Panels, or the view alone",
              "View", always, [](const PanelModel& m) { return m.settings.showsPanels(); }},
    ActionRow{ActionId::holdPlots, at(Key::h, kPlain, "H"), "Hold the plots, or follow again",
              "View", withBody, [](const PanelModel& m) { return m.plots.view.end.has_value(); }},
    ActionRow{ActionId::fitPlots, at(Key::h, kShift, "Shift+H"), "Show the plots from the start",
              "View", withBody},
    ActionRow{ActionId::help, at(Key::f1, kPlain, "F1"), "All keys", "Help", always,
              [](const PanelModel& m) { return m.help.open; }, at(Key::questionMark, kPlain, "?")},
};

/// All actions in the order of the menus.
inline constexpr auto kActions = withTools(kOtherActions, []<Tool tool>() {
    const ToolRow& row = rowOf(tool);
    return ActionRow{actionOf(tool), at(row.key, kPlain, row.keyText), row.label, "Tool", withBody,
                     holds<tool>};
});

/// Whether a table has one row for each ActionId, in the same order.
template <class Table>
constexpr bool coversActions(const Table& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].id != static_cast<ActionId>(i)) {
            return false;
        }
    }
    return rows.size() == static_cast<std::size_t>(ActionId::count);
}
static_assert(coversActions(kActions), "an ActionId has no row in kActions, or not at its place");

/// A gesture of the pointer and its effect, which the help overlay lists beside the keys.
struct PointerHint {
    std::string gesture;
    std::string_view label;
};
/// All of them, as the mouse moves the view.
std::vector<PointerHint> pointerTable(MouseScheme scheme);

/// The row of an action.
constexpr const ActionRow& rowOf(ActionId id) {
    return kActions[static_cast<std::size_t>(id)];
}

/// Whether an action would do something now.
inline bool isAvailable(const PanelModel& model, ActionId id) {
    return rowOf(id).available(model);
}
/// Whether the thing that an action switches is on; false where it switches nothing.
inline bool isOn(const PanelModel& model, ActionId id) {
    return rowOf(id).on != nullptr && rowOf(id).on(model);
}

/// The action of a key, none where the key is free.
std::optional<ActionId> findAction(Key key, Modifiers modifiers);

/// The first key of an action as people read it: "F1".
constexpr std::string_view keyOf(ActionId id) {
    return rowOf(id).shortcut.text;
}
/// All keys of an action: "F1, ?".
std::string keysOf(ActionId id);

/// The tables of the pointer and of the keys for docs/editor.md.
std::string actionsAsMarkdown();

/// "Play or pause (Space)", for tooltips.
std::string describeAction(ActionId id);

}  // namespace kerf::ui
