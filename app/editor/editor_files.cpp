#include <spdlog/spdlog.h>

#include "app/editor/editor_state.h"
#include "app/files/file_io.h"
#include "app/files/free_file.h"
#include "sim/base/text.h"
#include "ui/action_table.h"

namespace kerf::app {
namespace {

/// The choices of beginTest().
enum PictureChoice { kAddPicture, kNoPicture, kCancel };

constexpr double kQuietSeconds = 0.3;  // nothing is said of work that is over sooner

}  // namespace

void Editor::State::saveSession(const std::filesystem::path& file) {
    if (startsSaving()) {
        saving = startSaving(file,
                             scene->savedSession(cameraFlight.destination(camera), display.colors));
    }
}

void Editor::State::saveRecording() {
    saveSession(freeFile(options.screenshotFolder, scene->document().name, ".kerf.json"));
}

/// A test without a picture is one too, but it can't show what has changed.
void Editor::State::beginTest() {
    testGetsPicture = false;
    if (scene->takesPictures()) {
        browse(ui::FilePurpose::saveTest);
        return;
    }
    asked = {{"The session takes no picture yet",
              "A test compares the states, counts and volumes of its session, and its pictures.",
              {"Add a picture of the end", "Go without", "Cancel"}},
             [this](int choice) {
                 if (choice != kCancel) {
                     testGetsPicture = choice == kAddPicture;
                     browse(ui::FilePurpose::saveTest);
                 }
             }};
}

void Editor::State::saveTest(const std::filesystem::path& file) {
    if (!startsSaving()) {
        return;
    }
    if (testGetsPicture) {
        scene->addPicture(scene->end());
    }
    saving = startSavingTest(
        file, scene->savedSession(cameraFlight.destination(camera), display.colors, SavedAs::test));
}

void Editor::State::exportBody(const std::filesystem::path& file, bool filePerPiece) {
    if (startsSaving()) {
        saving = startExport({file, filePerPiece}, scene->document(), scene->simulation());
    }
}

/// One file after the other.
bool Editor::State::startsSaving() {
    if (saving != nullptr) {
        toast.show(saving->title + " is not done yet; save again after it.", true);
    }
    return scene != nullptr && saving == nullptr;
}

void Editor::State::open(const std::filesystem::path& file, bool fillHoles) {
    cancelLoading();
    asked.reset();
    loading = std::make_unique<DocumentLoading>(file, fillHoles);
}

void Editor::State::followWork() {
    followLoading();
    followSaving();
    followSavings();
    followPreview();
}

/// The scene stays as it is until the new one stands and the hand is free.
void Editor::State::followLoading() {
    std::erase_if(cancelledLoadings, [](const auto& cancelled) { return cancelled->ended(); });
    if (loading == nullptr) {
        return;
    }
    settleUpdates = kSettleUpdates;
    try {
        loading->advance();
        if (loading->ready() && !toolIsBusy()) {
            show(loading->take());
            recent.add(loading->file());
            loading.reset();
        }
    } catch (const ModelFault& found) {
        spdlog::error("{}", found.what());
        askAboutHoles(found);
        loading.reset();
    } catch (const std::exception& error) {
        spdlog::error("{}", error.what());
        toast.show(error.what(), true);
        loading.reset();
    }
}

/// Only what would really help is offered.
void Editor::State::askAboutHoles(const ModelFault& found) {
    if (found.fillableHoles() == 0) {
        toast.show(found.what(), true);
        return;
    }
    std::string sentence = found.what();
    if (const std::string whole = loading->file().string(); sentence.starts_with(whole)) {
        sentence.replace(0, whole.size(), loading->file().filename().string());
    }
    const std::string holes = counted(found.fillableHoles(), "hole", "holes");
    asked = {{"This model can't be cut as it is",
              sentence.substr(0, sentence.find(';')) + ". Filling " + holes +
                  " would close it; the file stays as it is.",
              {"Fill " + holes, "Cancel"}},
             [this, file = loading->file()](int choice) {
                 if (choice == 0) {
                     open(file, true);
                 }
             }};
}

void Editor::State::followSaving() {
    std::erase_if(cancelledSavings, [](const auto& cancelled) { return cancelled->job.done(); });
    if (saving == nullptr || !saving->job.done()) {
        return;
    }
    settleUpdates = kSettleUpdates;
    try {
        const std::string sentence = saving->job.take();
        spdlog::info("{}", sentence);
        toast.show(sentence, false);
    } catch (const std::exception& error) {
        toast.show(error.what(), true);
    }
    saving.reset();
}

void Editor::State::cancelWork() {
    if (loading != nullptr) {
        cancelLoading();
    } else if (saving != nullptr) {
        saving->job.cancel();
        cancelledSavings.push_back(std::move(saving));
    }
}

void Editor::State::cancelLoading() {
    if (loading != nullptr) {
        loading->cancel();
        cancelledLoadings.push_back(std::move(loading));
    }
}

ui::WorkState Editor::State::workState() const {
    ui::WorkState work;
    if (loading != nullptr) {
        work = {"Opening " + loading->file().filename().string(), loading->stage(),
                loading->seconds()};
    } else if (saving != nullptr) {
        work = {saving->title, saving->job.stage(), saving->job.seconds()};
    }
    return work.seconds < kQuietSeconds ? ui::WorkState{} : work;
}

void Editor::State::show(UploadedDocument uploaded) {
    const std::string note = uploaded.document.note;
    // Either may fail for want of memory; what is open stays then.
    auto next =
        std::make_unique<EditorScene>(std::move(uploaded.document), std::move(uploaded.body));
    renderer.setRestDepth(uploaded.depth);
    scene = std::move(next);
    pictureOffer.reset();
    landCamera();
    camera = scene->document().camera;
    display.colors = scene->document().session.colors;
    bladeTool.fitTo(scene->bounds());
    pullTool = {};
    cameraControl.releaseAll();
    cutWatch = {};
    display.apart = 0;
    pieceDisplay.clear();
    plotView = {};
    sceneChanged = true;
    clock.stop();
    if (!note.empty()) {
        spdlog::info("{}: {}", scene->document().name, note);
        toast.show(note, false);
    }
}

void Editor::State::followSavings() {
    for (const SavingQueue::Outcome& outcome : savings.takeOutcomes()) {
        settleUpdates = kSettleUpdates;
        if (outcome.failed) {
            spdlog::error("{}", outcome.sentence);
        } else {
            spdlog::info("{}", outcome.sentence);
        }
        tellOfSaving(outcome);
    }
}

void Editor::State::tellOfSaving(const SavingQueue::Outcome& outcome) {
    if (pictureOffer && pictureOffer->saving == outcome.number && !outcome.failed) {
        toast.offer(outcome.sentence, {ui::ActionId::addPicture, "Add to the session"});
    } else {
        toast.show(outcome.sentence, outcome.failed);
    }
}

void Editor::State::saveScreenshot() {
    screenshotWanted = false;
    const int number = savePicture({options.width, options.height, picture.readColor()}, "kerf");
    if (scene != nullptr && scene->recording()) {
        pictureOffer = {scene->here(), number};
    }
}

void Editor::State::saveSceneScreenshot() {
    render::SceneView view = sceneToDraw();
    view.transparent = true;
    renderer.draw(view, camera, options.width, options.height);
    render::Image image = renderer.readPicture();
    render::divideByAlpha(image);
    savePicture(std::move(image), "kerf-scene");
}

int Editor::State::savePicture(render::Image image, const std::string& name) {
    return savings.add([image = std::move(image), name, folder = options.screenshotFolder] {
        const std::filesystem::path file = freeFile(folder, name, ".png");
        writePicture(image, file);
        return "Saved " + file.string();
    });
}

}  // namespace kerf::app
