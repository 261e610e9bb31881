#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ui/action.h"
#include "ui/input.h"

namespace kerf::ui {

/// One row of the table that dispatch, buttons, the help overlay and the docs share.
struct Shortcut {
    ActionId id = ActionId::playPause;
    Key key = Key::none;
    Modifiers modifiers;
    std::string_view keyText;  ///< as people read it: "Space"
    std::string_view label;    ///< what it does: "Play or pause"
    std::string_view group;    ///< its menu, and its heading in the help
};

/// What the pointer does in the view; the help overlay lists it beside the keys.
struct PointerHint {
    std::string_view gesture;
    std::string_view label;
};

/// An action may stand more than once (F1 and ? both open the help); a key with its modifiers
/// stands once.
std::span<const Shortcut> shortcutTable();
std::span<const PointerHint> pointerTable();

/// The action of a key, none where the key is free.
std::optional<ActionId> findAction(Key key, Modifiers modifiers);

/// The first row of an action; every action has one.
const Shortcut& shortcutOf(ActionId id);

/// All keys of an action: "F1, ?".
std::string keysOf(ActionId id);

/// Both tables for docs/editor.md.
std::string shortcutsAsMarkdown();

/// "Play or pause (Space)", for tooltips.
std::string describeShortcut(ActionId id);

}  // namespace kerf::ui
