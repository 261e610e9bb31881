#include <spdlog/spdlog.h>

#include "app/editor_state.h"
#include "app/file_io.h"
#include "app/free_file.h"

namespace kerf::app {
namespace {

constexpr double kQuietSeconds = 0.3;  // nothing is said of work that is over sooner

}  // namespace

void Editor::State::saveSession() {
    try {
        const std::filesystem::path file =
            freeFile(options.screenshotFolder, scene->document().name, ".kerf.json");
        writeOutputFile(file,
                        formatSession(scene->recordedSession(cameraFlight.destination(camera)),
                                      file.parent_path()));
        spdlog::info("session saved to {}", file.string());
        toast.show("Saved " + file.string(), false);
    } catch (const std::exception& error) {
        toast.show(error.what(), true);
    }
}

void Editor::State::open(const std::filesystem::path& file) {
    cancelLoading();
    loading = std::make_unique<DocumentLoading>(file);
}

/// The scene stays as it is until the new one stands and the hand is free.
void Editor::State::followLoading() {
    std::erase_if(cancelledLoadings, [](const auto& cancelled) { return cancelled->ended(); });
    if (loading == nullptr) {
        return;
    }
    try {
        loading->advance();
        if (loading->ready() && !handIsBusy()) {
            show(loading->take());
            loading.reset();
        }
    } catch (const std::exception& error) {
        spdlog::error("{}", error.what());
        toast.show(error.what(), true);
        loading.reset();
    }
    settlePasses = kSettlePasses;
}

void Editor::State::cancelLoading() {
    if (loading != nullptr) {
        loading->cancel();
        cancelledLoadings.push_back(std::move(loading));
    }
}

ui::WorkState Editor::State::workState() const {
    if (loading == nullptr || loading->seconds() < kQuietSeconds) {
        return {};
    }
    return {"Opening " + loading->file().filename().string(), loading->stage(), loading->seconds()};
}

void Editor::State::show(UploadedDocument uploaded) {
    const std::string note = uploaded.document.note;
    renderer.setRestDepth(uploaded.depth);
    scene = std::make_unique<EditorScene>(std::move(uploaded.document), std::move(uploaded.body));
    landCamera();
    camera = scene->document().camera;
    hand.fitTo(scene->bounds());
    bodyHand = {};
    cameraControl.releaseAll();
    strokedOnce = false;
    pieceDisplay.clear();
    plotView = {};
    sceneChanged = true;
    clock.stop();
    if (!note.empty()) {
        spdlog::info("{}: {}", scene->document().name, note);
        toast.show(note, false);
    }
}

void Editor::State::saveScreenshot() {
    screenshotWanted = false;
    try {
        const std::filesystem::path file = freeFile(options.screenshotFolder, "kerf", ".png");
        render::writePng({options.width, options.height, picture.readColor()}, file);
        spdlog::info("screenshot saved to {}", file.string());
        toast.show("Saved " + file.string(), false);
    } catch (const std::exception& error) {
        toast.show(error.what(), true);
    }
}

}  // namespace kerf::app
