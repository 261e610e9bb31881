#include "app/editor/steps/scene_history.h"

#include "app/scene/timeline/scene_timeline.h"
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
    scenes_ = std::vector<Kept>(1);
    at_ = 0;
    letGo_ = 0;
    wanted = Exchange::none;
    mended.reset();
}

void SceneHistory::add(std::string name, std::unique_ptr<EditorScene> before, int savedDeeds) {
    scenes_.resize(at_ + 1);
    const int additions = historyOf(*before).additions();
    const std::size_t undone = undoneOf(*before);
    scenes_[at_].scene = std::move(before);
    scenes_[at_].savedDeeds = savedDeeds;
    scenes_.push_back({std::move(name), nullptr, 0, additions, undone});
    if (scenes_.size() > kMost + 1) {
        letGo_ += 1 + static_cast<int>(historyOf(*scenes_.front().scene).done());
        scenes_.erase(scenes_.begin());
        scenes_.front().repeated = 0;
        scenes_.front().name.clear();
    }
    at_ = scenes_.size() - 1;
}

void SceneHistory::noteRepeated(const UndoHistory& now) {
    if (at_ > 0) {
        scenes_[at_].repeated = static_cast<std::size_t>(now.forgotten()) + now.done();
    }
}

void SceneHistory::follow(const UndoHistory& now) {
    if (undone(now) == nullptr) {
        scenes_.resize(at_ + 1);
    }
}

const SceneHistory::Kept* SceneHistory::undone(const UndoHistory& now) const {
    const bool comesBack =
        at_ + 1 < scenes_.size() && scenes_[at_ + 1].additions == now.additions();
    return comesBack ? &scenes_[at_ + 1] : nullptr;
}

bool SceneHistory::undoes(const EditorScene& now) const {
    return at_ > 0 && historyOf(now).done() <= withoutRows(historyOf(now));
}

bool SceneHistory::redoes(const EditorScene& now) const {
    const Kept* next = undone(historyOf(now));
    return next != nullptr && next->undone == undoneOf(now);
}

SceneHistory::Next SceneHistory::go(Exchange where, std::unique_ptr<EditorScene> now,
                                    int savedDeeds) {
    scenes_[at_].scene = std::move(now);
    scenes_[at_].savedDeeds = savedDeeds;
    const std::size_t from = where == Exchange::back ? at_-- : ++at_;
    return {scenes_[from].name, std::move(scenes_[at_].scene), scenes_[at_].savedDeeds};
}

std::size_t SceneHistory::rowsBefore() const {
    return rowsOfBefore().size();
}

std::size_t SceneHistory::withoutRows(const UndoHistory& now) const {
    return keptOf(scenes_[at_].repeated, now);
}

std::vector<ui::ChangeRow> SceneHistory::rowsOfBefore() const {
    std::vector<ui::ChangeRow> rows;
    if (mended) {
        rows.push_back({mended->change, 0});
    }
    for (std::size_t k = 0; k < at_; ++k) {
        addRows(*scenes_[k].scene, scenes_[k].repeated, scenes_[k + 1].undone, rows);
        rows.push_back({scenes_[k + 1].name, timeOf(*scenes_[k].scene)});
    }
    return rows;
}

void SceneHistory::describe(const EditorScene& now, ui::ChangeList& list) const {
    std::vector<ui::ChangeRow> rows = rowsOfBefore();
    list.done += rows.size() - std::min(withoutRows(historyOf(now)), list.done);
    const std::size_t end = undone(historyOf(now)) != nullptr ? scenes_.size() : at_ + 1;
    for (std::size_t k = at_; k < end; ++k) {
        if (k > at_) {
            rows.push_back({scenes_[k].name, 0});
        }
        addRows(k > at_ ? *scenes_[k].scene : now, scenes_[k].repeated,
                k + 1 < end ? scenes_[k + 1].undone : 0, rows);
    }
    list.rows = std::move(rows);
    list.forgotten += letGo_;
    for (const Kept& kept : scenes_) {
        if (kept.scene) {
            list.bytes += historyOf(*kept.scene).bytes();
            list.checkpoints += kept.scene->timeline().checkpointBytes();
        }
    }
}

}  // namespace kerf::app
