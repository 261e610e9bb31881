#include "app/editor/editor.h"

#include "app/editor/editor_state.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

constexpr double kForever = 1e9;     // [s]
constexpr double kWorkPause = 0.05;  // between two pictures while a thread works [s]

}  // namespace

Editor::Editor(const EditorOptions& options, std::optional<Document> document)
    : state_(std::make_unique<State>(options)) {
    if (document) {
        state_->show(UploadedDocument(prepareDocument(std::move(*document))));
    }
    if (const std::string& problem = state_->settingsFile.problem(); !problem.empty()) {
        state_->toast.show(problem, true);
    }
    state_->describe(true);
}

Editor::~Editor() {
    if (state_->saving != nullptr) {
        state_->saving->job.wait();  // What was to be saved is saved.
    }
    state_->savings.finish();
}

void Editor::post(ui::InputEvent event) {
    state_->queue.push(std::move(event));
}

void Editor::resize(int width, int height) {
    const bool same = width == state_->options.width && height == state_->options.height;
    if (width > 0 && height > 0 && !same) {
        state_->options.width = width;
        state_->options.height = height;
        state_->settleUpdates = kSettleUpdates;
    }
}

void Editor::setScale(float scale) {
    if (scale != state_->options.scale) {
        state_->options.scale = scale;
        state_->settleUpdates = kSettleUpdates;
    }
}

void Editor::frame(double elapsedSeconds) {
    State& s = *state_;
    s.toast.elapse(elapsedSeconds);
    s.takeInput(elapsedSeconds);
    s.sceneChanged |= s.cameraFlight.advance(s.camera, elapsedSeconds);
    s.followWork();
    s.followFirstSteps();
    s.advance(elapsedSeconds);
    s.draw();
    if (s.screenshotWanted) {
        s.saveScreenshot();
    }
    s.keepSettings();
}

double Editor::idleSeconds() const {
    const State& s = *state_;
    if (!s.queue.empty() || s.running() || s.sceneChanged || s.settleUpdates > 0 ||
        s.cameraFlight.flying()) {
        return 0;
    }
    if (s.isWorking() || s.savings.busy() || s.preview.working()) {
        return s.loading != nullptr && !s.loading->preparing() ? 0 : kWorkPause;
    }
    return s.toast.visible() ? s.toast.steadySeconds() : kForever;
}

bool Editor::working() const {
    return state_->isWorking() || state_->savings.busy();
}

bool Editor::closing() const {
    return state_->closing && state_->saving == nullptr && !state_->savings.busy();
}

const gpu::Framebuffer& Editor::picture() const {
    return state_->picture;
}

render::Image Editor::readPicture() const {
    const gpu::Framebuffer& picture = state_->picture;
    return {picture.width(), picture.height(), picture.readColor()};
}

std::string Editor::title() const {
    if (state_->scene == nullptr) {
        return "Kerf";
    }
    return "Kerf - " + state_->scene->document().name + " - " +
           counted(state_->scene->pieceCount(), "piece", "pieces");
}

const ui::PanelModel& Editor::panels() const {
    return state_->model;
}

const ui::ItemRects& Editor::itemRects() const {
    return state_->interface.itemRects();
}

EditorScene* Editor::scene() {
    return state_->scene.get();
}

void Editor::open(const std::filesystem::path& file) {
    state_->open(file);
}

}  // namespace kerf::app
