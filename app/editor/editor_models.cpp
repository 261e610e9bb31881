// The scene on other models: what was done so far is repeated on them.
#include <spdlog/fmt/fmt.h>

#include "app/editor/editor_state.h"
#include "app/session/scene_origin.h"
#include "sim/base/text.h"
#include "sim/mesh/piece_labels.h"
#include "sim/run/parts/step_report.h"

namespace kerf::app {
namespace {

using State = Editor::State;
using std::filesystem::path;

/// What was done so far. Its checks hold for the models as they were alone.
Session doneSoFar(State& s) {
    SceneRecorder& recorder = s.scene->recorder();
    const Session& opened = s.scene->document().session;
    Session done =
        recorder.savedSession(s.view.camera.destination(), opened.colors, SavedAs::test).session;
    done.view = opened.view;
    if (s.scene->timeline().playback() == nullptr && s.scene->simulation().blade()) {
        done.events.push_back({done.steps, LiftBlade{}});  // of a stroke that was on its way
    }
    std::erase_if(done.events, [](const SessionEvent& event) {
        return std::holds_alternative<CheckEvent>(event.action);
    });
    return done;
}

/// The same scene with nothing done.
Session startOf(const EditorScene& scene) {
    Session start = scene.document().session;
    start.steps = start.events.empty() ? start.steps : 0;
    start.events.clear();
    return start;
}

/// What was made of a scene: by it, the same on other models is judged.
struct Outcome {
    int step = 0;
    std::ptrdiff_t cuts = 0;
    std::ptrdiff_t pieces = 0;
    std::ptrdiff_t parted = 0;  ///< pieces more than uncut
};

Outcome outcomeOf(const EditorScene& scene) {
    const Simulation& now = scene.simulation();
    const PieceLabels uncut(scene.rest().uncut().mesh, PieceLabels::Measures::none);
    const std::ptrdiff_t pieces = now.report().pieces;
    return {now.stepCount(), std::ranges::count_if(now.strokes(), &StrokeRecord::metBody), pieces,
            pieces - std::ssize(uncut.pieces())};
}

/// Drops what could not be done again. Returns how much that was.
std::size_t dropFailed(EventLog& journal) {
    std::vector<int> failed;
    for (const LogEntry& entry : journal.entries()) {
        if (entry.failed) {
            failed.push_back(entry.id);
        }
    }
    std::ranges::for_each(failed, [&](int id) { journal.remove(id); });
    return failed.size();
}

/// What differs from before, in sentences.
std::string differences(EditorScene& scene, const Outcome& before) {
    const Outcome now = outcomeOf(scene);
    std::string text;
    if (const std::size_t failed = dropFailed(scene.timeline().log()); failed > 0) {
        text = " " +
               counted(failed, "action no longer fits and was", "actions no longer fit and were") +
               " left out.";
    }
    if (now.cuts < before.cuts) {
        text += fmt::format(" {} of {} missed.", before.cuts - now.cuts,
                            counted(before.cuts, "cut", "cuts"));
    }
    if (now.parted != before.parted) {
        text += fmt::format(" The same cuts make {} now, instead of {}.",
                            counted(now.pieces, "piece", "pieces"),
                            now.pieces - now.parted + before.parted);
    }
    return text;
}

/// Reopens the scene by `order`, as a change that can be undone, and repeats what was done so far
/// if it `fits`. `told` says what was done.
void reopen(State& s, OpeningOrder order, const std::string& told, bool fits = true) {
    const auto before = std::make_shared<Outcome>();
    order.complete = [&s, before, fits](Document& document) {
        s.view.cancelTools(s.restingScene());
        Session done = doneSoFar(s);
        document.inFile =
            document.inFile && s.scene->recorder().deeds() == 0 && done.events.empty();
        if (!fits || done.events.empty()) {
            return;
        }
        *before = outcomeOf(*s.scene);
        before->step = s.scene->timeline().playback() == nullptr ? done.steps : before->step;
        done = withOrigin(std::move(done), document.session.origin);
        document.session.events = std::move(done.events);
        document.session.steps = done.steps;
    };
    order.shown = [&s, told, before] {
        s.scene->timeline().noteReopened();
        s.scene->seek(before->step);
        s.offers.comingBack = s.scene->timeline().seekSteps() > 0;
        s.scene.onceSought = [&s, told, before] {
            s.sceneHistory.noteRepeated(s.scene->simulation().history());
            const std::string& note = s.scene->document().note;
            const std::string gap = told.empty() || note.empty() ? "" : " ";
            s.toast.show(told + gap + note + differences(*s.scene, *before), false);
        };
    };
    s.open(std::move(order));
}

/// Whether what was done names this model, or one behind it, by its number.
bool names(const Session& done, int model) {
    return std::ranges::any_of(done.events, [&](const SessionEvent& event) {
        const auto* place = std::get_if<Place>(&event.action);
        const auto* set = std::get_if<SetParam>(&event.action);
        return place ? place->model >= model : set && modelOf(set->name) >= model;
    });
}

}  // namespace

void Editor::State::addModel(const path& file) {
    if (scene == nullptr) {
        open(file);
        return;
    }
    const double right =
        std::max(scene->rest().bounds().high.x(), scene->simulation().bounds().high.x());
    OpeningOrder order{"Adding " + file.filename().string(), file,
                       [name = scene->document().name, start = startOf(*scene), file,
                        right](const ReadOptions& options) {
                           return openWithModel(name, start, file, right, options);
                       }};
    order.change = "Add model";
    chooser.addRecent(file);
    reopen(*this, std::move(order), "");
}

void Editor::State::removeModel(int model) {
    Session left = startOf(*scene);
    const std::string what = left.moreModels.at(model - 1).model.name();
    takeModelOut(left, model);
    OpeningOrder order{"Removing " + what, left.model.file(),
                       [name = scene->document().name, left](const ReadOptions& options) {
                           return openScene(name, left, options);
                       }};
    order.change = "Remove model";
    const bool fits = !names(doneSoFar(*this), model);
    const auto next = [this, order, what, fits] {
        reopen(*this, order, "Removed " + what + ".", fits);
    };
    if (fits) {
        next();
        return;
    }
    askToSave(
        {order.title + " resets the scene",
         "Some of what was done since is about this model, so it can't be repeated without it. "
         "Undo restores it. You can also continue later from a saved session.",
         {"", "Reset and remove", "Cancel"}},
        next, next);
}

void Editor::State::reloadModels() {
    const auto all = app::modelFiles(scene->document().session);
    const auto changed = work.models.changed().empty() ? all : work.models.changed();
    const std::string what =
        joined(changed, ", ", [](const path& file) { return file.filename().string(); });
    work.models.ignore();
    Session start = startOf(*scene);
    start.model.sha256.clear();
    for (FurtherModel& further : start.moreModels) {
        further.model.sha256.clear();
    }
    OpeningOrder order{"Reloading " + what, changed.front(),
                       [name = scene->document().name, start](const ReadOptions& options) {
                           Session mended = start;
                           mended.model.add(options);
                           Document document = openScene(name, mended, options);
                           document.inFile = true;
                           return document;
                       }};
    order.change = "Reload";
    reopen(*this, std::move(order), "Reloaded " + what + ".");
}

}  // namespace kerf::app
