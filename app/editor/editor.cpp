#include "app/editor/editor.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "app/editor/editor_state.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

constexpr double kForever = 1e9;     // [s]
constexpr double kWorkPause = 0.05;  // between two pictures while a thread works [s]
constexpr int kMostSeekSteps = 64;   // per picture, while they are fast

}  // namespace

Editor::Editor(const EditorOptions& options, std::optional<Document> document)
    : state_(std::make_unique<State>(options)) {
    if (document) {
        state_->show(UploadedDocument(prepareDocument(std::move(*document))));
    }
    if (const std::string& problem = state_->panels.settings.problem(); !problem.empty()) {
        state_->toast.show(problem, true);
    }
    state_->describe(true);
}

Editor::~Editor() = default;

void Editor::post(ui::InputEvent event) {
    state_->queue.push(std::move(event));
}

void Editor::resize(int width, int height) {
    if (state_->view.resize(width, height)) {
        state_->redraw.panels();
    }
}

void Editor::setScale(float scale) {
    if (std::exchange(state_->panels.displayScale, scale) != scale) {
        state_->redraw.panels();
    }
}

void Editor::frame(double elapsedSeconds) {
    State& s = *state_;
    s.toast.elapse(elapsedSeconds);
    s.takeInput(elapsedSeconds);
    s.view.camera.advance(elapsedSeconds);
    s.followFiles();
    if (s.scene != nullptr && s.guide.follow(*s.scene, s.view)) {
        s.redraw.panels();
    }
    s.advance(elapsedSeconds);
    s.picture.draw(s.scene.get(), s.view, s.panels.covered(s.view.width, s.view.height),
                   s.redraw.takeScene());
    s.panels.interface.draw(s.picture.target());
    s.saveScreenshot();
    s.keepSettings();
    s.prepareKernels(elapsedSeconds);
}

double Editor::idleSeconds() const {
    const State& s = *state_;
    const bool runs = s.scene != nullptr && s.scene->running();
    if (!s.queue.empty() || runs || s.redraw.pending() || s.view.camera.flying()) {
        return 0;
    }
    if (const DocumentLoading* opening = s.work.opening()) {
        return opening->preparing() ? kWorkPause : 0;
    }
    if (s.work.saves() || s.chooser.previews()) {
        return kWorkPause;
    }
    const double rest = s.kernels.left() ? kWorkPause : kForever;
    return s.toast.visible() ? std::min(rest, s.toast.steadySeconds()) : rest;
}

bool Editor::working() const {
    return state_->work.opening() != nullptr || state_->work.saves();
}

bool Editor::closing() const {
    return state_->closing && !state_->work.saves();
}

const gpu::Framebuffer& Editor::picture() const {
    return state_->picture.target();
}

render::Image Editor::readPicture() const {
    return state_->picture.read();
}

ui::Cursor Editor::cursor() const {
    const State& s = *state_;
    if (s.panels.interface.ownsPointer()) {
        return s.panels.interface.cursor();
    }
    return s.scene == nullptr ? ui::Cursor::arrow : s.view.cursor(s.panels.model.overlay);
}

std::string Editor::title() const {
    const EditorScene* const scene = state_->scene.get();
    return scene == nullptr ? "Kerf"
                            : "Kerf - " + scene->document().name + " - " +
                                  counted(scene->pieceCount(), "piece", "pieces");
}

const ui::PanelModel& Editor::panels() const {
    return state_->panels.model;
}

const ui::ItemRects& Editor::itemRects() const {
    return state_->panels.interface.itemRects();
}

EditorScene* Editor::scene() {
    return state_->scene.get();
}

void Editor::open(const std::filesystem::path& file) {
    state_->open(file);
}

// --- A picture ---------------------------------------------------------------------------------

void Editor::State::advance(double elapsedSeconds) {
    const bool ran = scene != nullptr && scene->running();
    if (ran) {
        view.display.join();
        const bool playing = scene->playing || scene->pulling();
        const double timeStep = scene->simulation().params().timeStep;
        const int due = playing ? clock.takeDue(elapsedSeconds, timeStep) : 0;
        runSteps(scene->strokeSteps(), std::max(due, std::min(scene->seekSteps(), kMostSeekSteps)));
    }
    const double renderMs = picture.takeSceneMilliseconds();
    if (clock.measure(elapsedSeconds, ran)) {
        scene->recordPicture(elapsedSeconds, renderMs);
        experiments.note(*scene);
    }
}

void Editor::State::runSteps(int needed, int due) {
    clock.run(*scene, needed, due);
    redraw.scene();
    for (const std::string& message : scene->takeMessages()) {
        spdlog::warn("{}", message);
        toast.show(message, false);
    }
}

void Editor::State::saveScreenshot() {
    if (std::exchange(screenshotWanted, false)) {
        const int number = savePicture(picture.read(), "kerf");
        if (scene != nullptr && scene->recording()) {
            toast.offerOnceSaved(scene->here(), number);
        }
    }
}

void Editor::State::prepareKernels(double elapsedSeconds) {
    if (scene == nullptr || scene->running() || !queue.empty() || view.camera.dragging() ||
        work.opening() != nullptr || panels.interface.isDragging()) {
        kernels.interrupt();
    } else {
        kernels.advance(*scene, elapsedSeconds);
    }
}

void Editor::State::keepSettings() {
    const std::string problem = panels.interface.isDragging() ? "" : panels.settings.save();
    if (!problem.empty()) {
        spdlog::error("{}", problem);
        toast.show(problem, true);
    }
}

}  // namespace kerf::app
