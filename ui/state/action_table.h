#pragma once

#include "ui/base/input.h"
#include "ui/base/settings.h"
#include "ui/state/action.h"

namespace kerf::ui {

struct PanelModel;

/// The name of something that a key, a row of a menu or a button asks for, in the order of
/// actionTable(). The handlers in app/editor/editor_actions.cpp do it.
/// What ActionId::remeshCoarser makes of more triangles, about.
constexpr int kFewTriangles = 5000;

enum class ActionId : std::uint8_t {
    newScene,
    openFile,
    addModel,
    reloadModels,
    saveSession,
    saveSessionAs,
    saveTest,
    makeTask,
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
    remeshCoarser,
    partModel,
    deleteSelected,
    firstTool,  ///< one for each ToolKind, see actionOf()
    bringDown = firstTool + kTools,
    freePins,
    link,
    playPause,
    letFall,
    timeWhileCutting,
    stepOnce,
    reset,
    finishTry,
    slower,
    faster,
    record,
    loop,
    addPicture,
    addCheck,
    addExport,
    addCamera,
    addMark,
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
    showAhead,
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
    lightTheme,
    holdPlots,
    fitPlots,
    findCommand,
    help,
    manual,
    about,
    count
};

/// A key with its modifiers for an action; may be none.
struct Shortcut {
    Key key = Key::none;
    Modifiers modifiers;
    std::string_view text;  ///< for display: "Ctrl+O"

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
    Condition on = nullptr;  ///< whether it is on; nullptr for no toggle
    Shortcut second = {};    ///< another key for it
};

/// The keys that actions can be given: letters, digits and F1 to F12.
inline constexpr auto kNamedKeys = [] {
    std::array<Key, static_cast<int>(Key::f12) - static_cast<int>(Key::a) + 1> keys{};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        keys[i] = static_cast<Key>(static_cast<std::size_t>(Key::a) + i);
    }
    return keys;
}();
/// "R" or "F1", of one of them.
std::string nameOf(Key key);
/// The shortcut of a text such as "Ctrl+Shift+R": a letter, a digit or F1 to F12, perhaps with
/// Ctrl, Shift or both. It refers to the text.
std::optional<Shortcut> shortcutOf(std::string_view text);

/// The action that selects a tool.
constexpr ActionId actionOf(ToolKind tool) {
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
                          toRow.template operator()<static_cast<ToolKind>(tool)>()...,
                          others[first + behind]...};
    }
    (std::make_index_sequence<first>{}, std::make_index_sequence<kTools>{},
     std::make_index_sequence<count - first>{});
}

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
/// All actions in the order of the menus.
std::span<const ActionRow> actionTable();
/// Gives actions other keys (see Settings::keys), and all others their own. An action whose new
/// keys are taken has none. Unknown labels have no effect.
void takeKeys(const std::map<std::string, std::string>& keys);

/// A gesture of the pointer and its effect, which the help overlay lists beside the keys.
struct PointerHint {
    std::string gesture;
    std::string_view label;
};
/// All of them, for a mouse scheme.
std::vector<PointerHint> pointerTable(MouseScheme scheme);

/// The row of an action.
inline const ActionRow& rowOf(ActionId id) {
    return actionTable()[static_cast<std::size_t>(id)];
}

/// Whether an action would do something now.
inline bool isAvailable(const PanelModel& model, ActionId id) {
    return rowOf(id).available(model);
}
/// Whether the toggle of an action is on; false for no toggle.
inline bool isOn(const PanelModel& model, ActionId id) {
    return rowOf(id).on != nullptr && rowOf(id).on(model);
}

/// The action of a key, none where the key is free.
std::optional<ActionId> findAction(Key key, Modifiers modifiers);

/// The first key of an action for display: "F1".
inline std::string_view keyOf(ActionId id) {
    return rowOf(id).shortcut.text;
}
/// All keys of an action: "F1, ?".
std::string keysOf(ActionId id);

/// The tables of the pointer and of the keys for docs/editor.md.
std::string actionsAsMarkdown();

/// "Play or pause (Space)", for tooltips.
std::string describeAction(ActionId id);

}  // namespace kerf::ui
