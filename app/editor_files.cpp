#include <spdlog/spdlog.h>

#include <ctime>

#include "app/editor_state.h"
#include "app/file_io.h"

namespace kerf::app {
namespace {

constexpr double kQuietSeconds = 0.3;  // nothing is said of work that is over sooner

/// NAME-YYYYMMDD-HHMMSS with an ending, numbered where that is taken.
std::filesystem::path freeFile(const std::filesystem::path& folder, const std::string& name,
                               const std::string& ending) {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    char moment[32];
    std::strftime(moment, sizeof moment, "-%Y%m%d-%H%M%S", &local);
    const std::string stem = name + moment;
    std::filesystem::path file = folder / (stem + ending);
    for (int n = 2; std::filesystem::exists(file); ++n) {
        file = folder / (stem + "-" + std::to_string(n) + ending);
    }
    return std::filesystem::absolute(file).lexically_normal();
}

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
