#pragma once

#include "ui/base/input.h"
#include "ui/base/theme.h"

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

/// Where the window is on the desktop [px]; unknown without a width. Maximized, it is the place
/// before.
struct WindowPlace {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    bool maximized = false;
    bool operator==(const WindowPlace&) const = default;
};

/// The user's preferences for the window: kept in a file by the editor
/// (app/editor/storage/settings_file.h), never part of a session. Lengths hold at scale 1 (96 dpi).
struct Settings {
    static constexpr double kLeastWidth = 230;  ///< of a side panel [px]
    static constexpr double kMostWidth = 640;

    Theme theme = Theme::dark;
    MouseScheme mouse = MouseScheme::kerf;
    WindowPlace place;
    double uiScale = 1;  ///< over the display's own
    bool showControls = true;
    bool showReadings = true;
    bool timeRunsWhileCutting = false;  ///< in a pause; it stands otherwise
    bool keepsJournal = true;           ///< for recovery after a crash
    bool showExpert = true;             ///< of a task: the expert's blade
    bool showLastTry = true;            ///< of a task: one's own path before
    bool softwareRenderer = false;      ///< draws and computes on the CPU, from the next start on
    double controlsWidth = 300;         ///< of the left panel [px]
    double readingsWidth = 300;         ///< of the right panel [px]
    double piecesShare = 0.2;           ///< of the left panel's height
    double plotsShare = 0.62;           ///< of the right panel's height
    std::vector<std::string> plots{"frames", "volume"};  ///< ids, in the order of kPlots
    /// Ids of the collapsed sections of the left panel.
    std::vector<std::string> folded{"experiments", "model", "display", "cuts", "window"};

    std::string person;  ///< who practises; may be empty
    /// Those last used for "open", "sessions", "exports", "videos" and "materials".
    std::map<std::string, std::string> folders;
    /// The keys that the user gave actions: by their labels, such as "Ctrl+Shift+R".
    std::map<std::string, std::string> keys;

    bool operator==(const Settings&) const = default;
    /// Whether any side panel is shown.
    bool showsPanels() const { return showControls || showReadings; }
};

/// Scales to choose from.
inline constexpr double kUiScales[] = {0.75, 1, 1.25, 1.5, 2, 2.5, 3, 4};

}  // namespace kerf::ui
