#include "app/editor/editor_state.h"
#include "app/editor/storage/file_saving.h"
#include "app/files/io/file_io.h"
#include "app/scene/editor_stroke.h"
#include "app/scene/held_hands.h"
#include "app/scene/readout/scene_readout.h"
#include "app/scene/timeline/scene_recorder.h"
#include "app/session/scene_origin.h"
#include "app/tools/box_placement.h"
#include "app/tools/measure_tool.h"
#include "app/tools/move_tool.h"
#include "app/tools/retract_tool.h"
#include "gpu/data_path.h"
#include "sim/base/text.h"
#include "ui/base/unit_text.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"

namespace kerf::app {
namespace {

using State = Editor::State;

const Vec3 kEarthGravity{0, -9.81, 0};
constexpr double kApart = 0.5;       // of DisplaySettings::apart, by its key
constexpr double kEverywhere = 1e6;  // farther from the origin no vertex is held [m]

// --- What the keys, the menus and the buttons ask for ------------------------------------------

/// A blade is put away at once, a hand lets go when the step is done.
void stopTools(State& s) {
    const int waiting = s.scene.meanwhile().stroke().waiting();
    s.view.cancelTools(s.sceneOfTool(), true);
    if (s.scene.meanwhile() && s.scene.meanwhile().pulling()) {
        s.scene->hands().letGo();  // a hand that was released and has not arrived
    }
    if (waiting > 0) {
        s.toast.show("Cancelled. " + counted(waiting, "more cut", "more cuts") + " in the queue " +
                         (waiting == 1 ? "was" : "were") + " dropped.",
                     false);
    }
    s.redraw.scene();
}

/// A scene that is open waits behind it.
void showStart(State& s) {
    if (s.scene != nullptr) {
        if (s.view.holds()) {
            stopTools(s);
        }
        s.scene.meanwhile().playing() = false;
    }
    s.hideFaulty();
    s.chooser.lookForRecent();
    s.panels.startOpen = true;
    s.redraw.scene();
}

/// What takes long: the file, or else the stroke, or time.
void cancelWork(State& s) {
    if (s.work.cancel() || s.scene == nullptr) {
        return;
    }
    const BusyScene scene = s.scene.meanwhile();
    if (scene.stroke().pending() == 0) {
        scene.playing() = false;
        scene.stopSeeking();
        s.scene.onceSought = nullptr;
    }
    stopTools(s);
    s.scene.stops = s.scene.underWay();
}

void cancel(State& s) {
    if (s.panels.helpOpen) {
        s.panels.helpOpen = false;
    } else if (s.view.faulty) {
        s.hideFaulty();
    } else if (s.panels.startOpen && s.scene != nullptr && s.work.opening() == nullptr) {
        s.panels.startOpen = false;
    } else if (!s.view.holds() && !s.work.models.changed().empty()) {
        s.work.models.ignore();
        s.redraw.panels();
    } else if (s.view.tools.inHand().escape(s.view.tools.settings())) {
        s.redraw.panels();
    } else if (!s.view.holds() && s.scene != nullptr && s.scene.meanwhile().seekSteps() > 0) {
        cancelWork(s);
    } else if ((s.view.holds() || !s.work.cancel()) && s.scene != nullptr) {
        stopTools(s);
    }
}

/// Those of the body's material, or the session's if it has none.
render::ChosenColors colorsOfMaterial(State& s) {
    const Material* const material = s.materials.of(s.scene->simulation().params());
    const bool own = material == nullptr || !material->colors.any();
    return own ? s.scene->document().session.colors : material->colors;
}

/// Whether taking it back moves the body at once.
bool movesBody(const UndoEntry& entry) {
    return std::holds_alternative<UndoEntry::BodySnapshotChange>(entry.change);
}

/// Says what that changed: many a change shows in the model only later.
void stepThroughHistory(State& s, const Command& undoOrRedo) {
    const bool back = std::holds_alternative<Undo>(undoOrRedo);
    if (back ? s.undoesScene() : s.redoesScene()) {
        return;
    }
    if (back && s.scene->timeline().hasForgotten()) {
        s.scene->recallHistory();
        s.offers.comingBack = true;
        s.scene.onceSought = [&s] { s.apply(ui::ActionId::undo); };
        return;
    }
    if (!s.execute(undoOrRedo)) {
        return;
    }
    const UndoHistory& history = s.scene->simulation().history();
    if (back ? !history.canRedo() : !history.canUndo()) {
        return;  // it was forgotten to keep to the budget
    }
    const UndoEntry& entry = back ? history.firstUndone() : history.lastDone();
    const std::string told = (back ? "Undone: " : "Redone: ") + ui::withRaisedDigits(entry.name);
    if (const bool next = back && history.canUndo(); !next || movesBody(entry)) {
        s.toast.show(told, false);
    } else {
        s.toast.offer(
            told + ". The body keeps its shape.",
            {ui::ActionId::undo, "Also undo: " + ui::withRaisedDigits(history.lastDone().name)});
    }
}

/// The one before lets go.
void setTools(State& s, const ui::ToolSettings& settings) {
    s.view.setTools(settings, s.sceneOfTool());
}

template <ui::ToolKind tool>
void take(State& s) {
    ui::ToolSettings settings = s.view.tools.settings();
    settings.tool = tool;
    setTools(s, settings);
}

/// Holds what is shown now, or follows what comes.
void holdPlots(State& s) {
    std::optional<double>& end = s.panels.plotView.end;
    end = end ? std::nullopt : std::optional(s.panels.model.transport.time);
}

void freePins(State& s) {
    const Bounds everywhere{Vec3::Constant(-kEverywhere), Vec3::Constant(kEverywhere)};
    if (!s.scene->simulation().pinnedVertices().empty()) {
        s.execute(Pin{everywhere, false});
    }
    if (!s.scene->simulation().forces().empty()) {
        s.execute(ApplyForce{everywhere, Vec3::Zero()});
    }
}

void removeRetractor(State& s) {
    s.view.tools.get<RetractTool>().removeOne(s.view.context(s.restingScene()));
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
    s.scene->timeline().playing = true;
}

void toggleTimeWhileCutting(State& s) {
    bool& runs = s.panels.settings.now.timeRunsWhileCutting;
    runs = !runs;
}

void playOrPause(State& s) {
    bool& playing = s.scene.meanwhile().playing();
    playing = !playing;
}

void stepOnce(State& s) {
    s.scene->timeline().playing = false;
    s.clock.run(*s.scene, 1, 0);
}

void reset(State& s) {
    s.view.cancelTools(s.restingScene());
    s.scene->reset();
}

void toggleRecording(State& s) {
    s.toast.withdrawOffer();
    if (s.scene->recorder().recording()) {
        s.scene->recorder().stop();
        s.browse(ui::FilePurpose::saveSession);
        return;
    }
    s.askBefore("Start recording", [&s] {
        s.view.cancelTools(s.restingScene());
        s.scene->startRecording();
        s.toast.show("Recording. Press Ctrl+R to stop and save the session.", false);
    });
}

void tellAdded(State& s, const std::string& what, int step, const std::string& file = "") {
    s.toast.show("Added " + what + " at step " + std::to_string(step) + " to the session" +
                     (file.empty() ? "" : ": " + file),
                 false);
}

/// Of this step, or of the one that the screenshot shows which the toast offers.
void addPicture(State& s) {
    const JournalPosition place = s.toast.takeOffer().value_or(s.scene->recorder().here());
    const std::string file = s.scene->recorder().addPicture(place);
    tellAdded(s, "a picture", place.step, file);
}

void addCheck(State& s) {
    s.scene->recorder().addCheck();
    tellAdded(s, "a check", s.scene->recorder().here().step);
}

void addExport(State& s) {
    const std::string file = s.scene->recorder().addExport();
    tellAdded(s, "an export", s.scene->recorder().here().step, file);
}

void addCamera(State& s) {
    s.scene->recorder().addCamera(s.view.camera.destination());
    tellAdded(s, "a camera keyframe", s.scene->recorder().here().step);
}

void useView(State& s) {
    s.scene->recorder().useView(s.view.camera.destination());
    s.toast.show("Session pictures now use this view.", false);
}

template <AxisView axis>
void lookFrom(State& s) {
    s.view.camera.flyTo(axis);
}

template <bool ui::DisplaySettings::*member>
void toggle(State& s) {
    s.view.display.settings.*member = !(s.view.display.settings.*member);
}

template <bool render::Overlays::*member>
void toggleOverlay(State& s) {
    render::Overlays& overlays = s.view.display.settings.overlays;
    overlays.*member = !(overlays.*member);
}

void toggleApart(State& s) {
    double& apart = s.view.display.settings.apart;
    apart = apart > 0 || s.scene->simulation().report().pieces < 2 ? 0 : kApart;
}

void takeNextField(State& s) {
    render::FieldChoice& choice = s.view.display.settings.field;
    const int next = (static_cast<int>(choice.field) + 1) % render::kSurfaceFields;
    choice = {static_cast<render::SurfaceField>(next), std::nullopt, choice.map};
}

void toggleSection(State& s) {
    std::optional<render::SectionPlane>& section = s.view.display.settings.section;
    s.view.sectionTool.release();
    if (section) {
        section.reset();
    } else {
        section = sectionAcross(s.scene.meanwhile().bounds(), s.view.camera.destination());
    }
}

void toggleQuality(State& s) {
    render::Quality& quality = s.view.display.settings.quality;
    quality = quality == render::Quality::full ? render::Quality::light : render::Quality::full;
}

void showAbout(State& s) {
    const std::filesystem::path& settings = s.panels.settings.file();
    s.panels.asked = {{.title = "About Kerf",
                       .text = "Kerf " KERF_VERSION " cuts soft 3D models while they move.\n\n"
                               "Renderer: " +
                               s.panels.device + "\nDriver: " + s.panels.driver + "\nSettings: " +
                               (settings.empty() ? "not saved" : settings.string()),
                       .choices = {"Close"}},
                      [](int) {}};
}

/// What an action needs: nothing; something that is open, of which a picture is drawn anew,
/// whatever that is doing; or a body that rests between two steps.
enum class Needs { nothing, scene, body };

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

constexpr std::array kOtherHandlers{
    Handler{ActionId::newScene, Needs::nothing, showStart},
    Handler{ActionId::openFile, Needs::nothing, [](State& s) { s.browse(FilePurpose::open); }},
    Handler{ActionId::addModel, Needs::scene,
            [](State& s) { s.browse(FilePurpose::open, BrowseFor::addition); }},
    Handler{ActionId::reloadModels, Needs::body, [](State& s) { s.reloadModels(); }},
    Handler{ActionId::saveSession, Needs::scene, [](State& s) { s.saveSession(); }},
    Handler{ActionId::saveSessionAs, Needs::scene,
            [](State& s) { s.browse(FilePurpose::saveSession); }},
    Handler{ActionId::saveTest, Needs::scene, [](State& s) { s.askAboutTest(); }},
    Handler{ActionId::exportBody, Needs::scene,
            [](State& s) { s.browse(FilePurpose::exportMesh); }},
    Handler{ActionId::makeFilm, Needs::scene, [](State& s) { s.browse(FilePurpose::makeFilm); }},
    Handler{ActionId::screenshot, Needs::nothing,
            [](State& s) { s.redraw.screenshotWanted = true; }},
    Handler{ActionId::sceneScreenshot, Needs::body,
            [](State& s) { s.savePicture(s.picture.readScene(*s.scene, s.view), "kerf-scene"); }},
    Handler{ActionId::quit, Needs::nothing, [](State& s) { s.leave(); }},
    Handler{ActionId::undo, Needs::body, [](State& s) { stepThroughHistory(s, Undo{}); }},
    Handler{ActionId::redo, Needs::body, [](State& s) { stepThroughHistory(s, Redo{}); }},
    Handler{ActionId::cancel, Needs::nothing, cancel},
    Handler{ActionId::toggleGravity, Needs::body, toggleGravity},
    Handler{ActionId::remesh, Needs::body, [](State& s) { s.remesh({}); }},
    Handler{ActionId::partModel, Needs::body, [](State& s) { s.partModel(); }},
    Handler{ActionId::bringDown, Needs::scene,
            [](State& s) {
                if (!s.comesBack()) {
                    s.view.tools.inHand().trigger(s.view.context(s.scene.meanwhile()));
                }
            }},
    Handler{ActionId::freePins, Needs::body, freePins},
    Handler{ActionId::removeRetractor, Needs::body, removeRetractor},
    Handler{ActionId::playPause, Needs::scene, playOrPause},
    Handler{ActionId::letFall, Needs::body, letFall},
    Handler{ActionId::timeWhileCutting, Needs::nothing, toggleTimeWhileCutting},
    Handler{ActionId::stepOnce, Needs::body, stepOnce},
    Handler{ActionId::reset, Needs::body, reset},
    Handler{ActionId::finishTry, Needs::scene, [](State& s) { s.panels.practice.finish(); }},
    Handler{ActionId::slower, Needs::scene,
            [](State& s) { s.clock.setSpeed(s.clock.speed() / 2); }},
    Handler{ActionId::faster, Needs::scene,
            [](State& s) { s.clock.setSpeed(s.clock.speed() * 2); }},
    Handler{ActionId::record, Needs::body, toggleRecording},
    Handler{ActionId::loop, Needs::body, [](State& s) { s.scene->timeline().toggleLoop(); }},
    Handler{ActionId::addPicture, Needs::body, addPicture},
    Handler{ActionId::addCheck, Needs::body, addCheck},
    Handler{ActionId::addExport, Needs::body, addExport},
    Handler{ActionId::addCamera, Needs::body, addCamera},
    Handler{ActionId::useView, Needs::body, useView},
    Handler{ActionId::frameBody, Needs::scene,
            [](State& s) { s.view.flyToFrame(s.view.display.boundsOf(s.scene.meanwhile())); }},
    Handler{ActionId::resetView, Needs::scene,
            [](State& s) { s.view.camera.flyTo(s.view.homeView(s.scene.meanwhile())); }},
    Handler{ActionId::viewFront, Needs::scene, lookFrom<AxisView::front>},
    Handler{ActionId::viewBack, Needs::scene, lookFrom<AxisView::back>},
    Handler{ActionId::viewRight, Needs::scene, lookFrom<AxisView::right>},
    Handler{ActionId::viewLeft, Needs::scene, lookFrom<AxisView::left>},
    Handler{ActionId::viewTop, Needs::scene, lookFrom<AxisView::top>},
    Handler{ActionId::viewBottom, Needs::scene, lookFrom<AxisView::bottom>},
    Handler{ActionId::orthographic, Needs::scene,
            [](State& s) { s.view.camera.toggleOrthographic(); }},
    Handler{ActionId::wireframe, Needs::scene, toggle<&DisplaySettings::wireframe>},
    Handler{ActionId::showCutLines, Needs::scene, toggle<&DisplaySettings::cutLines>},
    Handler{ActionId::showAhead, Needs::scene, toggle<&DisplaySettings::cutAhead>},
    Handler{ActionId::showApart, Needs::body, toggleApart},
    Handler{ActionId::showEdges, Needs::scene, toggleOverlay<&Overlays::edges>},
    Handler{ActionId::showBends, Needs::scene, toggleOverlay<&Overlays::bends>},
    Handler{ActionId::showIspcs, Needs::scene, toggleOverlay<&Overlays::ispcs>},
    Handler{ActionId::showErrors, Needs::scene, toggleOverlay<&Overlays::errors>},
    Handler{ActionId::showContacts, Needs::scene, toggleOverlay<&Overlays::contacts>},
    Handler{ActionId::showBoxes, Needs::scene, toggleOverlay<&Overlays::boxes>},
    Handler{ActionId::nextField, Needs::scene, takeNextField},
    Handler{ActionId::section, Needs::scene, toggleSection},
    Handler{ActionId::fineQuality, Needs::scene, toggleQuality},
    Handler{ActionId::togglePanels, Needs::nothing, [](State& s) { s.panels.toggle(); }},
    Handler{ActionId::holdPlots, Needs::nothing, holdPlots},
    Handler{ActionId::fitPlots, Needs::nothing, [](State& s) { s.panels.plotView = {}; }},
    Handler{ActionId::help, Needs::nothing,
            [](State& s) { s.panels.helpOpen = !s.panels.helpOpen; }},
    Handler{ActionId::manual, Needs::nothing, [](State& s) { s.work.openManual(); }},
    Handler{ActionId::about, Needs::nothing, showAbout},
};
constexpr auto kHandlers = ui::withTools(kOtherHandlers, []<ui::ToolKind tool>() {
    return Handler{ui::actionOf(tool), Needs::scene, take<tool>};
});
static_assert(ui::coversActions(kHandlers), "an ActionId has no handler, or not at its place");

const Handler& handlerOf(ActionId id) {
    return kHandlers[static_cast<std::size_t>(id)];
}

template <class Kind, class... Others>
constexpr bool kIsOneOf = (std::is_same_v<Kind, Others> || ...);

/// Whether an action is to be done between two steps.
bool needsBody(const ui::Action& action) {
    if (const auto* id = std::get_if<ActionId>(&action)) {
        return handlerOf(*id).needs == Needs::body;
    }
    return std::visit(
        []<class Kind>(const Kind&) {
            return std::is_constructible_v<Command, Kind> ||
                   kIsOneOf<Kind, ui::PlaceBox, ui::GoToChange, ui::SeekTo, ui::RemoveMark,
                            ui::RemoveMeasure, ui::ExportPieces, ui::TakeMaterial,
                            ui::SaveMaterial>;
        },
        action);
}

// --- What the panels answer with ---------------------------------------------------------------

void exportPlots(State& s, bool asPicture) {
    using std::filesystem::path;
    const std::vector<ui::PlotSpec> plots =
        ui::chosenPlots(s.panels.model.plots, s.panels.model.settings);
    if (plots.empty()) {
        s.toast.show("No plots are shown, so there is nothing to save.", true);
    } else if (asPicture) {
        // Drawn here, since that needs OpenGL; encoded and written behind.
        s.savePicture(s.panels.drawPlots(plots), "kerf-plots");
    } else {
        s.work.saveBehind("kerf-plots", ".csv", [text = formatPlots(plots)](const path& file) {
            writeOutputFile(file, text);
        });
    }
}

void exportMeasures(State& s) {
    s.work.saveBehind("kerf-measures", ".csv",
                      [text = ui::measuresAsCsv(s.view.tools.get<MeasureTool>().rows())](
                          const std::filesystem::path& file) { writeOutputFile(file, text); });
}

void exportPieces(State& s) {
    s.work.saveBehind("kerf-pieces", ".csv",
                      [text = ui::piecesAsCsv(s.scene->readout().measurePieces())](
                          const std::filesystem::path& file) { writeOutputFile(file, text); });
}

/// Where it is seen; what has no room beside the panels is brought into view with the body.
void placeBox(State& s) {
    const Bounds body = s.scene->simulation().bounds();
    const ViewFrame frame = s.view.frame();
    const StaticBox box = boxInView(body, s.scene->simulation().params().floor, frame, s.view.free);
    if (!s.execute(AddBox{box})) {
        return;
    }
    s.view.tools.get<MoveTool>().chooseBox(static_cast<int>(s.scene->simulation().boxes().size()) -
                                           1);
    if (!isInView(box, frame, s.view.free)) {
        Bounds both = body;
        both.add(box.bounds());
        s.view.flyToFrame(both);
    }
}

void perform(State& s, ActionId id) {
    const Needs needs = handlerOf(id).needs;
    if (needs == Needs::nothing) {
        handlerOf(id).perform(s);
    } else if (s.scene != nullptr && !s.panels.startOpen) {
        handlerOf(id).perform(s);
        s.redraw.scene();
    }
}

/// Answers to each kind of ui::Action.
struct Answer {
    State& s;

    void operator()(ActionId id) const { perform(s, id); }
    void operator()(const ui::SetSpeed& wanted) const { s.clock.setSpeed(wanted.factor); }
    void operator()(const ui::SetDisplay& to) const { s.view.display.settings = to.settings; }
    void operator()(const ui::CancelWork&) const { cancelWork(s); }
    void operator()(const ui::AnswerQuestion& given) const { s.panels.answer(given.choice); }
    void operator()(const ui::FileAction& action) const {
        if (const std::optional<ChosenFile> chosen = s.chooser.take(action)) {
            s.take(*chosen);
        }
    }
    void operator()(const ui::SetSettings& to) const { s.panels.take(to.settings); }
    void operator()(const ui::SetPlotView& wanted) const { s.panels.plotView = wanted.view; }
    void operator()(const ui::ExportPlots& wanted) const { exportPlots(s, wanted.asPicture); }
    void operator()(const ui::ExportMeasures&) const { exportMeasures(s); }
    void operator()(const ui::OpenExperiment& wanted) const {
        const auto file = gpu::dataPath("assets/sessions/" + wanted.name + ".kerf.json");
        s.askBefore("Open " + wanted.name, [&s = s, file] {
            OpeningOrder order = orderOf(file, s.sessionFile.ends);
            order.atEnd = false;  // It is to be watched.
            s.open(std::move(order));
        });
    }
    void operator()(const ui::OpenStartScene& wanted) const { s.openStartScene(wanted.card); }
    void operator()(const ui::HoverPiece& hover) const { s.view.display.hover(hover.piece); }
    void operator()(const ui::ShowPiece& row) const { s.view.display.show(row.piece, row.visible); }
    template <class OnBody>
    void operator()(const OnBody& action) const {
        if (s.scene != nullptr) {
            onBody(action);
        }
    }

    // What needs an open document.
    void onBody(const Command& command) const {
        s.execute(countedFrom(command, s.scene->document().session.origin));
    }
    void onBody(const ui::PlaceModel& wanted) const {
        s.view.cancelTools(s.restingScene());
        s.place(s.scene->body().placeCommand(wanted.placement, wanted.continues, wanted.model));
    }
    void onBody(const ui::RemoveModel& wanted) const { s.removeModel(wanted.model); }
    void onBody(const ui::Remesh& wanted) const { s.remesh(wanted); }
    void onBody(const ui::UnitePieces& wanted) const { s.unitePieces(wanted.model); }
    void onBody(const ui::TakeMaterial& wanted) const { s.takeMaterial(wanted); }
    void onBody(const ui::SaveMaterial&) const { s.browseToSaveMaterial(); }
    void onBody(const ui::PlaceBox&) const { placeBox(s); }
    void onBody(const ui::GoToChange& wanted) const { s.goToChange(wanted.done); }
    void onBody(const ui::SeekTo& wanted) const {
        s.scene->seek(wanted.step);
        s.redraw.scene();
    }
    void onBody(const ui::RemoveMeasure& removal) const {
        MeasureTool& measures = s.view.tools.get<MeasureTool>();
        measures.remove(removal.id);
        if (!measures.plotsPoint()) {
            s.scene->readout().plot(std::nullopt);
        }
    }
    void onBody(const ui::RemoveMark& removal) const { s.scene->recorder().removeMark(removal.id); }
    void onBody(const ui::SetTools& wanted) const { setTools(s, wanted.settings); }
    void onBody(const ui::ExportPieces&) const { exportPieces(s); }
    void onBody(const ui::FramePiece& wanted) const {
        const Bounds piece = s.view.display.boundsOf(s.scene.meanwhile(), wanted.piece);
        if (!piece.empty()) {
            s.view.flyToFrame(piece);
        }
    }
};

}  // namespace

void Editor::State::apply(const ui::Action& action) {
    if (view.faulty && !panels.asked && needsBody(action)) {
        hideFaulty();
    }
    if (scene != nullptr && needsBody(action) && comesBack()) {
        toast.show("Your work is still being recovered. Please wait.", false);
    } else if (scene != nullptr && needsBody(action)) {
        scene.waiting.push_back(action);
        workOff();
    } else {
        answer(action);
    }
}

void Editor::State::answer(const ui::Action& action) {
    std::visit(Answer{*this}, action);
}

bool Editor::State::execute(const Command& command) {
    const bool steps =
        std::holds_alternative<Undo>(command) || std::holds_alternative<Redo>(command);
    render::ChosenColors& shown = view.display.settings.colors;
    const bool showsMaterial = steps && shown == colorsOfMaterial(*this);
    if (steps) {
        view.cancelTools(restingScene());  // Neither a stroke nor a pull goes on elsewhere.
    }
    const std::string problem = scene->execute(command);
    if (showsMaterial) {
        shown = colorsOfMaterial(*this);
    }
    say(problem);
    return problem.empty();
}

void Editor::State::say(const std::string& problem) {
    if (!problem.empty()) {
        toast.show(problem, true);
    }
    redraw.scene();
}

}  // namespace kerf::app
