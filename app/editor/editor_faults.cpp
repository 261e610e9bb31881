// Models with faults in the view, and exchanging the scene for a better one as a step that is
// undone.
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include "app/editor/editor_state.h"
#include "app/files/import/model_units.h"
#include "app/scene/document/triangle_text.h"
#include "app/scene/timeline/scene_timeline.h"
#include "app/session/real_time_factor.h"
#include "app/tools/gizmo.h"
#include "sim/base/math.h"
#include "sim/base/text.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/triangle.h"
#include "ui/base/unit_text.h"
#include "ui/state/action_table.h"

namespace kerf::app {
namespace {

using State = Editor::State;

constexpr const char* kRemesh = "Remesh";
constexpr const char* kUnite = "Unite pieces";
constexpr const char* kPart = "Split into models";
constexpr const char* kRepair = "Repair";
constexpr const char* kThicken = "Thicken";

ModelReference& referenceOf(Session& session, int model) {
    return model == 0 ? session.model : session.moreModels.at(model - 1).model;
}

/// Of all models together.
TriangleFigures figuresOf(const EditorScene& scene) {
    TriangleFigures all;
    for (const ModelFigures& model : scene.rest().models()) {
        all.triangles += model.triangles.triangles;
        all.needles += model.triangles.needles;
    }
    return all;
}

std::string changeText(const TriangleFigures& before, const TriangleFigures& now) {
    return fmt::format("{} instead of {}, {} left", counted(now.triangles, "triangle", "triangles"),
                       before.triangles, counted(now.needles, "sliver", "slivers"));
}

/// The sentence of a fault with the name of the file alone, and without what a modelling tool could
/// do.
std::string shortSentence(const ModelFault& fault, const OpeningOrder& order) {
    std::string sentence = fault.what();
    if (const std::string whole = order.file.string(); sentence.starts_with(whole)) {
        sentence.replace(0, whole.size(), order.file.filename().string());
    }
    return sentence.substr(0, sentence.find(';'));
}

/// What would mend a model.
struct Help {
    Mending mending;
    std::string sentence;
    std::string button;
};

/// A thickness that is asked for, and how many of its units make one of the file.
struct AskedThickness {
    ui::AskedNumber field;
    double scale = 1;
};

/// In millimetres; of sessions the unit is not told. A round number comes first.
AskedThickness thicknessFor(const ModelFault& fault, const OpeningOrder& order) {
    AskedThickness asked{{.label = "Thickness", .unit = "file units"}};
    if (isModelFile(order.file) && fault.found() != nullptr) {
        const UnitGuess guess =
            guessUnits(order.file, boxOf(fault.found()->soup.positions), fault.found()->units);
        asked.field.unit = "mm";
        asked.scale = infoOf(guess.unit).metres / 1e-3;
    }
    const double most = fault.help().thickness * asked.scale;
    asked.field.value = roundStep(0.4 * most);  // at most all of it
    asked.field.least = 0.01 * asked.field.value;
    asked.field.most = 5 * most;
    return asked;
}

/// What suits the model best comes first.
std::vector<Help> helpFor(const ModelFault& fault) {
    const ModelHelp& model = fault.help();
    std::vector<Help> helps;
    if (model.holes > 0) {
        const std::string holes = counted(model.holes, "hole", "holes");
        helps.push_back(
            {{.fillHoles = true}, "Filling " + holes + " would close it", "Fill " + holes});
    } else if (!model.repairs.empty()) {
        helps.push_back({{.repair = true},
                         "A repair can fix it (" + kerf::joined(model.repairs, ", ") + ")",
                         kRepair});
    }
    if (model.thickness > 0) {
        helps.insert(model.isSheet ? helps.begin() : helps.end(),
                     {{.repair = true, .thicken = model.thickness},
                      "With a thickness it can be cut",
                      kThicken});
    }
    return helps;
}

/// Closes the scene; nothing is kept.
void closeScene(State& s) {
    s.leaveScene();
    s.keeping.discard();
    s.describeScene();
    s.redraw.scene();
}

/// Undoes the repair of the model on opening: shows its faults again.
void askAboutRepair(State& s) {
    const Mended& mended = *s.sceneHistory.mended;
    s.view.showFaulty(mended.fault, mended.order);
    s.panels.asked = {{.title = "Undone: " + mended.change,
                       .text = shortSentence(mended.fault, mended.order) +
                               ". Without this change it can't be cut.",
                       .choices = {"Redo", "Close model"},
                       .aside = s.view.faulty.has_value()},
                      [&s](int choice) {
                          s.hideFaulty();
                          if (choice == 0) {
                              s.toast.show("Redone: " + s.sceneHistory.mended->change, false);
                          } else {
                              s.askBefore("Close model", [&s] { closeScene(s); });
                          }
                      }};
    s.redraw.scene();
}

/// The largest distance of vertices, about 20,000 of them, from another surface [m].
double farthest(const std::vector<Vec3>& vertices, const SurfaceMesh& surface) {
    const std::size_t stride = 1 + vertices.size() / 20000;
    std::vector<int> triangles(surface.triangleSlots());
    std::iota(triangles.begin(), triangles.end(), 0);
    NearestTriangle nearest(triangles, [&](int t) { return restCornersOf(surface, t); });
    double most = 0;
    for (std::size_t v = 0; v < vertices.size(); v += stride) {
        most = std::max(most, (nearest.closestPoint(vertices[v]) - vertices[v]).norm());
    }
    return most;
}

/// A scene before its triangles were changed.
struct Before {
    explicit Before(const EditorScene& scene)
        : figures(figuresOf(scene)), body(scene.simulation().uncut()) {}
    TriangleFigures figures;
    std::shared_ptr<const UncutBody> body;
};

void tellOfExchange(State& s, const std::string& change, const Before& before) {
    const EditorScene& now = *s.scene;
    std::string outcome = change + ": ";
    outcome += change == kPart ? std::to_string(now.simulation().modelCount())
                               : changeText(before.figures, figuresOf(now));
    if (change == kRemesh) {
        outcome += fmt::format(
            "; the surface moved by up to {}",
            lengthText(farthest(before.body->mesh.restPositions(), now.rest().uncut().mesh)));
    }
    spdlog::info("{}: {}", s.scene->document().name, outcome);
    s.toast.offer(outcome, {ui::ActionId::undo, "Undo"});
}

/// Reopens the scene with `model` of `start`, as a change that can be undone.
void exchangeModel(State& s, const Session& start, const ModelReference& model,
                   const std::string& doing, const std::string& change) {
    const OpeningOrder order{
        doing, model.file(),
        [name = s.scene->document().name, start](const ReadOptions& options) {
            return openScene(name, start, options);
        },
        [&s, change, before = Before(*s.scene)] { tellOfExchange(s, change, before); }, change};
    if (s.panels.told.model.untouched && s.scene->document().session.events.empty()) {
        s.open(order);
        return;
    }
    s.panels.asked = {{.title = change + " and reset the cuts?",
                       .text = "Cuts and session events belong to the old triangles and are "
                               "removed. Undo restores them.",
                       .choices = {"Continue", "Cancel"}},
                      [&s, order](int choice) {
                          if (choice == 0) {
                              s.open(order);
                          }
                      }};
}

}  // namespace

// --- A model that can't be cut -----------------------------------------------------------------

void Editor::State::hideFaulty() {
    work.stopSearch();
    if (view.hideFaulty()) {
        redraw.scene();
    }
}

/// Only what would really help is offered.
void Editor::State::askAboutMending(const ModelFault& fault, const OpeningOrder& order) {
    const std::vector<Help> helps = helpFor(fault);
    if (helps.empty()) {
        return;
    }
    std::vector<std::string> choices;
    std::ranges::transform(helps, std::back_inserter(choices), &Help::button);
    choices.emplace_back("Cancel");
    const AskedThickness thickness = thicknessFor(fault, order);
    const bool thickens = fault.help().thickness > 0;
    const auto wanted = std::make_shared<double>(0);
    panels.asked = {
        {.title = "This model can't be cut as it is",
         .text = shortSentence(fault, order) + ". " + kerf::joined(helps, ". ", &Help::sentence) +
                 ". The file itself is not changed.",
         .choices = std::move(choices),
         .aside = view.faulty.has_value(),
         .number = thickens ? std::optional(thickness.field) : std::nullopt},
        [this, fault, order, helps, wanted](int choice) {
            hideFaulty();
            if (choice < static_cast<int>(helps.size())) {
                Mending mending = helps[choice].mending;
                mending.thicken = mending.thicken ? std::optional(*wanted) : std::nullopt;
                open(order, mending);
                sceneHistory.beingMended = Mended{fault, order, helps[choice].button};
            }
        },
        [wanted, scale = thickness.scale](double number) { *wanted = number / scale; }};
}

// --- Remeshing, pieces that cross --------------------------------------------------------------

void Editor::State::remesh(const ui::Remesh& wanted) {
    Session start = scene->body().start();
    ModelReference& reference = referenceOf(start, wanted.model);
    reference.remesh = true;
    const double edge = wanted.edge > 0 ? wanted.edge : scene->body().proposedEdge(wanted.model);
    reference.edge = std::stod(fmt::format("{:.3g}", edge));  // as it is shown
    exchangeModel(*this, start, reference, fmt::format("Remeshing {}", reference.name()), kRemesh);
}

namespace {

/// Says before the first step how long each will take, if that is longer than `bearable` [s].
std::string slownessText(const EditorScene& scene, double bearable) {
    constexpr int kLarge = 20000;  // triangles; fewer need no forecast
    const SurfaceMesh& mesh = scene.rest().uncut().mesh;
    if (!scene.document().guess || mesh.triangleSlots() < kLarge || !std::isfinite(bearable)) {
        return "";
    }
    const RealTimeForecast forecast = realTimeForecast(mesh, scene.simulation().params());
    const double seconds = forecast.timeStep / forecast.factor;
    return seconds < bearable
               ? ""
               : fmt::format(
                     " Slow on this computer: a step of {:.3g} ms takes about {:.2g} s, "
                     "{:.1g}\u00d7 real time. Fewer triangles are faster.",
                     1000 * forecast.timeStep, seconds, forecast.factor);
}

}  // namespace

/// A session was made on the triangles that its model has: only models are told to be coarse.
void Editor::State::tellOfModel(std::string note) {
    const ModelFigures& model = scene->rest().models().front();
    const double diagonal = model.bounds.diagonal();
    const bool coarse = scene->document().guess && isCoarse(model.triangles, diagonal);
    const std::string slow = slownessText(*scene, clock.slowStep());
    note += slow;
    if (coarse) {
        note += fmt::format(" {}. With edges of {} it bends and cuts well.",
                            coarseText(model.triangles, lengthText(model.triangles.longestEdge)),
                            lengthText(proposedEdge(model.triangles, diagonal)));
    }
    const std::size_t objects = scene->document().objects.size();
    if (scene->document().guess && objects > 1) {
        note += fmt::format(" The file contains {} objects.", objects);
    }
    if (!note.empty()) {
        spdlog::info("{}: {}", scene->document().name, note);
        !slow.empty()
            ? toast.offer(note, {ui::ActionId::remeshCoarser,
                                 std::string(ui::rowOf(ui::ActionId::remeshCoarser).label)})
        : coarse      ? toast.offer(note, {ui::ActionId::remesh, kRemesh})
        : objects > 1 ? toast.offer(note, {ui::ActionId::partModel, kPart})
                      : toast.show(note, false);
    }
}

void Editor::State::unitePieces(int model) {
    Session start = scene->body().start();
    ModelReference& reference = referenceOf(start, model);
    reference.repair = true;
    exchangeModel(*this, start, reference, fmt::format("Uniting pieces of {}", reference.name()),
                  kUnite);
}

void Editor::State::partModel() {
    const auto objects = static_cast<int>(scene->document().objects.size());
    if (objects > kMostModels) {
        toast.show(
            fmt::format("The file contains {} objects, but a scene can hold at most {} models.",
                        objects, kMostModels),
            true);
        return;
    }
    const Session start = parted(scene->body().start(), objects);
    exchangeModel(*this, start, start.model, "Splitting into models", kPart);
}

void Editor::State::exchange(UploadedDocument uploaded, const std::string& change) {
    // It may fail for want of memory; what is open stays then.
    auto next =
        std::make_unique<EditorScene>(std::move(uploaded.document), std::move(uploaded.body));
    view.cancelTools(restingScene());
    scene->timeline().playing = false;
    scene->timeline().stopSeeking();
    picture.depths.note(next->simulation().uncut(), std::move(uploaded.depth));
    picture.setBody(next->simulation().uncut());
    std::unique_ptr<EditorScene> old = scene.exchange(std::move(next));
    const int saved = keeping.savedDeeds();
    sceneHistory.add(change, std::move(old), saved);
    keeping.begin();
    view.beginAgain(*scene);
    beginScene();
}

bool Editor::State::undoesScene() {
    if (!sceneHistory.undoes(*scene) &&
        !(sceneHistory.mended && !scene->simulation().history().canUndo())) {
        return false;
    }
    sceneHistory.wanted = SceneHistory::Exchange::back;
    return true;
}

bool Editor::State::redoesScene() {
    if (!sceneHistory.redoes(*scene)) {
        return false;
    }
    sceneHistory.wanted = SceneHistory::Exchange::forth;
    return true;
}

void Editor::State::followExchange() {
    const SceneHistory::Exchange wanted =
        std::exchange(sceneHistory.wanted, SceneHistory::Exchange::none);
    if (wanted == SceneHistory::Exchange::none || scene == nullptr) {
        return;
    }
    const bool back = wanted == SceneHistory::Exchange::back;
    if (back && !sceneHistory.undoes(*scene)) {
        scene.waiting.clear();
        askAboutRepair(*this);
        return;
    }
    view.cancelTools(restingScene());
    scene->timeline().playing = false;
    scene->timeline().stopSeeking();
    const int saved = keeping.savedDeeds();
    SceneHistory::Next next = sceneHistory.go(wanted, scene.exchange(nullptr), saved);
    scene.exchange(std::move(next.scene));
    picture.setBody(scene->simulation().uncut());
    keeping.begin();
    keeping.noteSaved(next.savedDeeds);
    view.beginAgain(*scene);
    beginScene();
    toast.show((back ? "Undone: " : "Redone: ") + next.exchange, false);
}

// --- The history -------------------------------------------------------------------------------

void Editor::State::goToChange(std::size_t done) {
    const UndoHistory& history = scene->simulation().history();
    const std::size_t first = sceneHistory.rowsBefore();
    const std::size_t own = std::max(done, first) - first + sceneHistory.withoutRows(history);
    while (history.done() > own && history.canUndo()) {
        execute(Undo{});
    }
    while (history.done() < own && history.canRedo() && !sceneHistory.redoes(*scene)) {
        execute(Redo{});
    }
    const bool further = done < first ? undoesScene() : history.done() < own && redoesScene();
    if (further) {
        scene.waiting.emplace_front(ui::GoToChange{done});
        return;
    }
    toast.show(history.canUndo() ? "Now at: " + ui::withRaisedDigits(history.lastDone().name)
                                 : "Now at the start of the history",
               false);
}

void Editor::State::describeFaults() {
    ui::PanelModel& model = panels.model;
    if (scene != nullptr && model.display.overlays.faults && !view.faulty) {
        model.looks.faults = ui::faultRows(*scene.meanwhile().faultMarks());
    }
    if (view.faulty) {
        model.looks.showsFaulty = true;
        model.looks.faults = ui::faultRows(view.faulty->scene.marks());
        model.view.overlay = {};
        model.help.hint = {};
        if (!panels.asked) {
            model.help.hint = {view.faulty->order.file.filename().string() +
                                   " can't be cut because of these faults.",
                               {{ui::ActionId::cancel, "Back"}}};
        }
    }
}

}  // namespace kerf::app
