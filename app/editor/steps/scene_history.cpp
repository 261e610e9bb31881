#include "app/editor/steps/scene_history.h"

#include "sim/run/simulation.h"
#include "sim/run/undo/undo_history.h"
#include "ui/base/unit_text.h"

namespace kerf::app {
namespace {

const UndoHistory& historyOf(const EditorScene& scene) {
    return scene.simulation().history();
}

std::size_t undoneOf(const EditorScene& scene) {
    const UndoHistory& history = historyOf(scene);
    return history.entries().size() - history.done();
}

/// How many of the first `repeated` changes are not forgotten.
std::size_t keptOf(std::size_t repeated, const UndoHistory& history) {
    return repeated - std::min(repeated, static_cast<std::size_t>(history.forgotten()));
}

/// All changes of a scene but the first `repeated` and the last `without`.
void addRows(const EditorScene& scene, std::size_t repeated, std::size_t without,
             std::vector<ui::ChangeRow>& rows) {
    const std::vector<UndoEntry>& entries = historyOf(scene).entries();
    for (std::size_t i = keptOf(repeated, historyOf(scene)); i + without < entries.size(); ++i) {
        rows.push_back({ui::withRaisedDigits(entries[i].name), entries[i].time});
    }
}

double timeOf(const EditorScene& scene) {
    return scene.simulation().report().time;
}

}  // namespace

void SceneHistory::clear() {
    before_.clear();
    after_.clear();
    wanted = Exchange::none;
    mended.reset();
}

void SceneHistory::add(std::string name, std::unique_ptr<EditorScene> before, int savedDeeds) {
    after_.clear();
    const int additions = historyOf(*before).additions();
    const std::size_t undone = undoneOf(*before);
    before_.push_back({std::move(name), std::move(before), savedDeeds, additions, undone});
    if (before_.size() > kMost) {
        before_.erase(before_.begin());
    }
}

void SceneHistory::noteRepeated(const UndoHistory& now) {
    if (!before_.empty()) {
        before_.back().repeated = static_cast<std::size_t>(now.forgotten()) + now.done();
    }
}

void SceneHistory::follow(const UndoHistory& now) {
    if (!after_.empty() && after_.back().additions != now.additions()) {
        after_.clear();
    }
}

bool SceneHistory::undoes(const EditorScene& now) const {
    return !before_.empty() && historyOf(now).done() <= withoutRows(historyOf(now));
}

bool SceneHistory::redoes(const EditorScene& now) const {
    return !after_.empty() && after_.back().additions == historyOf(now).additions() &&
           after_.back().undone == undoneOf(now);
}

SceneHistory::Kept SceneHistory::undo(std::unique_ptr<EditorScene> now, int savedDeeds) {
    Kept back = std::move(before_.back());
    before_.pop_back();
    after_.push_back(
        {back.name, std::move(now), savedDeeds, back.additions, back.undone, back.repeated});
    return back;
}

SceneHistory::Kept SceneHistory::redo(std::unique_ptr<EditorScene> now, int savedDeeds) {
    Kept next = std::move(after_.back());
    after_.pop_back();
    before_.push_back(
        {next.name, std::move(now), savedDeeds, next.additions, next.undone, next.repeated});
    return next;
}

std::size_t SceneHistory::rowsBefore() const {
    return rowsOfBefore().size();
}

std::size_t SceneHistory::withoutRows(const UndoHistory& now) const {
    return keptOf(before_.empty() ? 0 : before_.back().repeated, now);
}

std::vector<ui::ChangeRow> SceneHistory::rowsOfBefore() const {
    std::vector<ui::ChangeRow> rows;
    if (mended) {
        rows.push_back({mended->change, 0});
    }
    std::size_t repeated = 0;
    for (const Kept& kept : before_) {
        addRows(*kept.scene, repeated, kept.undone, rows);
        rows.push_back({kept.name, timeOf(*kept.scene)});
        repeated = kept.repeated;
    }
    return rows;
}

void SceneHistory::describe(const EditorScene& now, ui::ChangeList& list) const {
    std::vector<ui::ChangeRow> rows = rowsOfBefore();
    const std::size_t without = withoutRows(historyOf(now));
    list.done += rows.size() - std::min(without, list.done);
    const bool comesBack = !after_.empty() && after_.back().additions == historyOf(now).additions();
    const std::size_t repeated = before_.empty() ? 0 : before_.back().repeated;
    addRows(now, repeated, comesBack ? after_.back().undone : 0, rows);
    for (std::size_t k = comesBack ? after_.size() : 0; k-- > 0;) {
        rows.push_back({after_[k].name, 0});
        addRows(*after_[k].scene, after_[k].repeated, k > 0 ? after_[k - 1].undone : 0, rows);
    }
    list.rows = std::move(rows);
    for (const Kept& kept : before_) {
        list.bytes += historyOf(*kept.scene).bytes();
    }
}

}  // namespace kerf::app
