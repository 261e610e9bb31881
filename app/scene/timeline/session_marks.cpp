#include "app/scene/timeline/session_marks.h"

#include "app/scene/timeline/hooks.h"
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

std::optional<ui::SessionMark> markOf(const LogEntry& entry) {
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
    if (const auto* named = std::get_if<MarkEvent>(&action)) {
        return ui::SessionMark{entry.id, step, Kind::name, named->name};
    }
    const auto* check = std::get_if<CheckEvent>(&action);
    if (check == nullptr || entry.origin == LogEntry::Origin::editor) {
        return std::nullopt;
    }
    return ui::SessionMark{entry.id, step, Kind::check, textOf(*check)};
}

/// "Gravity: none".
std::string nameOf(const SetParam& set) {
    const bool known = findParam(set.name) != nullptr;
    return known ? ui::withRaisedDigits(nameOfChange(set.name, set.value)) : set.name;
}

/// How an action that is no stroke is marked; without a text, not at all.
struct Told {
    std::pair<Kind, std::string> operator()(const SetParam& set) const {
        return {Kind::change, nameOf(set)};
    }
    std::pair<Kind, std::string> operator()(const Grab& grab) const {
        const bool second = isHook(grab.hand) && partnerOf(grab.hand) < grab.hand;
        return {Kind::hand, second ? "" : isHook(grab.hand) ? "Hold open" : "Pull"};
    }
    std::pair<Kind, std::string> operator()(const Pin& pin) const {
        return {Kind::hand, pin.velocity ? "Move" : pin.pinned ? "Pin" : "Free pins"};
    }
    std::pair<Kind, std::string> operator()(const MovePins&) const {
        return {Kind::hand, "Move pins"};
    }
    std::pair<Kind, std::string> operator()(const ApplyForce& force) const {
        return {Kind::hand, force.newtons.isZero() ? "Remove force" : "Force"};
    }
    std::pair<Kind, std::string> operator()(const AddBox&) const {
        return {Kind::scene, "Box added"};
    }
    std::pair<Kind, std::string> operator()(const ChangeBox& box) const {
        return {Kind::scene, "Box " + std::to_string(box.index) + " changed"};
    }
    std::pair<Kind, std::string> operator()(const RemoveBox& box) const {
        return {Kind::scene, "Box " + std::to_string(box.index) + " removed"};
    }
    std::pair<Kind, std::string> operator()(const RemovePiece& removed) const {
        return {Kind::scene, "Piece " + std::to_string(removed.piece + 1) + " deleted"};
    }
    std::pair<Kind, std::string> operator()(const Place&) const {
        return {Kind::scene, "Placement"};
    }
    std::pair<Kind, std::string> operator()(const Restart&) const {
        return {Kind::scene, "Restart"};
    }
    std::pair<Kind, std::string> operator()(const Undo&) const { return {Kind::scene, "Undo"}; }
    std::pair<Kind, std::string> operator()(const Redo&) const { return {Kind::scene, "Redo"}; }
    std::pair<Kind, std::string> operator()(const auto&) const { return {}; }
};

/// What is dragged leaves many at a step.
void addChange(std::vector<ui::SessionMark>& marks, ui::SessionMark mark) {
    const auto label = [](const ui::SessionMark& m) { return m.text.substr(0, m.text.find(':')); };
    const bool again = !marks.empty() && marks.back().kind == mark.kind &&
                       marks.back().step == mark.step && label(marks.back()) == label(mark);
    if (again) {
        marks.pop_back();
    }
    marks.push_back(std::move(mark));
}

}  // namespace

std::vector<ui::SessionMark> marksOf(const EventLog& log) {
    std::vector<ui::SessionMark> marks;
    for (const LogEntry& entry : log.entries()) {
        if (auto mark = markOf(entry)) {
            marks.push_back(std::move(*mark));
        }
    }
    return marks;
}

std::vector<ui::SessionMark> pastMarks(const EventLog& log) {
    std::vector<ui::SessionMark> marks;
    bool down = false;
    int first = 0;  // entry of the stroke
    for (const LogEntry& entry : log.entries()) {
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
        }
        if (auto [kind, text] = std::visit(Told{}, action); !text.empty()) {
            addChange(marks, {entry.id, step, kind, std::move(text)});
        }
    }
    for (const int step : log.tears()) {
        marks.push_back({0, step, Kind::tear, "Tear"});
    }
    std::ranges::stable_sort(marks, {}, &ui::SessionMark::step);
    return marks;
}

std::string freeOutputName(const EventLog& log, const std::string& name, int step,
                           const std::string& ending) {
    const std::string stem = name + "-" + std::to_string(step);
    std::string file = stem + ending;
    const auto isTaken = [&](const LogEntry& entry) {
        const std::string* const taken = fileOf(entry.event.action);
        return taken != nullptr && *taken == file;
    };
    for (int n = 2; std::ranges::any_of(log.entries(), isTaken); ++n) {
        file = stem;
        file.append("-").append(std::to_string(n)).append(ending);
    }
    return file;
}

}  // namespace kerf::app
