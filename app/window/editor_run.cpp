#include <spdlog/spdlog.h>

#include <algorithm>
#include <string>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/storage/driver_check.h"
#include "app/editor/storage/recent_files.h"
#include "app/editor/storage/settings_file.h"
#include "app/journal/journal_folder.h"
#include "app/scene/document/document_loading.h"
#include "app/session/material.h"
#include "app/session/session.h"
#include "app/window/window.h"
#include "gpu/context.h"
#include "gpu/context_loss.h"
#include "gpu/program_binaries.h"
#include "sim/base/stopwatch.h"

namespace kerf::app {
namespace {

constexpr double kLongestWait = 1;  // between two looks at what the system wants [s]

bool isThere(const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error);
}

/// The document of the command line; without one the editor begins with the start page.
std::optional<Document> firstDocument(const std::optional<std::filesystem::path>& file) {
    if (!file) {
        return std::nullopt;
    }
    Document document = openDocument(*file, editorReading(memoryMeans()));
    RecentFiles(recentFilesStore()).add(*file);
    return document;
}

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
    options.driverReports = defaultDriverReports();
    options.driver = device.renderer + " " + device.version;
    options.warmsUp = true;
    options.device = device.renderer.substr(0, device.renderer.find(" ("));
    return options;
}

/// Draws while something moves, and else waits: a still picture costs nothing.
void runLoop(Window& window, Editor& editor) {
    Stopwatch watch;
    while (!editor.closing()) {
        window.waitEvents(std::min(editor.idleSeconds() - watch.seconds(), kLongestWait));
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
        editor.frame(watch.restart());
        window.setTitle(editor.title());
        window.setCursor(editor.cursor());
        window.show(editor.picture());
    }
}

void openWindow(std::optional<Document> document,
                const std::optional<std::filesystem::path>& stillToOpen,
                const std::string& notice = "") {
    Window window("Kerf", SettingsFile(defaultSettingsFile()).now.place);
    gpu::ProgramBinaries::ours() = {gpu::programBinariesFolder(), KERF_VERSION};
    EditorOptions options = optionsFor(window);
    options.notice = notice;
    Editor editor(options, std::move(document));
    if (stillToOpen) {
        editor.open(*stillToOpen);
    }
    window.onInput([&editor](ui::InputEvent event) { editor.post(std::move(event)); });
    runLoop(window, editor);
    editor.keepPlace(window.place());
    window.onInput(nullptr);
}

/// The same, and again where the driver is reset meanwhile: the new window opens `file`, and
/// offers what the journal has kept of the work. Throws gpu::ContextLost where resets
/// follow each other fast.
void openThroughResets(std::optional<Document> document,
                       std::optional<std::filesystem::path> stillToOpen,
                       const std::optional<std::filesystem::path>& file) {
    constexpr double kFast = 10;  // [s]
    std::string notice;
    for (;;) {
        const Stopwatch since;
        try {
            openWindow(std::move(document), stillToOpen, notice);
            return;
        } catch (const gpu::ContextLost& lost) {
            spdlog::error("{}", lost.what());
            if (!notice.empty() && since.seconds() < kFast) {
                throw;
            }
            notice = "The graphics driver was reset. Kerf has begun anew, and offers what it kept.";
            document.reset();
            stillToOpen = file;
        }
    }
}

}  // namespace

int runEditor(const std::optional<std::filesystem::path>& file) {
    if (SettingsFile(defaultSettingsFile()).now.softwareRenderer) {
        useSoftwareRenderer();
    }
    if (file && takesLong(*file)) {
        openThroughResets(std::nullopt, file, file);
        return 0;
    }
    std::optional<Document> document;
    try {
        document = firstDocument(file);
    } catch (const InputError&) {
        if (!file || !isThere(*file)) {
            throw;  // a missing file is told without a window flashing up
        }
    } catch (const MemoryShortage&) {
        document.reset();  // the window tells
    }
    // In the window a file that can't be opened is told again, with what can be done about it.
    const bool failed = !document && file;
    openThroughResets(std::move(document), failed ? file : std::nullopt, file);
    return 0;
}

}  // namespace kerf::app
