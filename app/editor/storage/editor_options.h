#pragma once

#include "render/renderer.h"

namespace kerf::app {

/// The surroundings of an editor, given by its window or its test.
struct EditorOptions {
    int width = 1280;  ///< of the picture [px]
    int height = 720;
    float scale = 1;  ///< of the display, 1 = 96 dpi
    render::Quality quality = render::Quality::full;
    std::string device;  ///< what draws, for the status bar
    /// Time follows the clock if possible; otherwise every frame is one step, for tests.
    bool byTheClock = true;
    /// Draws each frame; otherwise only those that are read, for tests.
    bool drawsAll = true;
    /// By the clock, a frame is drawn whenever a step has taken so long [s].
    double portion = 0.03;
    /// A large model is offered with fewer triangles if its steps are expected to take longer [s].
    double slowStep = 1;
    /// The folder of pictures, and the first one of the file dialog.
    std::filesystem::path screenshotFolder = ".";
    /// The file of the person's settings; empty keeps none, as in tests.
    std::filesystem::path settingsFile;
    std::filesystem::path recentFiles;  ///< see RecentFiles; empty keeps none
    std::filesystem::path journals;     ///< the folder of journals; empty keeps none
    std::filesystem::path storedEnds;   ///< see StoredEnds; empty keeps none
    std::filesystem::path materials;    ///< the folder of the user's own; empty for none
    std::filesystem::path tries;        ///< the folder of tries of tasks; empty keeps none
    /// The folder of reports on drivers; empty: none is examined.
    std::filesystem::path driverReports;
    std::string link = "127.0.0.1:18944";  ///< where SceneLink listens once it is switched on
    std::string driver;                    ///< full name of the driver
    std::string notice;                    ///< a sentence shown at the start; empty for none
};

}  // namespace kerf::app
