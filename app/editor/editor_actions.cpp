#include "app/editor/editor_state.h"
#include "app/tools/box_placement.h"
#include "ui/action_table.h"

namespace kerf::app {
namespace {

using State = Editor::State;

const Vec3 kEarthGravity{0, -9.81, 0};
constexpr double kApart = 0.5;  // of DisplaySettings::apart, by its key

// --- What the keys, the menus and the buttons ask for ------------------------------------------

void cancel(State& s) {
    if (s.helpOpen) {
        s.helpOpen = false;
    } else if (s.isWorking() && !s.toolIsBusy()) {
        s.cancelWork();
    } else if (s.scene != nullptr) {
        s.releaseTools();
        s.sceneChanged = true;
    }
}

void togglePanels(State& s) {
    ui::Settings& settings = s.settingsFile.now;
    settings.showControls = settings.showReadings =
        !(settings.showControls || settings.showReadings);
}

/// Holds what is shown now, or follows what comes.
void holdPlots(State& s) {
    if (s.plotView.end) {
        s.plotView.end.reset();
    } else {
        s.plotView.end = s.model.time;
    }
}

/// Says which parameter that changed: many show in the model only later.
void stepThroughHistory(State& s, const Command& undoOrRedo) {
    if (!s.execute(undoOrRedo)) {
        return;
    }
    const UndoHistory& history = s.scene->simulation().history();
    const bool back = std::holds_alternative<Undo>(undoOrRedo);
    if (back ? !history.canRedo() : !history.canUndo()) {
        return;  // it was forgotten to keep to the budget
    }
    const UndoEntry& entry = back ? history.firstUndone() : history.lastDone();
    if (std::holds_alternative<UndoEntry::ParamChange>(entry.change)) {
        s.toast.show((back ? "Taken back: " : "Done again: ") + entry.name + ".", false);
    }
}

template <ui::Tool tool>
void take(State& s) {
    ui::ToolSettings settings = s.bladeTool.settings();
    settings.tool = tool;
    s.setTools(settings);
}

void freePins(State& s) {
    if (s.scene->simulation().pinnedVertices().empty()) {
        return;
    }
    Bounds everywhere;
    everywhere.add(Vec3::Constant(-kMaxSessionCoordinate));
    everywhere.add(Vec3::Constant(kMaxSessionCoordinate));
    s.execute(Pin{everywhere, false});
}

void toggleGravity(State& s) {
    const bool on = s.scene->simulation().params().gravity.norm() > 0;
    const Vec3 before = s.scene->document().session.params.gravity;
    const Vec3 switchedOn = before.norm() > 0 ? before : kEarthGravity;
    s.execute(SetParam{"gravity", on ? Vec3(Vec3::Zero()) : switchedOn});
}

void letFall(State& s) {
    if (s.scene->simulation().params().gravity.norm() == 0) {
        toggleGravity(s);
    }
    s.scene->playing = true;
}

void stepOnce(State& s) {
    s.scene->playing = false;
    s.runSteps(1, 0);
}

void reset(State& s) {
    s.releaseTools();
    s.scene->reset();
}

void toggleRecording(State& s) {
    s.pictureOffer.reset();
    if (!s.scene->recording()) {
        s.releaseTools();
        s.scene->startRecording();
        s.toast.show("Recording. Ctrl+R stops it and saves a session.", false);
        return;
    }
    s.scene->stopRecording();
    s.saveRecording();
}

/// Of this step, or of the one that the screenshot shows which the toast offers.
void addPicture(State& s) {
    const bool offered = s.pictureOffer && s.toast.offers();
    const JournalPlace place = offered ? s.pictureOffer->place : s.scene->here();
    s.pictureOffer.reset();
    const std::string file = s.scene->addPicture(place);
    s.toast.show(file + " is a picture of step " + std::to_string(place.step) + " in the session.",
                 false);
}

void addCheck(State& s) {
    s.scene->addCheck();
    s.toast.show("The session checks step " + std::to_string(s.scene->here().step) + ".", false);
}

void addExport(State& s) {
    const std::string file = s.scene->addExport();
    s.toast.show(
        file + " is an export of step " + std::to_string(s.scene->here().step) + " in the session.",
        false);
}

void useView(State& s) {
    s.scene->useView(s.cameraFlight.destination(s.camera));
    s.toast.show("The pictures of the session are taken from here.", false);
}

void frameBody(State& s) {
    render::Camera wanted = s.cameraFlight.destination(s.camera);
    wanted.frame(s.scene->bounds());
    s.cameraFlight.start(s.camera, wanted);
}

template <AxisView view>
void lookFrom(State& s) {
    render::Camera wanted = s.cameraFlight.destination(s.camera);
    lookAlong(wanted, view);
    s.cameraFlight.start(s.camera, wanted);
}

void toggleOrthographic(State& s) {
    s.landCamera();
    s.camera.orthographic = !s.camera.orthographic;
}

template <bool ui::DisplaySettings::*member>
void toggle(State& s) {
    s.display.*member = !(s.display.*member);
}

template <bool render::Overlays::*member>
void toggleOverlay(State& s) {
    s.display.overlays.*member = !(s.display.overlays.*member);
}

void toggleApart(State& s) {
    s.display.apart = s.display.apart > 0 || s.scene->pieceCount() < 2 ? 0 : kApart;
}

void toggleQuality(State& s) {
    ui::DisplaySettings wanted = s.display;
    wanted.quality =
        wanted.quality == render::Quality::full ? render::Quality::light : render::Quality::full;
    s.setDisplay(wanted);
}

/// Whether an action does something while nothing is open. With a body its picture is drawn anew.
enum class Needs { nothing, body };

/// The code behind an action.
struct Handler {
    ui::ActionId id;
    Needs needs;
    void (*perform)(State&);
};

using render::Overlays;
using ui::ActionId;
using ui::DisplaySettings;
using ui::FilePurpose;
using ui::Tool;

constexpr std::array kHandlers{
    Handler{ActionId::openFile, Needs::nothing, [](State& s) { s.browse(FilePurpose::open); }},
    Handler{ActionId::saveSession, Needs::body,
            [](State& s) { s.browse(FilePurpose::saveSession); }},
    Handler{ActionId::saveTest, Needs::body, [](State& s) { s.beginTest(); }},
    Handler{ActionId::exportBody, Needs::body, [](State& s) { s.browse(FilePurpose::exportMesh); }},
    Handler{ActionId::screenshot, Needs::nothing, [](State& s) { s.screenshotWanted = true; }},
    Handler{ActionId::sceneScreenshot, Needs::body, [](State& s) { s.saveSceneScreenshot(); }},
    Handler{ActionId::quit, Needs::nothing, [](State& s) { s.closing = true; }},
    Handler{ActionId::undo, Needs::body, [](State& s) { stepThroughHistory(s, Undo{}); }},
    Handler{ActionId::redo, Needs::body, [](State& s) { stepThroughHistory(s, Redo{}); }},
    Handler{ActionId::cancel, Needs::nothing, cancel},
    Handler{ActionId::toggleGravity, Needs::body, toggleGravity},
    Handler{ActionId::toolStroke, Needs::body, take<Tool::stroke>},
    Handler{ActionId::toolScalpel, Needs::body, take<Tool::scalpel>},
    Handler{ActionId::toolGuillotine, Needs::body, take<Tool::guillotine>},
    Handler{ActionId::toolGrab, Needs::body, take<Tool::grab>},
    Handler{ActionId::toolPin, Needs::body, take<Tool::pin>},
    Handler{ActionId::bringDown, Needs::body, [](State& s) { s.bladeTool.bringDown(*s.scene); }},
    Handler{ActionId::freePins, Needs::body, freePins},
    Handler{ActionId::playPause, Needs::body,
            [](State& s) { s.scene->playing = !s.scene->playing; }},
    Handler{ActionId::letFall, Needs::body, letFall},
    Handler{ActionId::stepOnce, Needs::body, stepOnce},
    Handler{ActionId::reset, Needs::body, reset},
    Handler{ActionId::slower, Needs::body, [](State& s) { s.clock.setSpeed(s.clock.speed() / 2); }},
    Handler{ActionId::faster, Needs::body, [](State& s) { s.clock.setSpeed(s.clock.speed() * 2); }},
    Handler{ActionId::record, Needs::body, toggleRecording},
    Handler{ActionId::loop, Needs::body, [](State& s) { s.scene->toggleLoop(); }},
    Handler{ActionId::addPicture, Needs::body, addPicture},
    Handler{ActionId::addCheck, Needs::body, addCheck},
    Handler{ActionId::addExport, Needs::body, addExport},
    Handler{ActionId::useView, Needs::body, useView},
    Handler{ActionId::frameBody, Needs::body, frameBody},
    Handler{ActionId::resetView, Needs::body,
            [](State& s) { s.cameraFlight.start(s.camera, s.scene->document().camera); }},
    Handler{ActionId::viewFront, Needs::body, lookFrom<AxisView::front>},
    Handler{ActionId::viewBack, Needs::body, lookFrom<AxisView::back>},
    Handler{ActionId::viewRight, Needs::body, lookFrom<AxisView::right>},
    Handler{ActionId::viewLeft, Needs::body, lookFrom<AxisView::left>},
    Handler{ActionId::viewTop, Needs::body, lookFrom<AxisView::top>},
    Handler{ActionId::viewBottom, Needs::body, lookFrom<AxisView::bottom>},
    Handler{ActionId::orthographic, Needs::body, toggleOrthographic},
    Handler{ActionId::wireframe, Needs::body, toggle<&DisplaySettings::wireframe>},
    Handler{ActionId::showCutLines, Needs::body, toggle<&DisplaySettings::cutLines>},
    Handler{ActionId::showApart, Needs::body, toggleApart},
    Handler{ActionId::showEdges, Needs::body, toggleOverlay<&Overlays::edges>},
    Handler{ActionId::showBends, Needs::body, toggleOverlay<&Overlays::bends>},
    Handler{ActionId::showIspcs, Needs::body, toggleOverlay<&Overlays::ispcs>},
    Handler{ActionId::showErrors, Needs::body, toggleOverlay<&Overlays::errors>},
    Handler{ActionId::showContacts, Needs::body, toggleOverlay<&Overlays::contacts>},
    Handler{ActionId::showBoxes, Needs::body, toggleOverlay<&Overlays::boxes>},
    Handler{ActionId::fineQuality, Needs::body, toggleQuality},
    Handler{ActionId::togglePanels, Needs::nothing, togglePanels},
    Handler{ActionId::holdPlots, Needs::nothing, holdPlots},
    Handler{ActionId::fitPlots, Needs::nothing, [](State& s) { s.plotView = {}; }},
    Handler{ActionId::help, Needs::nothing, [](State& s) { s.helpOpen = !s.helpOpen; }},
};
static_assert(ui::coversActions(kHandlers), "an ActionId has no handler, or not at its place");

// --- What the panels answer with ---------------------------------------------------------------

/// Answers to each kind of ui::Action.
struct Answer {
    State& state;

    void operator()(ActionId id) const { state.perform(id); }
    void operator()(const ui::GoToChange& wanted) const { state.goToChange(wanted.done); }
    void operator()(const ui::SetSpeed& wanted) const { state.clock.setSpeed(wanted.factor); }
    void operator()(const ui::SeekTo& wanted) const { state.seekTo(wanted.step); }
    void operator()(const ui::RemoveMark& removal) const { state.removeMark(removal.id); }
    void operator()(const ui::SetTools& wanted) const { state.setTools(wanted.settings); }
    void operator()(const ui::SetDisplay& wanted) const { state.setDisplay(wanted.settings); }
    void operator()(const ui::PlaceBox&) const { state.placeBox(); }
    void operator()(const ChangeBox& change) const { state.execute(change); }
    void operator()(const RemoveBox& removal) const { state.execute(removal); }
    void operator()(const SetParam& change) const { state.execute(change); }
    void operator()(const ui::CancelWork&) const { state.cancelWork(); }
    void operator()(const ui::AnswerQuestion& answer) const { state.answer(answer.choice); }
    void operator()(const ui::FileAction& action) const { state.applyToFiles(action); }
    void operator()(const ui::SetSettings& wanted) const {
        settling().settingsFile.now = wanted.settings;
    }
    void operator()(const ui::SetPlotView& wanted) const { settling().plotView = wanted.view; }
    void operator()(const ui::ExportPlots& wanted) const {
        settling().exportPlots(wanted.asPicture);
    }
    void operator()(const ui::OpenExperiment& wanted) const {
        settling().openExperiment(wanted.name);
    }
    void operator()(const ui::HoverPiece& hover) const { settling().hoverPiece(hover.piece); }
    void operator()(const ui::FramePiece& wanted) const { settling().framePiece(wanted.piece); }
    void operator()(const ui::ShowPiece& wanted) const {
        settling().showPiece(wanted.piece, wanted.visible);
    }

    /// The panels show it only in their next updates.
    State& settling() const {
        state.settleUpdates = kSettleUpdates;
        return state;
    }
};

}  // namespace

void Editor::State::apply(const ui::Action& action) {
    std::visit(Answer{*this}, action);
}

void Editor::State::perform(ui::ActionId id) {
    settleUpdates = kSettleUpdates;
    const Handler& handler = kHandlers[static_cast<std::size_t>(id)];
    if (handler.needs == Needs::nothing) {
        handler.perform(*this);
    } else if (scene != nullptr) {
        handler.perform(*this);
        sceneChanged = true;
    }
}

void Editor::State::placeBox() {
    if (scene != nullptr) {
        execute(AddBox{boxBeside(scene->bounds(), scene->simulation().params().floor)});
    }
}

/// Before the body goes elsewhere: neither a stroke nor a pull goes on there.
void Editor::State::releaseTools() {
    bladeTool.cancel(*scene);
    pullTool.cancel(*scene);
}

bool Editor::State::execute(const Command& command) {
    if (scene == nullptr) {
        return false;
    }
    if (std::holds_alternative<Undo>(command) || std::holds_alternative<Redo>(command)) {
        releaseTools();
    }
    const std::string problem = scene->execute(command);
    say(problem);
    return problem.empty();
}

void Editor::State::say(const std::string& problem) {
    if (!problem.empty()) {
        toast.show(problem, true);
    }
    sceneChanged = true;
    settleUpdates = kSettleUpdates;
}

void Editor::State::seekTo(int step) {
    if (scene != nullptr) {
        scene->seek(step);
        sceneChanged = true;
        settleUpdates = kSettleUpdates;
    }
}

void Editor::State::removeMark(int id) {
    if (scene != nullptr) {
        scene->removeMark(id);
        settleUpdates = kSettleUpdates;
    }
}

void Editor::State::setTools(const ui::ToolSettings& settings) {
    if (scene != nullptr) {
        if (settings.tool != bladeTool.settings().tool) {
            joinPieces();
            pullTool.cancel(*scene);
        }
        bladeTool.set(settings, *scene);
        settleUpdates = kSettleUpdates;
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

}  // namespace kerf::app
