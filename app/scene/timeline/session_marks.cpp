#include "app/scene/timeline/session_marks.h"

#include "sim/base/params.h"
#include "sim/base/text.h"
#include "sim/run/undo/undo_history.h"
#include "ui/base/unit_text.h"

namespace kerf::app {
namespace {

using Kind = ui::SessionMark::Kind;

std::string textOf(const CheckEvent& check) {
    std::string pieces = check.pieces ? counted(*check.pieces, "piece", "pieces") : "";
    if (!check.hash) {
        return pieces;
    }
    return pieces.empty() ? "state" : pieces + ", state";
}

std::optional<ui::SessionMark> markOf(const JournalEntry& entry) {
    const SessionAction& action = entry.event.action;
    const int step = entry.event.step;
    if (const auto* picture = std::get_if<ScreenshotEvent>(&action)) {
        return ui::SessionMark{entry.id, step, Kind::picture, picture->file};
    }
    if (const auto* exported = std::get_if<ExportEvent>(&action)) {
        return ui::SessionMark{entry.id, step, Kind::exported, exported->file};
    }
    if (std::holds_alternative<CameraEvent>(action)) {
        return ui::SessionMark{entry.id, step, Kind::camera, ""};
    }
    const auto* check = std::get_if<CheckEvent>(&action);
    if (check == nullptr || entry.origin == JournalEntry::Origin::editor) {
        return std::nullopt;
    }
    return ui::SessionMark{entry.id, step, Kind::check, textOf(*check)};
}

/// "Gravity: none".
std::string nameOf(const SetParam& set) {
    const bool known = findParam(set.name) != nullptr;
    return known ? ui::withRaisedDigits(nameOfChange(set.name, set.value)) : set.name;
}

/// A slider that is dragged leaves many at a step.
void addChange(std::vector<ui::SessionMark>& marks, ui::SessionMark mark) {
    const auto label = [](const ui::SessionMark& m) { return m.text.substr(0, m.text.find(':')); };
    const bool again = !marks.empty() && marks.back().kind == Kind::change &&
                       marks.back().step == mark.step && label(marks.back()) == label(mark);
    if (again) {
        marks.pop_back();
    }
    marks.push_back(std::move(mark));
}

}  // namespace

std::vector<ui::SessionMark> marksOf(const SessionJournal& journal) {
    std::vector<ui::SessionMark> marks;
    for (const JournalEntry& entry : journal.entries()) {
        if (auto mark = markOf(entry)) {
            marks.push_back(std::move(*mark));
        }
    }
    return marks;
}

std::vector<ui::SessionMark> pastMarks(const SessionJournal& journal) {
    std::vector<ui::SessionMark> marks;
    bool down = false;
    int first = 0;  // entry of the stroke
    for (const JournalEntry& entry : journal.entries()) {
        const SessionAction& action = entry.event.action;
        const int step = entry.event.step;
        if (std::holds_alternative<MoveBlade>(action) && !std::exchange(down, true)) {
            first = entry.id;
            marks.push_back({entry.id, step, Kind::stroke, "Stroke"});
        } else if (takesBladeAway(action)) {
            down = false;
            if (entry.missed) {
                std::erase_if(marks, [&](const ui::SessionMark& m) { return m.id == first; });
            }
        } else if (const auto* set = std::get_if<SetParam>(&action)) {
            addChange(marks, {entry.id, step, Kind::change, nameOf(*set)});
        }
    }
    return marks;
}

std::string freeOutputName(const SessionJournal& journal, const std::string& name, int step,
                           const std::string& ending) {
    const std::string stem = name + "-" + std::to_string(step);
    std::string file = stem + ending;
    const auto isTaken = [&](const JournalEntry& entry) {
        const std::string* const taken = fileOf(entry.event.action);
        return taken != nullptr && *taken == file;
    };
    for (int n = 2; std::ranges::any_of(journal.entries(), isTaken); ++n) {
        file = stem;
        file.append("-").append(std::to_string(n)).append(ending);
    }
    return file;
}

}  // namespace kerf::app
