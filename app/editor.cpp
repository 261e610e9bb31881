#include "app/editor.h"

#include <glad/gl.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <ctime>

#include "app/blade_hand.h"
#include "app/editor_camera.h"
#include "app/editor_scene.h"
#include "app/editor_toast.h"
#include "app/file_io.h"
#include "app/input_queue.h"
#include "app/step_clock.h"
#include "app/view_frame.h"
#include "sim/stopwatch.h"
#include "sim/text.h"
#include "ui/interface.h"
#include "ui/shortcuts.h"

namespace kerf::app {
namespace {

constexpr double kStepBudgetSeconds = 0.012;  // more than one step only while they are this fast
constexpr int kMostSeekSteps = 64;            // per picture, while they are fast
constexpr int kMaxBatchesPerPicture = 16;
constexpr int kSettlePasses = 2;  // passes after the last input, for panels that answer late
constexpr double kForever = 1e9;
constexpr std::array<float, 3> kEmptyColor{0.06F, 0.065F, 0.08F};  // while nothing is open
const Vec2 kNowhere(-1e5, -1e5);                                   // [px]
const Vec3 kEarthGravity{0, -9.81, 0};

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

struct Editor::State {
    explicit State(const EditorOptions& wanted)
        : options(wanted),
          clock(wanted.byTheClock),
          interface(wanted.scale),
          renderer(wanted.quality) {}

    EditorOptions options;
    StepClock clock;
    InputQueue queue;
    ui::Interface interface;
    render::Renderer renderer;
    std::unique_ptr<EditorScene> scene;
    render::Camera camera;
    CameraControl cameraControl;
    Vec2 pointer = Vec2::Zero();  ///< [px]
    gpu::Framebuffer picture;
    ui::PanelModel model;
    ui::History noHistory;
    EditorToast toast;
    BladeHand hand;
    bool sceneChanged = true;
    bool closing = false;
    bool helpOpen = false;
    bool wireframe = false;
    bool screenshotWanted = false;
    bool strokedOnce = false;
    int settlePasses = kSettlePasses;

    // Input.
    void takeInput(double elapsedSeconds);
    void pass(const std::vector<ui::InputEvent>& batch, double elapsedSeconds);
    void dispatch(const ui::InputEvent& event);
    void onMove(const ui::PointerMove& move);
    void onButton(const ui::ButtonChange& change);
    void onWheel(const ui::Wheel& wheel);
    void onKey(ui::Key key, const ui::Modifiers& modifiers);
    void onFocusLost();
    void endStroke();

    // Answers.
    void apply(const ui::Action& action);
    void perform(ui::ActionId id);
    void performOnScene(ui::ActionId id);
    void moveCamera(ui::ActionId id);
    void execute(const Command& command);
    void goToChange(std::size_t done);
    void seekTo(int step);
    void setBlade(const ui::BladeSettings& settings);
    void setTool(ui::BladeTool tool);
    void toggleRecording();
    void saveSession();
    void cancel();
    void toggleGravity();
    void open(const std::filesystem::path& file);
    void show(Document document);

    // Time.
    void advance(double elapsedSeconds);
    /// `needed` steps whatever they cost, up to `due` ones while they are fast.
    void runSteps(int needed, int due);
    bool running() const;

    // Pictures.
    void describe();
    std::string hint() const;
    void draw();
    void drawScene();
    void ensurePicture();
    void saveScreenshot();

    ViewFrame viewFrame() const { return {camera, options.width, options.height}; }
};

// --- Input -------------------------------------------------------------------------------------

void Editor::State::takeInput(double elapsedSeconds) {
    // At least one pass, so that the panels live; later batches of one picture take no time.
    pass(queue.takeBatch(), elapsedSeconds);
    for (int n = 1; n < kMaxBatchesPerPicture && !queue.empty(); ++n) {
        pass(queue.takeBatch(), 0);
    }
}

void Editor::State::pass(const std::vector<ui::InputEvent>& batch, double elapsedSeconds) {
    describe();
    settlePasses = batch.empty() ? std::max(0, settlePasses - 1) : kSettlePasses;
    const std::vector<ui::Action> actions =
        interface.pass(batch, model, options.width, options.height, elapsedSeconds);
    for (const ui::InputEvent& event : batch) {
        dispatch(event);
    }
    for (const ui::Action& action : actions) {
        apply(action);
    }
}

void Editor::State::dispatch(const ui::InputEvent& event) {
    if (const auto* move = std::get_if<ui::PointerMove>(&event)) {
        onMove(*move);
    } else if (const auto* change = std::get_if<ui::ButtonChange>(&event)) {
        onButton(*change);
    } else if (const auto* wheel = std::get_if<ui::Wheel>(&event)) {
        onWheel(*wheel);
    } else if (const auto* key = std::get_if<ui::KeyChange>(&event); key != nullptr && key->down) {
        onKey(key->key, key->modifiers);
    } else if (const auto* typed = std::get_if<ui::Character>(&event);
               typed && typed->code == '?') {
        onKey(ui::Key::questionMark, {});
    } else if (const auto* drop = std::get_if<ui::FileDrop>(&event); drop && !drop->files.empty()) {
        open(drop->files.front());
    } else if (std::holds_alternative<ui::FocusLost>(event)) {
        onFocusLost();
    }
}

void Editor::State::onMove(const ui::PointerMove& move) {
    const Vec2 to{move.x, move.y};
    const Vec2 by = to - pointer;
    pointer = to;
    if (cameraControl.move(camera, by.x(), by.y(), options.height)) {
        sceneChanged = true;
    }
    if (scene != nullptr) {
        hand.move(viewFrame(), pointer, *scene);
    }
}

void Editor::State::onButton(const ui::ButtonChange& change) {
    if (!change.down) {
        cameraControl.release(change.button);
        if (change.button == ui::Button::left) {
            endStroke();
        }
        return;
    }
    if (interface.ownsPointer() || hand.holds() || cameraControl.press(change)) {
        return;
    }
    if (change.button == ui::Button::left && scene != nullptr) {
        hand.press(viewFrame(), pointer, *scene);
    }
}

void Editor::State::endStroke() {
    if (scene != nullptr && hand.holds()) {
        hand.release(*scene);
        strokedOnce = strokedOnce || scene->stroke().pending() > 0;
    }
}

void Editor::State::onWheel(const ui::Wheel& wheel) {
    if (!interface.ownsPointer()) {
        const ViewFrame view = viewFrame();
        CameraControl::zoom(camera, wheel.y, view.toNdc(pointer), view.aspect());
        sceneChanged = true;
    }
}

void Editor::State::onKey(ui::Key key, const ui::Modifiers& modifiers) {
    if (interface.ownsKeyboard()) {
        return;
    }
    if (const std::optional<ui::ActionId> id = ui::findAction(key, modifiers)) {
        perform(*id);
    }
}

void Editor::State::onFocusLost() {
    cameraControl.releaseAll();
    endStroke();
}

// --- Answers -----------------------------------------------------------------------------------

void Editor::State::apply(const ui::Action& action) {
    if (const auto* id = std::get_if<ui::ActionId>(&action)) {
        perform(*id);
    } else if (const auto* change = std::get_if<ui::GoToChange>(&action)) {
        goToChange(change->done);
    } else if (const auto* speed = std::get_if<ui::SetSpeed>(&action)) {
        clock.setSpeed(speed->factor);
    } else if (const auto* seek = std::get_if<ui::SeekTo>(&action)) {
        seekTo(seek->step);
    } else if (const auto* blade = std::get_if<ui::SetBlade>(&action)) {
        setBlade(blade->settings);
    } else {
        execute(std::get<SetParam>(action));
    }
}

void Editor::State::execute(const Command& command) {
    if (scene == nullptr) {
        return;
    }
    if (const std::string problem = scene->execute(command); !problem.empty()) {
        toast.show(problem, true);
    }
    sceneChanged = true;
    settlePasses = kSettlePasses;
}

void Editor::State::seekTo(int step) {
    if (scene != nullptr) {
        scene->seek(step);
        sceneChanged = true;
        settlePasses = kSettlePasses;
    }
}

void Editor::State::setBlade(const ui::BladeSettings& settings) {
    if (scene != nullptr) {
        hand.set(settings, *scene);
        settlePasses = kSettlePasses;
    }
}

void Editor::State::setTool(ui::BladeTool tool) {
    ui::BladeSettings settings = hand.settings();
    settings.tool = tool;
    setBlade(settings);
}

void Editor::State::toggleRecording() {
    if (!scene->recording()) {
        scene->startRecording();
        toast.show("Recording. Ctrl+R stops it and saves a session.", false);
        return;
    }
    scene->stopRecording();
    saveSession();
}

void Editor::State::saveSession() {
    try {
        const std::filesystem::path file =
            freeFile(options.screenshotFolder, scene->document().name, ".kerf.json");
        writeOutputFile(file, formatSession(scene->recordedSession(camera), file.parent_path()));
        spdlog::info("session saved to {}", file.string());
        toast.show("Saved " + file.string(), false);
    } catch (const std::exception& error) {
        toast.show(error.what(), true);
    }
}

void Editor::State::goToChange(std::size_t done) {
    if (scene == nullptr) {
        return;
    }
    const UndoHistory& history = scene->simulation().history();
    while (history.done() > done && history.canUndo()) {
        execute(Undo{});
    }
    while (history.done() < done && history.canRedo()) {
        execute(Redo{});
    }
}

void Editor::State::perform(ui::ActionId id) {
    settlePasses = kSettlePasses;
    switch (id) {
        case ui::ActionId::help:
            helpOpen = !helpOpen;
            return;
        case ui::ActionId::screenshot:
            screenshotWanted = true;
            return;
        case ui::ActionId::cancel:
            cancel();
            return;
        case ui::ActionId::quit:
            closing = true;
            return;
        default:
            if (scene != nullptr) {
                performOnScene(id);
                sceneChanged = true;
            }
    }
}

void Editor::State::performOnScene(ui::ActionId id) {
    switch (id) {
        case ui::ActionId::playPause:
            scene->playing = !scene->playing;
            return;
        case ui::ActionId::stepOnce:
            scene->playing = false;
            runSteps(1, 0);
            return;
        case ui::ActionId::reset:
            scene->reset();
            return;
        case ui::ActionId::undo:
            execute(Undo{});
            return;
        case ui::ActionId::redo:
            execute(Redo{});
            return;
        case ui::ActionId::toolStroke:
            setTool(ui::BladeTool::stroke);
            return;
        case ui::ActionId::toolScalpel:
            setTool(ui::BladeTool::scalpel);
            return;
        case ui::ActionId::toolGuillotine:
            setTool(ui::BladeTool::guillotine);
            return;
        case ui::ActionId::bringDown:
            hand.bringDown(*scene);
            strokedOnce = true;
            return;
        case ui::ActionId::record:
            toggleRecording();
            return;
        case ui::ActionId::saveSession:
            saveSession();
            return;
        case ui::ActionId::loop:
            scene->toggleLoop();
            return;
        case ui::ActionId::slower:
            clock.setSpeed(clock.speed() / 2);
            return;
        case ui::ActionId::faster:
            clock.setSpeed(clock.speed() * 2);
            return;
        case ui::ActionId::toggleGravity:
            toggleGravity();
            return;
        case ui::ActionId::wireframe:
            wireframe = !wireframe;
            return;
        default:
            moveCamera(id);
    }
}

void Editor::State::moveCamera(ui::ActionId id) {
    switch (id) {
        case ui::ActionId::frameBody:
            camera.frame(scene->bounds());
            return;
        case ui::ActionId::resetView:
            camera = scene->document().camera;
            return;
        case ui::ActionId::viewFront:
            lookAlong(camera, AxisView::front);
            return;
        case ui::ActionId::viewRight:
            lookAlong(camera, AxisView::right);
            return;
        case ui::ActionId::viewTop:
            lookAlong(camera, AxisView::top);
            return;
        default:
            return;
    }
}

void Editor::State::cancel() {
    if (helpOpen) {
        helpOpen = false;
    } else if (scene != nullptr) {
        hand.cancel(*scene);
        sceneChanged = true;
    }
}

void Editor::State::toggleGravity() {
    const bool on = scene->simulation().params().gravity.norm() > 0;
    const Vec3 before = scene->document().session.params.gravity;
    const Vec3 switchedOn = before.norm() > 0 ? before : kEarthGravity;
    execute(SetParam{"gravity", on ? Vec3(Vec3::Zero()) : switchedOn});
}

void Editor::State::open(const std::filesystem::path& file) {
    try {
        show(openDocument(file));
    } catch (const std::exception& error) {
        // The scene is as it was: the new one is only taken once it stands.
        spdlog::error("{}", error.what());
        toast.show(error.what(), true);
    }
}

void Editor::State::show(Document document) {
    const std::string note = document.note;
    scene = std::make_unique<EditorScene>(std::move(document));
    camera = scene->document().camera;
    renderer.setRestShape(scene->document().mesh);
    hand.fitTo(scene->bounds());
    cameraControl.releaseAll();
    strokedOnce = false;
    sceneChanged = true;
    clock.stop();
    if (!note.empty()) {
        spdlog::info("{}: {}", scene->document().name, note);
        toast.show(note, false);
    }
}

// --- Time --------------------------------------------------------------------------------------

bool Editor::State::running() const {
    return scene != nullptr &&
           (scene->playing || scene->stroke().pending() > 0 || scene->seekSteps() > 0);
}

void Editor::State::runSteps(int needed, int due) {
    const Stopwatch watch;
    for (int n = 0; n < std::max(needed, due); ++n) {
        const bool late = options.byTheClock && watch.seconds() > kStepBudgetSeconds;
        if (late && n >= std::max(1, needed)) {
            break;
        }
        scene->step();
    }
    sceneChanged = true;
    settlePasses = kSettlePasses;  // the panels show a step one pass later
    for (const std::string& message : scene->takeMessages()) {
        spdlog::warn("{}", message);
        toast.show(message, false);
    }
}

void Editor::State::advance(double elapsedSeconds) {
    const bool ran = running();
    if (ran) {
        const bool playing = scene->playing;
        const double timeStep = scene->simulation().params().timeStep;
        const int due = playing ? clock.takeDue(elapsedSeconds, timeStep) : 0;
        runSteps(scene->strokeSteps(), std::max(due, std::min(scene->seekSteps(), kMostSeekSteps)));
    }
    if (clock.measure(elapsedSeconds, ran)) {
        scene->recordFrameRate(1 / elapsedSeconds);
    }
    if (scene != nullptr && !scene->stroke().drawing() && scene->stroke().pending() == 0) {
    }
}

// --- Pictures ----------------------------------------------------------------------------------

std::string Editor::State::hint() const {
    if (scene == nullptr) {
        return "Drop a model (OBJ, PLY, STL) or a session here to open it.";
    }
    if (scene->pieceCount() > 1 && !scene->playing) {
        const bool weightless = scene->simulation().params().gravity.norm() == 0;
        return weightless ? "Press V for gravity, then Space to let the pieces fall."
                          : "Press Space to let the pieces fall.";
    }
    if (strokedOnce || scene->playing) {
        return "";
    }
    if (hand.settings().tool == ui::BladeTool::scalpel) {
        return "Drag over the surface to cut into it.";
    }
    if (hand.settings().tool == ui::BladeTool::guillotine) {
        return "Drag the four handles to pose the blade, then press Enter to bring it down.";
    }
    return scene->playingBack()
               ? "Press Space to play the session, or drag across the model to cut it."
               : "Drag across the model to cut it.";
}

void Editor::State::describe() {
    model = {};
    model.helpOpen = helpOpen;
    model.wireframe = wireframe;
    model.history = &noHistory;
    if (scene != nullptr) {
        scene->describe(model);
    }
    model.speed = clock.speed();
    model.stages.frame = clock.rate() > 0 ? 1000 / clock.rate() : 0;
    model.device = options.device;
    model.hint = hint();
    model.blade = hand.settings();
    if (scene != nullptr) {
        const Vec2 inView = interface.ownsPointer() ? kNowhere : pointer;
        model.overlay = hand.overlay(viewFrame(), inView, *scene);
    }
    toast.describe(model);
}

void Editor::State::ensurePicture() {
    if (picture.width() != options.width || picture.height() != options.height) {
        picture = gpu::Framebuffer(GL_RGBA8, GL_DEPTH_COMPONENT24, options.width, options.height);
        sceneChanged = true;
    }
}

void Editor::State::drawScene() {
    if (scene == nullptr || !sceneChanged) {
        return;
    }
    render::SceneView view = scene->view();
    view.wireframe = wireframe;
    renderer.draw(view, camera, options.width, options.height);
    sceneChanged = false;
}

void Editor::State::draw() {
    ensurePicture();
    drawScene();
    if (scene != nullptr) {
        // The panels go over a copy, so that they can move while the scene stands still.
        renderer.target().blitColorTo(picture);
    } else {
        picture.bind();
        glClearColor(kEmptyColor[0], kEmptyColor[1], kEmptyColor[2], 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    interface.draw(picture);
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

// --- Editor ------------------------------------------------------------------------------------

Editor::Editor(const EditorOptions& options, std::optional<Document> document)
    : state_(std::make_unique<State>(options)) {
    if (document) {
        state_->show(std::move(*document));
    }
    state_->describe();
}

Editor::~Editor() = default;

void Editor::post(ui::InputEvent event) {
    state_->queue.push(std::move(event));
}

void Editor::resize(int width, int height) {
    const bool same = width == state_->options.width && height == state_->options.height;
    if (width > 0 && height > 0 && !same) {
        state_->options.width = width;
        state_->options.height = height;
        state_->settlePasses = kSettlePasses;
    }
}

void Editor::frame(double elapsedSeconds) {
    State& s = *state_;
    s.toast.pass(elapsedSeconds);
    s.takeInput(elapsedSeconds);
    s.advance(elapsedSeconds);
    s.draw();
    if (s.screenshotWanted) {
        s.saveScreenshot();
    }
}

double Editor::idleSeconds() const {
    const State& s = *state_;
    if (!s.queue.empty() || s.running() || s.sceneChanged || s.settlePasses > 0) {
        return 0;
    }
    return s.toast.visible() ? s.toast.steadySeconds() : kForever;
}

bool Editor::closing() const {
    return state_->closing;
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

const ui::ItemPlaces& Editor::places() const {
    return state_->interface.places();
}

void Editor::open(const std::filesystem::path& file) {
    state_->open(file);
}

}  // namespace kerf::app
