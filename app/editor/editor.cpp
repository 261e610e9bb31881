#include "app/editor/editor.h"

#include <spdlog/spdlog.h>

#include <new>

#include "app/editor/editor_state.h"
#include "app/scene/held_hands.h"
#include "app/scene/readout/scene_readout.h"
#include "app/scene/timeline/scene_recorder.h"
#include "app/tools/measure_tool.h"
#include "app/tools/move_tool.h"
#include "gpu/buffer.h"
#include "gpu/context.h"
#include "render/scene/depth_field.h"

namespace kerf::app {
namespace {

constexpr double kForever = 1e9;        // [s]
constexpr double kHiddenPause = 0.016;  // between two frames that nobody sees [s]
constexpr double kWorkPause = 0.05;     // between two pictures while a thread works [s]
constexpr double kWorkPictures = 0.25;  // the same while a step is under way and nothing moves [s]
constexpr int kMostSeekSteps = 1000;    // between two pictures, while they are fast

using State = Editor::State;

/// Does what the gizmo in hand asks for.
bool followGizmo(State& s, EditorScene& now) {
    MoveTool& gizmo = s.view.tools.get<MoveTool>();
    const std::optional<Command> command = gizmo.takeCommand(now);
    if (!command) {
        return false;
    }
    const Place* const place = std::get_if<Place>(&*command);
    if (place != nullptr && !gizmo.holds()) {  // at the end of a drag
        s.place(*place);
        gizmo.noteOutcome(s.work.placing() == nullptr, now);
    } else {
        gizmo.noteOutcome(s.execute(*command), now);
    }
    return false;
}

/// Lets view and picture follow a model that was placed otherwise.
bool followPlacement(State& s, EditorScene& now) {
    if (!s.view.follow(now)) {
        return false;
    }
    s.picture.setBody(now.simulation().uncut());
    return true;
}

/// Has the thickness of the body worked out where the colours show it.
bool followThickness(State& s, EditorScene& now) {
    return now.readout().followThickness(
        s.view.display.settings.field.field == render::SurfaceField::thickness, !now.running());
}

/// Lets the measures go on with the body.
bool followMeasures(State& s, EditorScene& now) {
    MeasureTool& measures = s.view.tools.get<MeasureTool>();
    if (const std::string word = measures.any() ? measures.follow(now) : ""; !word.empty()) {
        s.toast.show(word, false);
    }
    return false;
}

/// Has the pieces added up where their list has all columns.
bool followPieceSums(State& s, EditorScene& now) {
    return now.readout().followPieceSums(s.view.display.settings.pieceDetails && !now.running());
}

/// Has the quality of the cuts measured where its section is open.
bool followCuts(State& s, EditorScene& now) {
    return now.readout().followCuts(s.panels.shows("cuts"));
}

/// Lets the lines of a task move with the skin, and scores a finished try.
bool followPractice(State& s, EditorScene& now) {
    const ui::Settings& settings = s.panels.settings.now;
    const bool shows = s.panels.practice.follow(now, settings);
    if (s.panels.practice.isDue(now)) {
        Session played =
            now.recorder()
                .savedSession(s.view.camera.destination(), s.view.display.settings.colors)
                .session;
        s.say(s.panels.practice.judge(now, std::move(played), settings.person));
        return s.panels.practice.follow(now, settings) || shows;
    }
    return shows;
}

/// Lets clients of the link lead the blade, unless the scene is covered.
bool followLink(State& s, EditorScene& now) {
    return !s.view.faulty && !s.comesBack() && s.link.follow(now);
}

/// What follows the open scene once a picture, where that rests: whether there is something else
/// to show then, and what shows it.
struct Follower {
    bool (*follow)(State& s, EditorScene& now);
    void (Redraw::*shows)();
};
constexpr std::array kFollowers{
    Follower{followGizmo, &Redraw::scene},      Follower{followPlacement, &Redraw::scene},
    Follower{followThickness, &Redraw::scene},  Follower{followMeasures, &Redraw::panels},
    Follower{followPieceSums, &Redraw::panels}, Follower{followCuts, &Redraw::panels},
    Follower{followPractice, &Redraw::panels},  Follower{followLink, &Redraw::panels},
};

void showMessages(State& s) {
    for (const std::string& message : s.scene->takeMessages()) {
        spdlog::warn("{}", message);
        s.toast.show(message, false);
    }
}

/// Steps that are due by the clock.
int dueSteps(const State& s, EditorScene& scene) {
    return scene.timeline().playing || scene.hands().pulling() ? s.clock.due() : 0;
}

/// Begins the steps that are due, if any.
void beginSteps(State& s) {
    EditorScene& scene = *s.scene;
    if (!scene.running()) {
        s.clock.stop();
        s.scene.stops = false;
        return;
    }
    s.view.display.join();
    scene.timeRunsWhileCutting = s.panels.settings.now.timeRunsWhileCutting;
    if (s.clock.byTheClock()) {
        scene.hands().limitSpeed(HeldHands::usualSpeed(scene.rest().bounds().diagonal()));
    }
    s.clock.passTime(scene.simulation().params().timeStep);
    const int needed = scene.strokeSteps();
    const int most =
        std::max(dueSteps(s, scene), std::min(scene.timeline().seekSteps(), kMostSeekSteps));
    s.scene.begin(SceneWork::steps,
                  [&s, needed, most](EditorScene& now) { s.clock.run(now, needed, most); });
}

/// Whether more steps are to be done before the next picture: they can't keep up with the clock,
/// or with a stroke.
bool runsBehind(State& s, EditorScene& scene) {
    return s.clock.byTheClock() &&
           (dueSteps(s, scene) > 0 || (scene.strokeSteps() > 0 && s.clock.isSlow()));
}

/// Writes changed settings, after a drag and not at each of its moves.
void keepSettings(State& s) {
    const std::string problem = s.panels.interface.isDragging() ? "" : s.panels.settings.save();
    if (!problem.empty()) {
        spdlog::error("{}", problem);
        s.toast.show(problem, true);
    }
}

void saveScreenshot(State& s) {
    if (std::exchange(s.redraw.screenshotWanted, false)) {
        const int number = s.savePicture(s.picture.read(), "kerf");
        if (s.scene != nullptr && s.scene.meanwhile().recording()) {
            s.toast.offerOnceSaved(s.scene->recorder().here(), number);
        }
    }
}

void drawScene(State& s) {
    if (s.view.faulty) {
        render::SceneView model = s.view.faulty->scene.view();
        model.bright = s.view.bright;
        model.covered = s.panels.covered(s.view.width, s.view.height);
        s.picture.drawModel(model, s.view, s.redraw.takeScene());
        return;
    }
    const BusyScene now = s.scene.meanwhile();
    const render::FieldRange range = s.picture.fieldRange();
    const bool seeks = now && now.seekSteps() > 0 && s.clock.byTheClock();
    if (!now || (now.isWhole() && !(seeks && s.picture.hasBody()))) {
        const bool rests = now && now.running() && (s.clock.due() > 0 || s.clock.isSlow()) &&
                           s.clock.byTheClock() && !s.redraw.stepsAreDue();
        s.picture.draw(now, s.view, s.panels.covered(s.view.width, s.view.height),
                       s.redraw.takeScene(!rests));
    } else {
        s.picture.keep(s.view);
    }
    if (s.picture.fieldRange() != range) {
        s.redraw.panels();  // The legend was drawn before.
    }
}

void advance(State& s, double elapsedSeconds) {
    s.clock.elapse(elapsedSeconds);
    s.picture.measure();
    if (s.scene.onceSought && s.scene.meanwhile().seekSteps() == 0) {
        std::exchange(s.scene.onceSought, nullptr)();
    }
    s.workOff();
    if (EditorScene* const now = s.scene.atRest()) {
        const bool waits = s.redraw.stepsPending() && s.redraw.stepsAreDue();
        if (waits && s.clock.byTheClock() && now->timeline().seekSteps() == 0) {
            return;  // this picture is of the steps before
        }
        beginSteps(s);
    }
    s.goOn();
}

}  // namespace

Editor::Editor(const EditorOptions& options, std::optional<Document> document)
    : state_(std::make_unique<State>(options)) {
    if (document) {
        state_->show(UploadedDocument(prepareDocument(std::move(*document))));
    } else {
        state_->panels.startOpen = true;
    }
    if (!options.notice.empty()) {
        state_->toast.show(options.notice, true);
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

void Editor::hide(bool hidden) {
    if (std::exchange(state_->redraw.hidden, hidden) && !hidden) {
        state_->redraw.scene();
    }
}

void Editor::keepPlace(const ui::WindowPlace& place) {
    SettingsFile& settings = state_->panels.settings;
    if (settings.problem().empty()) {  // else it is the user's to mend
        settings.now.place = place;
        keepSettings(*state_);
    }
}

void Editor::frame(double elapsedSeconds) {
    State& s = *state_;
    s.sparingly([&] { s.makePicture(elapsedSeconds); });
}

/// What the scene was doing has come to no end, and its memory may be what is needed to go on.
void Editor::State::sparingly(const std::function<void()>& doWork) {
    try {
        doWork();
    } catch (const std::bad_alloc&) {
        giveUpScene(outOfMemory("The editor"));
    } catch (const gpu::OutOfMemory& error) {
        giveUpScene(error.what());
    }
}

void Editor::State::makePicture(double elapsedSeconds) {
    State& s = *this;
    const Stopwatch watch;
    gpu::requireContext();
    s.redraw.end();
    s.toast.elapse(elapsedSeconds);
    s.takeInput(elapsedSeconds);
    s.view.camera.advance(elapsedSeconds);
    s.followFiles();
    if (s.scene != nullptr) {
        s.sceneHistory.follow(s.scene.meanwhile().history());
    }
    if (s.scene == nullptr && s.work.opening() == nullptr && !s.view.faulty && !s.panels.asked) {
        s.panels.startOpen = true;
    }
    if (EditorScene* const now = s.scene.atRest(); now && s.guide.follow(*now, s.view)) {
        s.redraw.panels();
    }
    const double before = watch.seconds();
    advance(s, elapsedSeconds);
    s.keepWork(elapsedSeconds);
    s.offerLeftWork();
    s.tellOfDriver();
    for (const Follower& row : kFollowers) {
        if (EditorScene* const now = s.scene.atRest(); now && row.follow(s, *now)) {
            (s.redraw.*row.shows)();
        }
    }
    s.redraw.begin(before);
    const bool seen = s.redraw.drawsAll && !s.redraw.hidden;
    if (seen || s.redraw.screenshotWanted || s.keeping.pictureDue() == 0.0) {
        s.draw();
    } else {
        s.redraw.putOff();
    }
    saveScreenshot(s);
    keepSettings(s);
}

bool Editor::workOn() {
    State& s = *state_;
    s.redraw.end();
    const bool picturesWait = !s.queue.empty() || s.redraw.pending() || s.view.camera.flying();
    const bool isLong = s.scene.seconds() > kWorkPictures;
    if (picturesWait || (isLong && s.redraw.sincePicture() > kWorkPictures)) {
        return false;
    }
    if (EditorScene* const now = s.scene.atRest()) {
        if (!now->running() || !s.scene.waiting.empty() || s.redraw.stepsAreDue() ||
            !runsBehind(s, *now)) {
            return false;
        }
        s.sparingly([&] { beginSteps(s); });
    }
    s.sparingly([&] { s.goOn(); });
    return s.scene != nullptr;
}

void Editor::lookAtFiles() {
    if (state_->scene != nullptr && state_->work.models.look()) {
        state_->redraw.panels();
    }
}

double Editor::idleSeconds() const {
    const State& s = *state_;
    const BusyScene scene = s.scene.meanwhile();
    const bool runs = s.scene.underWay() || !s.scene.waiting.empty() || (scene && scene.running());
    if (!s.queue.empty() || runs || s.redraw.pending() || s.redraw.stepsPending() ||
        s.view.camera.flying()) {
        return s.redraw.hidden && s.clock.due() == 0 ? kHiddenPause : 0;
    }
    if (const DocumentLoading* opening = s.work.opening()) {
        return opening->preparing() ? kWorkPause : 0;
    }
    if (s.work.saves() || s.work.search() != nullptr || s.work.placing() != nullptr ||
        s.chooser.previews() || (scene && scene.workingOut())) {
        return kWorkPause;
    }
    const bool soon = s.offers.looking() || s.driverCheck.looking();
    const double rest =
        std::min({soon ? kWorkPause : kForever, s.keeping.pictureDue().value_or(kForever),
                  s.link.isOn() ? s.link.pause() : kForever});
    return s.toast.visible() ? std::min(rest, s.toast.steadySeconds()) : rest;
}

bool Editor::working() const {
    const FileWork& work = state_->work;
    return work.opening() != nullptr || work.search() != nullptr || work.placing() != nullptr ||
           work.saves();
}

void Editor::askToLeave() {
    state_->leave();
}

bool Editor::closing() const {
    return state_->closing && !state_->work.saves();
}

const gpu::Framebuffer& Editor::picture() const {
    return state_->picture.target();
}

render::Image Editor::readPicture() const {
    if (!state_->redraw.drawsAll) {
        state_->draw();
    }
    return state_->picture.read();
}

ui::Cursor Editor::cursor() const {
    const State& s = *state_;
    if (s.panels.interface.ownsPointer()) {
        return s.panels.interface.cursor();
    }
    return s.scene == nullptr ? ui::Cursor::arrow : s.view.cursor(s.panels.model.view.overlay);
}

std::string Editor::title() const {
    return state_->title();
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
    state_->panels.startOpen = false;
    state_->open(file);
}

// --- A picture ---------------------------------------------------------------------------------

void Editor::State::workOff() {
    while (!scene.underWay() &&
           (sceneHistory.wanted != SceneHistory::Exchange::none || !scene.waiting.empty())) {
        if (sceneHistory.wanted != SceneHistory::Exchange::none) {
            followExchange();
            continue;
        }
        const ui::Action action = std::move(scene.waiting.front());
        scene.waiting.pop_front();
        scene.begin(SceneWork::change, [this, action](EditorScene&) { answer(action); });
        goOn();
    }
}

void Editor::State::goOn() {
    const bool steps = scene.isAt(SceneWork::steps);
    if (!scene.underWay()) {
        return;
    }
    scene.goOn(clock.portion());
    if (scene.underWay()) {
        return;
    }
    showMessages(*this);
    redraw.steps();
    if (!scene->running()) {
        redraw.panels();  // no picture of more steps follows
    }
    if (!steps) {
        return;
    }
    if (!redraw.takeShown() && !clock.starts()) {
        return;  // more steps before the next picture
    }
    const FrameTime time = clock.measure();
    scene->readout().addPicture(time, picture.takeSceneMilliseconds());
    if (time.all > 0) {
        panels.experiments.note(*scene);
    }
}

void Editor::State::complain(const std::string& sentence) {
    spdlog::error("{}", sentence);
    toast.show(sentence, true);
    redraw.panels();
}

void Editor::State::draw() {
    drawScene(*this);
    keepPicture();
    panels.interface.draw(picture.target());
}

}  // namespace kerf::app
