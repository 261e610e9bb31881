#pragma once

#include <filesystem>
#include <string>

#include "render/renderer.h"

namespace kerf::app {

/// The surroundings of an editor, given by its window or its test.
struct EditorOptions {
    int width = 1280;  ///< of the picture [px]
    int height = 720;
    float scale = 1;  ///< of the display, 1 = 96 dpi
    render::Quality quality = render::Quality::full;
    std::string device;  ///< what draws, for the status bar
    /// Time runs by the clock where it can; otherwise every picture is one step, for tests.
    bool byTheClock = true;
    /// Each frame is drawn; otherwise only those that are read, for tests.
    bool drawsAll = true;
    /// By the clock, a picture is drawn whenever a step has taken so long [s].
    double portion = 0.03;
    /// Kernels are compiled while nobody does anything, before somebody waits for them.
    bool warmsUp = false;
    /// The folder of pictures, in which files are looked for first as well.
    std::filesystem::path screenshotFolder = ".";
    /// The file of the person's settings; empty keeps none, as in tests.
    std::filesystem::path settingsFile;
    std::filesystem::path recentFiles;  ///< see RecentFiles; empty keeps none
    std::filesystem::path journals;     ///< the folder of journals; empty keeps none
    std::filesystem::path materials;    ///< the folder of the person's own; empty for none
    /// The folder of reports on drivers; empty: none is examined.
    std::filesystem::path driverReports;
    std::string driver;  ///< all that the driver says of itself
    std::string notice;  ///< a sentence that is shown at first; empty for none
};

}  // namespace kerf::app
