#pragma once

#include <array>
#include <span>
#include <string_view>

#include "ui/base/input.h"

namespace kerf::ui {

/// How the mouse turns and moves the view: Kerf's way, or that of other programs.
enum class MouseScheme { kerf, blender, cad };
inline constexpr int kMouseSchemes = 3;

/// What a drag does to the view.
enum class ViewMotion { none, orbit, pan, zoom };

/// A drag that moves the view, while at least these modifiers are held.
struct ViewDrag {
    ViewMotion motion;
    Button button;
    Modifiers with;
    std::string_view name;  ///< "Shift+right drag"
};

struct MouseSchemeRow {
    std::string_view id;     ///< in the file of settings
    std::string_view label;  ///< for its button
    std::span<const ViewDrag> drags;
};

// The first drag that fits counts.
inline constexpr std::array kDragsOfKerf{
    ViewDrag{ViewMotion::pan, Button::middle, {}, "Middle drag"},
    ViewDrag{ViewMotion::pan, Button::right, {.shift = true}, "Shift+right drag"},
    ViewDrag{ViewMotion::orbit, Button::right, {}, "Right drag"},
    ViewDrag{ViewMotion::orbit, Button::left, {.alt = true}, "Alt+left drag"},
};
inline constexpr std::array kDragsOfBlender{
    ViewDrag{ViewMotion::pan, Button::middle, {.shift = true}, "Shift+middle drag"},
    ViewDrag{ViewMotion::zoom, Button::middle, {.control = true}, "Ctrl+middle drag"},
    ViewDrag{ViewMotion::orbit, Button::middle, {}, "Middle drag"},
    ViewDrag{ViewMotion::orbit, Button::left, {.alt = true}, "Alt+left drag"},
};
inline constexpr std::array kDragsOfCad{
    ViewDrag{ViewMotion::pan, Button::middle, {.control = true}, "Ctrl+middle drag"},
    ViewDrag{ViewMotion::zoom, Button::middle, {.shift = true}, "Shift+middle drag"},
    ViewDrag{ViewMotion::orbit, Button::middle, {}, "Middle drag"},
    ViewDrag{ViewMotion::orbit, Button::left, {.alt = true}, "Alt+left drag"},
};

inline constexpr std::array<MouseSchemeRow, kMouseSchemes> kMouseTable{
    MouseSchemeRow{"kerf", "Kerf", kDragsOfKerf},
    MouseSchemeRow{"blender", "Blender", kDragsOfBlender},
    MouseSchemeRow{"cad", "CAD", kDragsOfCad},
};

constexpr const MouseSchemeRow& rowOf(MouseScheme scheme) {
    return kMouseTable[static_cast<std::size_t>(scheme)];
}

/// The motion begun by a press of this button; none if it belongs to a tool.
constexpr ViewMotion motionOf(MouseScheme scheme, Button button, const Modifiers& held) {
    for (const ViewDrag& drag : rowOf(scheme).drags) {
        const bool fits = (held.shift || !drag.with.shift) &&
                          (held.control || !drag.with.control) && (held.alt || !drag.with.alt);
        if (drag.button == button && fits) {
            return drag.motion;
        }
    }
    return ViewMotion::none;
}

}  // namespace kerf::ui
