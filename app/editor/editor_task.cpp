// A task that is made in the window of what was cut.
#include "app/editor/editor_task.h"

#include "app/editor/view/new_task.h"
#include "app/files/io/file_io.h"
#include "app/session/session_json.h"
#include "app/session/task_run.h"

namespace kerf::app {
namespace {

constexpr char kExpertEnding[] = ".expert.kerf.json";
constexpr double kEconomy = 0.5;  // of the expert's path over that of a pupil

SavedSession savedSoFar(Editor::State& s) {
    return s.scene->recorder().savedSession(s.view.camera.destination(),
                                            s.view.display.settings.colors);
}

/// What nothing pins would fall, or give way, and the line would leave the blade.
void keepInPlace(Session& start) {
    start.params.gravity = Vec3::Zero();
    start.params.bladeFeels = 0;
    std::erase_if(start.events, [](const SessionEvent& event) {
        const auto* set = std::get_if<SetParam>(&event.action);
        return set != nullptr && (set->name == "gravity" || set->name == "blade_feels");
    });
}

/// Writes the try that passed, with its score, beside the file of the task.
void saveExpert(const std::filesystem::path& file, Practice::ScoredTry shown, Task& task) {
    const std::filesystem::path expert =
        file.parent_path() / (shortName(file) + std::string(kExpertEnding));
    Task& its = *shown.session.task;
    if (shown.score.path) {
        task.path = its.path = shown.score.path;
        task.limits.economy = its.limits.economy = kEconomy;
        shown.score.economy = 1;  // It is the measure.
    }
    its.person = "expert";
    writeOutputFile(expert, formatSession(shown.session, expert.parent_path()));
    writeOutputFile(scoreFileOf(expert), toJson(shown.score, its).dump(2) + "\n");
    task.expert = expert;
}

}  // namespace

void makeTask(Editor::State& s) {
    Session done = savedSoFar(s).session;
    const render::Camera camera = s.view.camera.destination();
    auto made = taskOfCuts(done, *s.scene->simulation().uncut(), camera.eye);
    if (const auto* problem = std::get_if<std::string>(&made)) {
        s.say(*problem);
        return;
    }
    Session start = beforeCuts(std::move(done));
    start.steps = start.events.empty() ? 0 : std::max(1, start.steps);
    start.task = std::get<Task>(std::move(made));
    start.view = camera;
    start.params.bladeFeels = 1;  // The edge follows the blade as in the tasks of the start page.
    const bool loose = s.scene->simulation().pinnedVertices().empty();
    if (loose) {
        keepInPlace(start);
    }
    OpeningOrder order{"Making the task", start.model.file(),
                       [name = s.scene->document().name, start](const ReadOptions& options) {
                           Document document = openScene(name, start, options);
                           document.makesTask = true;
                           return document;
                       }};
    order.change = "Make task";
    order.atEnd = !start.events.empty();
    order.shown = [&s, loose] {
        s.sessionFile.begin({});
        s.view.takeToolsOf(*s.scene->document().session.task);
        s.panels.unfold("practice");
        s.toast.show(
            "This is the task now. Try it, set its limits under Practice, and save it." +
                std::string(loose ? " Nothing is pinned, so gravity and the blade's force are off."
                                  : ""),
            false);
    };
    s.open(std::move(order));
}

void changeTask(Editor::State& s, const ui::TaskDraft& draft) {
    if (!s.scene->document().makesTask) {
        return;
    }
    Task& task = *s.scene->body().document.session.task;
    const std::vector<int> spared = task.spare;
    task.name = draft.name;
    const bool ownWords = draft.about != aboutOf(task);
    task.depth = draft.depth > 0 ? std::optional(draft.depth) : std::nullopt;
    task.band = kBand * draft.depth;
    task.about = ownWords ? draft.about : aboutOf(task);
    task.limits.inBand =
        task.depth ? std::optional(task.limits.inBand.value_or(kInBand)) : std::nullopt;
    task.limits.deviation = draft.deviation;
    task.limits.seconds = draft.seconds > 0 ? std::optional(draft.seconds) : std::nullopt;
    task.spare.clear();
    for (const ui::TaskDraft::Spared& model : draft.models) {
        if (model.spared) {
            task.spare.push_back(model.model);
        }
    }
    s.view.takeToolsOf(task);
    s.panels.practice.change(s.scene->document(), task.spare != spared);
}

void leaveTask(const Editor::State& s, const std::filesystem::path& file, SavedSession& saved) {
    saved.session = beforeCuts(std::move(saved.session));
    saved.session.steps = std::max(1, saved.session.steps);
    std::string& name = saved.session.task->name;
    name = name.empty() ? "Cut" : name;
    if (s.panels.practice.passed()) {
        try {
            saveExpert(file, *s.panels.practice.passed(), *saved.session.task);
        } catch (const std::exception& problem) {
            saved.remark += std::string(saved.remark.empty() ? "" : " ") +
                            "The expert's try was not saved: " + problem.what();
        }
    }
}

}  // namespace kerf::app
