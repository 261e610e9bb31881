#include "app/editor/editor_state.h"
#include "app/editor/editor_task.h"
#include "app/editor/storage/file_saving.h"
#include "app/files/io/file_io.h"
#include "app/scene/editor_stroke.h"
#include "app/scene/held_hands.h"
#include "app/scene/readout/scene_readout.h"
#include "app/scene/timeline/hooks.h"
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
    const BusyScene before = s.scene.meanwhile();
    const int waiting = before.stroke().waiting();
    s.view.cancelTools(s.sceneOfTool(), true);
    if (before.pulling()) {
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
void stepThroughHistory(State& s, EditorScene& now, const Command& undoOrRedo) {
    const bool back = std::holds_alternative<Undo>(undoOrRedo);
    if (back ? s.undoesScene() : s.redoesScene()) {
        return;
    }
    if (back && now.timeline().hasForgotten()) {
        now.recallHistory();
        s.offers.comingBack = true;
        s.scene.onceSought = [&s] { s.apply(ui::ActionId::undo); };
        return;
    }
    if (!s.execute(undoOrRedo)) {
        return;
    }
    const UndoHistory& history = now.simulation().history();
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
void take(State& s, const BusyScene&) {
    ui::ToolSettings settings = s.view.tools.settings();
    settings.tool = tool;
    setTools(s, settings);
}

/// Holds what is shown now, or follows what comes.
void holdPlots(State& s) {
    std::optional<double>& end = s.panels.plotView.end;
    end = end ? std::nullopt : std::optional(s.panels.model.transport.time);
}

void freePins(State& s, EditorScene& now) {
    const Bounds everywhere{Vec3::Constant(-kEverywhere), Vec3::Constant(kEverywhere)};
    if (!now.simulation().pinnedVertices().empty()) {
        s.execute(Pin{everywhere, false});
    }
    if (!now.simulation().forces().empty()) {
        s.execute(ApplyForce{everywhere, Vec3::Zero()});
    }
}

void removeLoad(State& s, EditorScene& now, std::size_t row) {
    const std::vector<Load>& loads = now.readout().loads();
    if (row >= loads.size()) {
        return;
    }
    const Load load = loads[row];
    if (isHook(load.hand)) {
        now.hands().removeRetractor(load.hand);
    } else if (load.hand >= 0) {
        s.execute(Release{load.hand});
    } else {
        for (const Command& command : removalOf(load, now.simulation())) {
            s.execute(command);
        }
    }
}

void removeRetractor(State& s, EditorScene& now) {
    s.view.tools.get<RetractTool>().removeOne(s.view.context({&now, false}));
}

/// A hook that is in use goes before what is selected in a list.
void deleteSelected(State& s, EditorScene& now) {
    const BodyDisplay& shown = s.view.display;
    const bool hook =
        s.view.tools.settings().tool == ui::ToolKind::retract && !now.hands().hooks().empty();
    if (!hook && shown.loads.selected >= 0) {
        removeLoad(s, now, static_cast<std::size_t>(shown.loads.selected));
    } else if (!hook && shown.pieces.selected >= 0) {
        s.execute(RemovePiece{shown.pieces.selected});
    } else {
        removeRetractor(s, now);
    }
}

void toggleLink(State& s, EditorScene& now) {
    if (s.link.isOn()) {
        if (s.link.leads({&now, false})) {
            now.stroke().end();
        }
        s.link.stop();
        s.toast.show("The link is closed.", false);
        return;
    }
    try {
        s.link.start(now);
        s.toast.show(s.link.state(), false);
    } catch (const InputError& error) {
        s.toast.show(error.what(), true);
    }
}

void toggleGravity(State& s, EditorScene& now) {
    const bool on = now.simulation().params().gravity.norm() > 0;
    const Vec3 before = now.document().session.params.gravity;
    const Vec3 switchedOn = before.norm() > 0 ? before : kEarthGravity;
    s.execute(SetParam{"gravity", on ? Vec3(Vec3::Zero()) : switchedOn});
}

void letFall(State& s, EditorScene& now) {
    if (now.simulation().params().gravity.norm() == 0) {
        toggleGravity(s, now);
    }
    now.timeline().playing = true;
}

void toggleTimeWhileCutting(State& s) {
    bool& runs = s.panels.settings.now.timeRunsWhileCutting;
    runs = !runs;
}

void playOrPause(State&, const BusyScene& now) {
    bool& playing = now.playing();
    playing = !playing;
}

void stepOnce(State& s, EditorScene& now) {
    now.timeline().playing = false;
    s.clock.run(now, 1, 0);
}

void reset(State& s, EditorScene& now) {
    s.view.cancelTools({&now, false});
    now.reset();
}

void toggleRecording(State& s, EditorScene& now) {
    s.toast.withdrawOffer();
    if (now.recorder().recording()) {
        now.recorder().stop();
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
void addPicture(State& s, EditorScene& now) {
    const LogPosition place = s.toast.takeOffer().value_or(now.recorder().here());
    const std::string file = now.recorder().addPicture(place);
    tellAdded(s, "a picture", place.step, file);
}

void addCheck(State& s, EditorScene& now) {
    now.recorder().addCheck();
    tellAdded(s, "a check", now.recorder().here().step);
}

void addExport(State& s, EditorScene& now) {
    const std::string file = now.recorder().addExport();
    tellAdded(s, "an export", now.recorder().here().step, file);
}

void addCamera(State& s, EditorScene& now) {
    now.recorder().addCamera(s.view.camera.destination());
    tellAdded(s, "a camera keyframe", now.recorder().here().step);
}

void addName(State& s, EditorScene& now) {
    const int step = now.recorder().here().step;
    now.recorder().addName("Step " + std::to_string(step));
    s.toast.show("Named step " + std::to_string(step) + ". Type another name in Session.", false);
}

void useView(State& s, EditorScene& now) {
    now.recorder().useView(s.view.camera.destination());
    s.toast.show("Session pictures now use this view.", false);
}

template <AxisView axis>
void lookFrom(State& s, const BusyScene&) {
    s.view.camera.flyTo(axis);
}

template <bool ui::DisplaySettings::*member>
void toggle(State& s, const BusyScene&) {
    s.view.display.settings.*member = !(s.view.display.settings.*member);
}

template <bool render::Overlays::*member>
void toggleOverlay(State& s, const BusyScene&) {
    render::Overlays& overlays = s.view.display.settings.overlays;
    overlays.*member = !(overlays.*member);
}

void toggleApart(State& s, EditorScene& now) {
    double& apart = s.view.display.settings.apart;
    apart = apart > 0 || now.simulation().report().pieces < 2 ? 0 : kApart;
}

void takeNextField(State& s, const BusyScene&) {
    render::FieldChoice& choice = s.view.display.settings.field;
    const int next = (static_cast<int>(choice.field) + 1) % render::kSurfaceFields;
    choice = {static_cast<render::SurfaceField>(next), std::nullopt, choice.map};
}

void toggleSection(State& s, const BusyScene& now) {
    std::optional<render::SectionPlane>& section = s.view.display.settings.section;
    s.view.sectionTool.release();
    if (section) {
        section.reset();
    } else {
        section = sectionAcross(now.bounds(), s.view.camera.destination());
    }
}

void toggleQuality(State& s, const BusyScene&) {
    render::Quality& quality = s.view.display.settings.quality;
    quality = quality == render::Quality::full ? render::Quality::light : render::Quality::full;
}

void toggleTheme(State& s) {
    ui::Theme& theme = s.panels.settings.now.theme;
    theme = theme == ui::Theme::light ? ui::Theme::dark : ui::Theme::light;
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

/// The code behind an action, which takes what it needs: nothing; something that is open, of which
/// a picture is drawn anew, whatever that is doing; or a body that rests between two steps.
struct Handler {
    ui::ActionId id;
    std::variant<void (*)(State&), void (*)(State&, const BusyScene&),
                 void (*)(State&, EditorScene&)>
        perform;
};

using render::Overlays;
using ui::ActionId;
using ui::DisplaySettings;
using ui::FilePurpose;

constexpr std::array kOtherHandlers{
    Handler{ActionId::newScene, showStart},
    Handler{ActionId::openFile, [](State& s) { s.browse(FilePurpose::open); }},
    Handler{ActionId::addModel,
            [](State& s, const BusyScene&) { s.browse(FilePurpose::open, BrowseFor::addition); }},
    Handler{ActionId::reloadModels, [](State& s, EditorScene&) { s.reloadModels(); }},
    Handler{ActionId::saveSession, [](State& s, const BusyScene&) { s.saveSession(); }},
    Handler{ActionId::saveSessionAs,
            [](State& s, const BusyScene&) { s.browse(FilePurpose::saveSession); }},
    Handler{ActionId::saveTest, [](State& s, const BusyScene&) { s.askAboutTest(); }},
    Handler{ActionId::makeTask, [](State& s, EditorScene&) { makeTask(s); }},
    Handler{ActionId::exportBody,
            [](State& s, const BusyScene&) { s.browse(FilePurpose::exportMesh); }},
    Handler{ActionId::makeFilm,
            [](State& s, const BusyScene&) { s.browse(FilePurpose::makeFilm); }},
    Handler{ActionId::screenshot, [](State& s) { s.redraw.screenshotWanted = true; }},
    Handler{ActionId::sceneScreenshot,
            [](State& s, EditorScene& now) {
                s.savePicture(s.picture.readScene(now, s.view), "kerf-scene");
            }},
    Handler{ActionId::quit, [](State& s) { s.leave(); }},
    Handler{ActionId::undo, [](State& s, EditorScene& now) { stepThroughHistory(s, now, Undo{}); }},
    Handler{ActionId::redo, [](State& s, EditorScene& now) { stepThroughHistory(s, now, Redo{}); }},
    Handler{ActionId::cancel, cancel},
    Handler{ActionId::toggleGravity, toggleGravity},
    Handler{ActionId::remesh, [](State& s, EditorScene&) { s.remesh({}); }},
    Handler{ActionId::remeshCoarser,
            [](State& s, EditorScene& now) { s.remesh(now.body().coarser(ui::kFewTriangles)); }},
    Handler{ActionId::partModel, [](State& s, EditorScene&) { s.partModel(); }},
    Handler{ActionId::deleteSelected, deleteSelected},
    Handler{ActionId::bringDown,
            [](State& s, const BusyScene& now) {
                if (!s.comesBack()) {
                    s.view.tools.inHand().trigger(s.view.context(now));
                }
            }},
    Handler{ActionId::freePins, freePins},
    Handler{ActionId::link, toggleLink},
    Handler{ActionId::playPause, playOrPause},
    Handler{ActionId::letFall, letFall},
    Handler{ActionId::timeWhileCutting, toggleTimeWhileCutting},
    Handler{ActionId::stepOnce, stepOnce},
    Handler{ActionId::reset, reset},
    Handler{ActionId::finishTry, [](State& s, const BusyScene&) { s.panels.practice.finish(); }},
    Handler{ActionId::slower,
            [](State& s, const BusyScene&) { s.clock.setSpeed(s.clock.speed() / 2); }},
    Handler{ActionId::faster,
            [](State& s, const BusyScene&) { s.clock.setSpeed(s.clock.speed() * 2); }},
    Handler{ActionId::record, toggleRecording},
    Handler{ActionId::loop, [](State&, EditorScene& now) { now.timeline().toggleLoop(); }},
    Handler{ActionId::addPicture, addPicture},
    Handler{ActionId::addCheck, addCheck},
    Handler{ActionId::addExport, addExport},
    Handler{ActionId::addCamera, addCamera},
    Handler{ActionId::addMark, addName},
    Handler{ActionId::useView, useView},
    Handler{
        ActionId::frameBody,
        [](State& s, const BusyScene& now) { s.view.flyToFrame(s.view.display.boundsOf(now)); }},
    Handler{ActionId::resetView,
            [](State& s, const BusyScene& now) { s.view.camera.flyTo(s.view.homeView(now)); }},
    Handler{ActionId::viewFront, lookFrom<AxisView::front>},
    Handler{ActionId::viewBack, lookFrom<AxisView::back>},
    Handler{ActionId::viewRight, lookFrom<AxisView::right>},
    Handler{ActionId::viewLeft, lookFrom<AxisView::left>},
    Handler{ActionId::viewTop, lookFrom<AxisView::top>},
    Handler{ActionId::viewBottom, lookFrom<AxisView::bottom>},
    Handler{ActionId::orthographic,
            [](State& s, const BusyScene&) { s.view.camera.toggleOrthographic(); }},
    Handler{ActionId::wireframe, toggle<&DisplaySettings::wireframe>},
    Handler{ActionId::showCutLines, toggle<&DisplaySettings::cutLines>},
    Handler{ActionId::showAhead, toggle<&DisplaySettings::cutAhead>},
    Handler{ActionId::showApart, toggleApart},
    Handler{ActionId::showEdges, toggleOverlay<&Overlays::edges>},
    Handler{ActionId::showBends, toggleOverlay<&Overlays::bends>},
    Handler{ActionId::showIspcs, toggleOverlay<&Overlays::ispcs>},
    Handler{ActionId::showErrors, toggleOverlay<&Overlays::errors>},
    Handler{ActionId::showContacts, toggleOverlay<&Overlays::contacts>},
    Handler{ActionId::showBoxes, toggleOverlay<&Overlays::boxes>},
    Handler{ActionId::nextField, takeNextField},
    Handler{ActionId::section, toggleSection},
    Handler{ActionId::fineQuality, toggleQuality},
    Handler{ActionId::togglePanels, [](State& s) { s.panels.toggle(); }},
    Handler{ActionId::lightTheme, toggleTheme},
    Handler{ActionId::holdPlots, holdPlots},
    Handler{ActionId::fitPlots, [](State& s) { s.panels.plotView = {}; }},
    Handler{ActionId::findCommand,
            [](State& s) { s.panels.commandsOpen = !s.panels.commandsOpen; }},
    Handler{ActionId::help, [](State& s) { s.panels.helpOpen = !s.panels.helpOpen; }},
    Handler{ActionId::manual, [](State& s) { s.work.openManual(); }},
    Handler{ActionId::about, showAbout},
};
constexpr auto kHandlers = ui::withTools(kOtherHandlers, []<ui::ToolKind tool>() {
    return Handler{ui::actionOf(tool), take<tool>};
});
static_assert(ui::coversActions(kHandlers), "an ActionId has no handler, or not at its place");

const Handler& handlerOf(ActionId id) {
    return kHandlers[static_cast<std::size_t>(id)];
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

void exportPieces(State& s, EditorScene& now) {
    s.work.saveBehind("kerf-pieces", ".csv",
                      [text = ui::piecesAsCsv(now.readout().measurePieces())](
                          const std::filesystem::path& file) { writeOutputFile(file, text); });
}

/// Where it is seen; what has no room beside the panels is brought into view with the body.
void placeBox(State& s, EditorScene& now) {
    const Bounds body = now.simulation().bounds();
    const ViewFrame frame = s.view.frame();
    const StaticBox box = boxInView(body, now.simulation().params().floor, frame, s.view.free);
    if (!s.execute(AddBox{box})) {
        return;
    }
    s.view.tools.get<MoveTool>().chooseBox(static_cast<int>(now.simulation().boxes().size()) - 1);
    if (!isInView(box, frame, s.view.free)) {
        Bounds both = body;
        both.add(box.bounds());
        s.view.flyToFrame(both);
    }
}

void perform(State& s, ActionId id) {
    const auto& handler = handlerOf(id).perform;
    if (const auto* alone = std::get_if<void (*)(State&)>(&handler)) {
        (*alone)(s);
    } else if (s.scene != nullptr && !s.panels.startOpen) {
        if (const auto* onBody = std::get_if<void (*)(State&, EditorScene&)>(&handler)) {
            (*onBody)(s, *s.scene);
        } else {
            std::get<void (*)(State&, const BusyScene&)>(handler)(s, s.scene.meanwhile());
        }
        s.redraw.scene();
    }
}

/// Answers to each kind of ui::Action, by functions that take what they need.
struct Answer {
    State& s;

    /// Whether an action is to be done between two steps. `Answers` waits for the functions below.
    template <class Kind, class Answers = Answer>
    static constexpr bool kNeedsBody = requires(const Answers& answer, const Kind& action,
                                                EditorScene& now) {
        answer.onBody(action, now);
    };

    void operator()(ActionId id) const { perform(s, id); }
    void operator()(const ui::SetSpeed& wanted) const { s.clock.setSpeed(wanted.factor); }
    void operator()(const ui::SetDisplay& to) const { s.view.display.settings = to.settings; }
    void operator()(const ui::CancelWork&) const { cancelWork(s); }
    void operator()(const ui::AnswerQuestion& given) const {
        s.panels.answer(given.choice, given.number);
    }
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
    void operator()(const ui::HoverPiece& hover) const {
        s.view.display.pieces.hovered = hover.piece;
    }
    void operator()(const ui::SelectPiece& row) const {
        s.view.display.pieces.selected = row.piece;
    }
    void operator()(const ui::ColorPiece& row) const { s.view.display.color(row.piece, row.color); }
    void operator()(const ui::HoverLoad& hover) const { s.view.display.loads.hovered = hover.load; }
    void operator()(const ui::ShowPiece& row) const { s.view.display.show(row.piece, row.visible); }
    template <class Kind>
    void operator()(const Kind& action) const {
        if (s.scene == nullptr) {
            return;
        }
        if constexpr (kNeedsBody<Kind>) {
            onBody(action, *s.scene);
        } else {
            onScene(action, s.scene.meanwhile());
        }
    }

    // What needs an open document, whatever it is doing.
    void onScene(const ui::SelectLoad& row, const BusyScene& now) const {
        s.view.display.select(now.loads(), row.load);
    }
    void onScene(const ui::SetTools& wanted, const BusyScene&) const {
        setTools(s, wanted.settings);
    }
    void onScene(const ui::ExportSelectedPiece&, const BusyScene&) const {
        s.browse(FilePurpose::exportMesh, BrowseFor::selectedPiece);
    }
    void onScene(const ui::FramePiece& wanted, const BusyScene& now) const {
        const Bounds piece = s.view.display.boundsOf(now, wanted.piece);
        if (!piece.empty()) {
            s.view.flyToFrame(piece);
        }
    }

    // What needs a body that rests between two steps.
    void onBody(const Command& command, EditorScene& now) const {
        s.execute(countedFrom(command, now.document().session.origin));
    }
    void onBody(const ui::PlaceModel& wanted, EditorScene& now) const {
        s.view.cancelTools({&now, false});
        s.place(now.body().placeCommand(wanted.placement, wanted.continues, wanted.model));
    }
    void onBody(const ui::RemoveModel& wanted, EditorScene&) const { s.removeModel(wanted.model); }
    void onBody(const ui::ChangeTask& wanted, EditorScene&) const { changeTask(s, wanted.draft); }
    void onBody(const ui::Remesh& wanted, EditorScene&) const { s.remesh(wanted); }
    void onBody(const ui::UnitePieces& wanted, EditorScene&) const { s.unitePieces(wanted.model); }
    void onBody(const ui::TakeMaterial& wanted, EditorScene&) const { s.takeMaterial(wanted); }
    void onBody(const ui::SaveMaterial&, EditorScene&) const { s.browseToSaveMaterial(); }
    void onBody(const ui::PlaceBox&, EditorScene& now) const { placeBox(s, now); }
    void onBody(const ui::GoToChange& wanted, EditorScene&) const { s.goToChange(wanted.done); }
    void onBody(const ui::SeekTo& wanted, EditorScene& now) const {
        now.seek(wanted.step);
        s.redraw.scene();
    }
    void onBody(const ui::RemoveMeasure& removal, EditorScene& now) const {
        MeasureTool& measures = s.view.tools.get<MeasureTool>();
        measures.remove(removal.id);
        if (!measures.plotsPoint()) {
            now.readout().plot(std::nullopt);
        }
    }
    void onBody(const ui::RemoveMark& removal, EditorScene& now) const {
        now.recorder().removeMark(removal.id);
    }
    void onBody(const ui::RenameMark& wanted, EditorScene& now) const {
        now.timeline().log().rename(wanted.id, wanted.name);
    }
    void onBody(const ui::RemoveLoad& row, EditorScene& now) const { removeLoad(s, now, row.load); }
    void onBody(const ui::ExportPieces&, EditorScene& now) const { exportPieces(s, now); }
};

/// The piece that a command removes or brings back; -1 for none.
int pieceOf(const Command& command, const UndoHistory& history) {
    if (const auto* remove = std::get_if<RemovePiece>(&command)) {
        return remove->piece;
    }
    const bool undo = std::holds_alternative<Undo>(command);
    if (undo ? !history.canUndo() : !std::holds_alternative<Redo>(command) || !history.canRedo()) {
        return -1;
    }
    const UndoEntry& entry = undo ? history.lastDone() : history.firstUndone();
    const auto* change = std::get_if<UndoEntry::BodySnapshotChange>(&entry.change);
    return change != nullptr ? change->removedPiece : -1;
}

bool needsBody(const ui::Action& action) {
    if (const auto* id = std::get_if<ActionId>(&action)) {
        return std::holds_alternative<void (*)(State&, EditorScene&)>(handlerOf(*id).perform);
    }
    return std::visit([]<class Kind>(const Kind&) { return Answer::kNeedsBody<Kind>; }, action);
}

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
    const int piece = pieceOf(command, scene->simulation().history());
    const std::string problem = scene->execute(command);
    if (piece >= 0 && problem.empty()) {
        view.display.followRemoval(piece, std::holds_alternative<Undo>(command));
    }
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
