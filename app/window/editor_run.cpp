#include "app/window/editor_run.h"

#include <spdlog/spdlog.h>

#include "app/editor/editor.h"
#include "app/editor/storage/driver_check.h"
#include "app/editor/storage/settings_file.h"
#include "app/journal/journal.h"
#include "app/scene/document/document_loading.h"
#include "app/session/material.h"
#include "app/window/window.h"
#include "gpu/context.h"
#include "gpu/data_path.h"
#include "sim/base/stopwatch.h"

namespace kerf::app {

namespace {

constexpr double kLongestWait = 1;  // between two looks at what the system wants, and at files [s]

EditorOptions optionsFor(const Window& window) {
    const gpu::DeviceInfo device = gpu::queryDevice();
    EditorOptions options;
    options.width = std::max(1, window.width());
    options.height = std::max(1, window.height());
    options.scale = window.scale();
    options.quality = device.software ? render::Quality::light : render::Quality::full;
    options.settingsFile = defaultSettingsFile();
    options.recentFiles = recentFilesStore();
    options.journals = defaultJournalFolder();
    options.storedEnds = defaultStoredEnds();
    options.materials = defaultMaterialFolder();
    options.tries = gpu::userPath("XDG_DATA_HOME", ".local/share", "practice");
    options.driverReports = defaultDriverReports();
    options.driver = device.renderer + " " + device.version;
    options.device = device.renderer.substr(0, device.renderer.find(" ("));
    return options;
}

void openWindow(const std::optional<std::filesystem::path>& file, const std::string& notice = "") {
    Window window("Kerf", SettingsFile(defaultSettingsFile()).now.place);
    EditorOptions options = optionsFor(window);
    options.notice = notice.empty() && options.journals.empty()
                         ? "Autosave is off, since HOME is not set. Save often."
                         : notice;
    Editor editor(options, std::nullopt);
    if (file) {
        editor.open(*file);
    }
    window.onInput([&editor](ui::InputEvent event) { editor.post(std::move(event)); });
    runLoop(window, editor);
    editor.keepPlace(window.place());
    window.onInput(nullptr);
}

/// The same, and again where the driver is reset meanwhile: the new window opens `file`, and
/// offers what the journal has kept of the work. Throws gpu::ContextLost where resets
/// follow each other fast.
void openThroughResets(const std::optional<std::filesystem::path>& file) {
    constexpr double kFast = 10;  // [s]
    std::string notice;
    for (;;) {
        const Stopwatch since;
        try {
            openWindow(file, notice);
            return;
        } catch (const gpu::ContextLost& lost) {
            spdlog::error("{}", lost.what());
            if (!notice.empty() && since.seconds() < kFast) {
                throw;
            }
            notice =
                "The graphics driver was reset, so Kerf restarted. Your work can be recovered.";
        }
    }
}

}  // namespace

void runLoop(Window& window, Editor& editor, const std::function<bool()>& isOver) {
    Stopwatch watch;
    Stopwatch sinceLook;
    while (!editor.closing() && !(isOver && isOver())) {
        window.waitEvents(std::min(editor.idleSeconds() - watch.seconds(), kLongestWait));
        if (sinceLook.seconds() >= kLongestWait) {
            sinceLook.restart();
            editor.lookAtFiles();
        }
        if (window.closing()) {
            window.stayOpen();
            editor.askToLeave();
        }
        const bool damaged = window.takeDamage();
        if (!damaged && (editor.idleSeconds() > watch.seconds() || editor.workOn())) {
            continue;
        }
        editor.resize(window.width(), window.height());
        editor.setScale(window.scale());
        const bool hidden = window.hidden();
        editor.hide(hidden);
        editor.frame(watch.restart());
        window.setTitle(editor.title());
        window.setCursor(editor.cursor());
        if (!hidden) {
            window.show(editor.picture());
        }
    }
}

int runEditor(const std::optional<std::filesystem::path>& file) {
    if (SettingsFile(defaultSettingsFile()).now.softwareRenderer) {
        useSoftwareRenderer();
    }
    std::error_code error;
    if (file && !std::filesystem::is_regular_file(*file, error)) {
        openDocument(*file);  // tells so without a window flashing up
    }
    openThroughResets(file);
    return 0;
}

}  // namespace kerf::app
