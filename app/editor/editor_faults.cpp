// Models with faults in the view, and exchanging the scene for a better one as a step that is
// undone.
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/editor/editor_state.h"
#include "app/files/import/model_units.h"
#include "app/scene/document/triangle_text.h"
#include "app/scene/timeline/scene_timeline.h"
#include "sim/base/quantity_text.h"
#include "sim/base/text.h"
#include "sim/repair/soup_editing.h"
#include "ui/action_table.h"
#include "ui/unit_text.h"

namespace kerf::app {
namespace {

constexpr const char* kRemesh = "Remesh";
constexpr const char* kUnite = "Unite pieces";
constexpr const char* kPart = "Part into models";
constexpr const char* kRepair = "Repair";
constexpr const char* kThicken = "Give it a thickness";

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
    return fmt::format("{} became {}, needles {} became {}",
                       counted(before.triangles, "triangle", "triangles"), now.triangles,
                       before.needles, now.needles);
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

/// A length in the file's unit, for people; of sessions the unit is not told.
std::string fileLength(double length, const ModelFault& fault, const OpeningOrder& order) {
    if (!isModelFile(order.file) || fault.found() == nullptr) {
        return fmt::format("{:g} in the unit of its file", length);
    }
    const UnitGuess guess =
        guessUnits(order.file, repair::boundsOf(fault.found()->soup), fault.found()->units);
    return lengthText(length * infoOf(guess.unit).metres);
}

/// What suits the model best comes first.
std::vector<Help> helpFor(const ModelFault& fault, const OpeningOrder& order) {
    const ModelHelp& model = fault.help();
    std::vector<Help> helps;
    if (model.holes > 0) {
        const std::string holes = counted(model.holes, "hole", "holes");
        helps.push_back(
            {{.fillHoles = true}, "Filling " + holes + " would close it", "Fill " + holes});
    } else if (!model.repairs.empty()) {
        helps.push_back({{.repair = true},
                         "A repair would help (" + kerf::joined(model.repairs, ", ") + ")",
                         kRepair});
    }
    if (model.thickness > 0) {
        helps.insert(
            model.isSheet ? helps.begin() : helps.end(),
            {{.repair = true, .thicken = model.thickness},
             "As a sheet of " + fileLength(model.thickness, fault, order) + " it could be cut",
             kThicken});
    }
    return helps;
}

}  // namespace

// --- A model that can't be cut -----------------------------------------------------------------

void Editor::State::showFaulty(const ModelFault& fault, const OpeningOrder& order) {
    hideFaulty();
    if (fault.found() == nullptr || fault.found()->soup.triangles.empty()) {
        return;
    }
    faulty.emplace(
        Faulty{fault, order, FaultyScene(*fault.found(), order.file), EditorCamera(view.camera)});
    constexpr double kShare = 0.62;  // of the view's height; the question stands below
    view.camera = EditorCamera(faulty->scene.camera());
    view.camera.flyToFrame(faulty->scene.bounds(), kShare);
    view.camera.advance(EditorCamera::kFlightSeconds);
    redraw.scene();
}

void Editor::State::hideFaulty() {
    if (faulty) {
        view.camera = faulty->before;
        faulty.reset();
        redraw.scene();
    }
}

/// Only what would really help is offered.
void Editor::State::askAboutMending(const ModelFault& fault, const OpeningOrder& order) {
    showFaulty(fault, order);
    const std::vector<Help> helps = helpFor(fault, order);
    if (helps.empty()) {
        toast.show(fault.what(), true);
        return;
    }
    std::vector<std::string> choices;
    std::ranges::transform(helps, std::back_inserter(choices), &Help::button);
    choices.emplace_back("Cancel");
    asked = {{.title = "This model can't be cut as it is",
              .text = shortSentence(fault, order) + ". " +
                      kerf::joined(helps, ". ", &Help::sentence) + "; the file stays as it is.",
              .choices = std::move(choices),
              .aside = faulty.has_value()},
             [this, fault, order, helps](int choice) {
                 hideFaulty();
                 if (choice < static_cast<int>(helps.size())) {
                     open(order, helps[choice].mending);
                     beingMended = Mended{fault, order, helps[choice].button};
                 }
             }};
}

void Editor::State::askAboutRepair() {
    showFaulty(mended->fault, mended->order);
    asked = {
        {.title = "Taken back: " + mended->change,
         .text = shortSentence(mended->fault, mended->order) + ". Without that it can't be cut.",
         .choices = {"Do it again", "Close the model"},
         .aside = faulty.has_value()},
        [this](int choice) {
            hideFaulty();
            if (choice == 0) {
                toast.show("Done again: " + mended->change + ".", false);
            } else {
                askBefore("Close the model", [this] { closeScene(); });
            }
        }};
    redraw.panels();
}

void Editor::State::closeScene() {
    leaveScene();
    keeping.discard();
    describeScene();
    redraw.scene();
}

// --- Remeshing, pieces that cross --------------------------------------------------------------

void Editor::State::remesh(const ui::Remesh& wanted) {
    Session start = scene->body().start();
    ModelReference& reference = referenceOf(start, wanted.model);
    reference.remesh = true;
    const double edge = wanted.edge > 0 ? wanted.edge : scene->body().proposedEdge(wanted.model);
    reference.edge = std::stod(fmt::format("{:.3g}", edge));  // as it is shown
    exchangeModel(start, reference, fmt::format("Remeshing {}", reference.name()), kRemesh);
}

/// A session was made on the triangles that its model has: only models are told to be coarse.
void Editor::State::tellOfModel(std::string note) {
    const ModelFigures& model = scene->rest().models().front();
    const double diagonal = model.bounds.diagonal();
    const bool coarse = scene->document().guess && isCoarse(model.triangles, diagonal);
    if (coarse) {
        note += fmt::format(" {}. With edges of {} it bends and cuts well.",
                            coarseText(model.triangles, lengthText(model.triangles.longestEdge)),
                            lengthText(proposedEdge(model.triangles, diagonal)));
    }
    const std::size_t objects = scene->document().objects.size();
    if (scene->document().guess && objects > 1) {
        note += fmt::format(" Its file has {} objects.", objects);
    }
    if (!note.empty()) {
        spdlog::info("{}: {}", scene->document().name, note);
        coarse        ? toast.offer(note, {ui::ActionId::remesh, kRemesh})
        : objects > 1 ? toast.offer(note, {ui::ActionId::partModel, kPart})
                      : toast.show(note, false);
    }
}

void Editor::State::unitePieces(int model) {
    Session start = scene->body().start();
    ModelReference& reference = referenceOf(start, model);
    reference.repair = true;
    exchangeModel(start, reference, fmt::format("Uniting the pieces of {}", reference.name()),
                  kUnite);
}

void Editor::State::partModel() {
    const auto objects = static_cast<int>(scene->document().objects.size());
    if (objects > kMostModels) {
        toast.show(fmt::format("The file has {} objects, and a scene holds {} models at most.",
                               objects, kMostModels),
                   true);
        return;
    }
    const Session start = parted(scene->body().start(), objects);
    exchangeModel(start, start.model, "Parting into models", kPart);
}

void Editor::State::exchangeModel(const Session& start, const ModelReference& model,
                                  const std::string& doing, const std::string& change) {
    const OpeningOrder order{doing, model.file(),
                             [name = scene->document().name, start](const ReadOptions& options) {
                                 return kerf::app::openScene(name, start, options);
                             },
                             nullptr, change};
    if (told.model.untouched && scene->document().session.events.empty()) {
        open(order);
        return;
    }
    asked = {
        {.title = "The scene begins anew: " + change,
         .text =
             "What was cut, and what a session does, goes with the old triangles. Undo brings all "
             "of it back.",
         .choices = {"Go on", "Cancel"}},
        [this, order](int choice) {
            if (choice == 0) {
                open(order);
            }
        }};
}

void Editor::State::exchange(UploadedDocument uploaded, const std::string& change) {
    // It may fail for want of memory; what is open stays then.
    auto next =
        std::make_unique<EditorScene>(std::move(uploaded.document), std::move(uploaded.body));
    const TriangleFigures before = figuresOf(*scene);
    const TriangleFigures now = figuresOf(*next);
    view.cancelTools(restingScene());
    scene->timeline().playing = false;
    scene->timeline().stopSeeking();
    picture.setRestDepth(uploaded.depth);
    std::unique_ptr<EditorScene> old = scene.exchange(std::move(next));
    depths.note(scene->simulation().uncut(), std::move(uploaded.depth));
    const int saved = keeping.savedDeeds();
    sceneSteps.add(change, std::move(old), saved);
    keeping.begin();
    view.beginAgain(*scene);
    beginScene();
    const std::string outcome =
        change == kPart ? fmt::format("{}: {} of them.", change, scene->simulation().modelCount())
                        : fmt::format("{}: {}.", change, changeText(before, now));
    spdlog::info("{}: {}", scene->document().name, outcome);
    toast.offer(outcome, {ui::ActionId::undo, "Undo"});
}

bool Editor::State::undoesScene() {
    if (!sceneSteps.undoes(*scene) && !(mended && !scene->simulation().history().canUndo())) {
        return false;
    }
    exchangeWanted = Exchange::back;
    return true;
}

bool Editor::State::redoesScene() {
    if (!sceneSteps.redoes(*scene)) {
        return false;
    }
    exchangeWanted = Exchange::forth;
    return true;
}

void Editor::State::followExchange() {
    const Exchange wanted = std::exchange(exchangeWanted, Exchange::none);
    if (wanted == Exchange::none || scene == nullptr) {
        return;
    }
    const bool back = wanted == Exchange::back;
    if (back && !sceneSteps.undoes(*scene)) {
        waiting.clear();
        askAboutRepair();
        return;
    }
    view.cancelTools(restingScene());
    scene->timeline().playing = false;
    scene->timeline().stopSeeking();
    const int saved = keeping.savedDeeds();
    std::unique_ptr<EditorScene> now = scene.exchange(nullptr);
    SceneSteps::Kept kept =
        back ? sceneSteps.undo(std::move(now), saved) : sceneSteps.redo(std::move(now), saved);
    scene.exchange(std::move(kept.scene));
    picture.setRestDepth(depths.of(scene->simulation().uncut()));
    keeping.begin();
    keeping.noteSaved(kept.savedDeeds);
    view.beginAgain(*scene);
    beginScene();
    toast.show((back ? "Taken back: " : "Done again: ") + kept.name + ".", false);
}

// --- The history -------------------------------------------------------------------------------

void Editor::State::goToChange(std::size_t done) {
    const UndoHistory& history = scene->simulation().history();
    const std::size_t first = rowsBefore();
    const std::size_t own = std::max(done, first) - first;
    while (history.done() > own && history.canUndo()) {
        execute(Undo{});
    }
    while (history.done() < own && history.canRedo() && !sceneSteps.redoes(*scene)) {
        execute(Redo{});
    }
    const bool further = done < first ? undoesScene() : history.done() < own && redoesScene();
    if (further) {
        waiting.emplace_front(ui::GoToChange{done});
        return;
    }
    toast.show(history.canUndo() ? "Gone to: " + ui::withRaisedDigits(history.lastDone().name) + "."
                                 : "Gone to the start of the history.",
               false);
}

void Editor::State::describeFaults() {
    ui::PanelModel& model = panels.model;
    if (scene != nullptr) {
        if (mended) {
            model.changes.rows.insert(model.changes.rows.begin(), ui::ChangeRow{mended->change, 0});
            ++model.changes.done;
        }
        if (model.display.overlays.faults && !faulty) {
            model.looks.faults = ui::faultRows(*scene.meanwhile().faultMarks());
        }
    }
    if (faulty) {
        model.looks.showsFaulty = true;
        model.looks.faults = ui::faultRows(faulty->scene.marks());
        model.view.overlay = {};
        model.help.hint = {};
        if (!asked) {
            model.help.hint = {
                faulty->order.file.filename().string() + " can't be cut: these are its faults.",
                {{ui::ActionId::cancel, "Back"}}};
        }
    }
}

}  // namespace kerf::app
