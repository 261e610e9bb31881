#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include "sim/base/text.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

constexpr double kBytesPerMegabyte = 1e6;

/// The state after the first `done` changes.
void drawState(const PanelModel& model, const std::string& name, std::size_t done,
               std::vector<Action>& actions) {
    const ChangeList& changes = model.changes;
    ImGui::PushID(static_cast<int>(done));
    const bool undone = done > changes.done;
    if (undone) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    }
    if (ImGui::Selectable(name.c_str(), done == changes.done) && done != changes.done) {
        actions.emplace_back(GoToChange{done});
    }
    if (undone) {
        ImGui::PopStyleColor();
    }
    if (done == changes.done && ImGui::IsWindowAppearing()) {
        ImGui::SetScrollHereY();
    }
    ImGui::PopID();
}

/// There may be thousands: only those in view are drawn, and the one to scroll to.
void drawRows(const PanelModel& model, std::vector<Action>& actions) {
    const ChangeList& changes = model.changes;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(changes.rows.size()));
    if (ImGui::IsWindowAppearing() && changes.done > 0) {
        const int shown = static_cast<int>(changes.done) - 1;
        clipper.ForceDisplayRangeByIndices(shown, shown + 1);
    }
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            drawState(model,
                      fmt::format("{:8.3f} s  {}", changes.rows[i].time, changes.rows[i].name),
                      static_cast<std::size_t>(i) + 1, actions);
        }
    }
}

void drawButton(const PanelModel& model, const char* label, ActionId id, float width,
                std::vector<Action>& actions) {
    ImGui::BeginDisabled(!isAvailable(model, id));
    if (ImGui::Button(label, {width, 0})) {
        actions.emplace_back(id);
    }
    ImGui::EndDisabled();
    itemTooltip(describeAction(id));
}

std::string nameOfStart(const ChangeList& changes) {
    if (changes.recallable) {
        return "Earlier changes: undo replays the session first";
    }
    return changes.forgotten > 0
               ? counted(changes.forgotten, "older change", "older changes") + " can't be undone"
               : "Start";
}

void drawMemory(const ChangeList& changes) {
    const auto used = static_cast<double>(changes.bytes);
    const auto budget = static_cast<double>(changes.budget);
    const std::string text = fmt::format("Undo memory: {:.0f} of {:.0f} MB",
                                         used / kBytesPerMegabyte, budget / kBytesPerMegabyte);
    const double share = budget > 0 ? used / budget : 0;
    ImGui::ProgressBar(static_cast<float>(share), {-1, 0}, text.c_str());
    itemTooltip(
        "Memory used for undo. When it is full, the oldest changes can no longer be undone.");
}

}  // namespace

void drawChanges(const PanelModel& model, std::vector<Action>& actions) {
    const ChangeList& changes = model.changes;
    const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    drawButton(model, "Undo", ActionId::undo, width, actions);
    ImGui::SameLine();
    drawButton(model, "Redo", ActionId::redo, width, actions);
    drawMemory(changes);
    if (!ImGui::BeginChild("changes")) {
        ImGui::EndChild();
        return;
    }
    drawState(model, nameOfStart(changes), 0, actions);
    drawRows(model, actions);
    ImGui::EndChild();
}

}  // namespace kerf::ui
