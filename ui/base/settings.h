#pragma once

#include <map>
#include <string>
#include <vector>

#include "ui/base/mouse_scheme.h"
#include "ui/base/theme.h"

namespace kerf::ui {

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

    bool operator==(const Settings&) const = default;
    /// Whether any side panel is shown.
    bool showsPanels() const { return showControls || showReadings; }
};

/// Scales to choose from.
inline constexpr double kUiScales[] = {0.75, 1, 1.25, 1.5, 2, 2.5, 3, 4};

}  // namespace kerf::ui
