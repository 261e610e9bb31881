#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include "sim/base/text.h"
#include "ui/base/layout.h"
#include "ui/base/theme.h"
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

void drawMemoryOf(const char* what, std::size_t bytes, std::size_t most, const char* tooltip) {
    const auto used = static_cast<double>(bytes);
    const auto budget = static_cast<double>(most);
    const std::string text = fmt::format("{}: {:.0f} of {:.0f} MB", what, used / kBytesPerMegabyte,
                                         budget / kBytesPerMegabyte);
    ImGui::ProgressBar(static_cast<float>(budget > 0 ? used / budget : 0), {-1, 0}, text.c_str());
    itemTooltip(tooltip);
}

void drawMemory(const ChangeList& changes) {
    drawMemoryOf("Undo memory", changes.bytes, changes.budget,
                 "Memory used for undo. When it is full, the oldest changes can no longer be "
                 "undone.");
    drawMemoryOf("Time line memory", changes.checkpoints, changes.checkpointBudget,
                 "Memory used for going back on the time line. When it is full, every other "
                 "checkpoint is dropped, and going back takes longer.");
}

void drawTitles() {
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableNextColumn();
    for (const char* title : {"All cuts", "Last"}) {
        ImGui::TableNextColumn();
        textRight(title);
    }
}

void drawRow(const CutRow& row) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    textShortened(row.quantity, ImGui::GetContentRegionAvail().x);
    itemTooltip(row.tooltip);
    ImGui::TableNextColumn();
    textRight(row.all);
    noteItem("cuts." + row.quantity);
    ImGui::TableNextColumn();
    textRight(row.last);
}

void drawLine(const LogLine& line) {
    // The sign tells it as well as the colour does.
    textColored(line.isError ? palette().of(Hue::vermillion) : palette().dimText,
                line.isError ? "\u25b2" : "\u2022");
    ImGui::SameLine();
    textWrapped(line.text);
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

void drawCuts(const CutsState& cuts) {
    if (!cuts.note.empty()) {
        ImGui::TextDisabled("%s", cuts.note.c_str());
    }
    if (cuts.rows.empty() ||
        !ImGui::BeginTable("cuts", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) {
        return;
    }
    ImGui::TableSetupColumn("quantity", ImGuiTableColumnFlags_WidthStretch);
    for (const auto& [title, member] :
         {std::pair{"all cuts", &CutRow::all}, {"last", &CutRow::last}}) {
        float width = ImGui::CalcTextSize(title).x;
        for (const CutRow& row : cuts.rows) {
            width = std::max(width, ImGui::CalcTextSize((row.*member).c_str()).x);
        }
        ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthFixed, width);
    }
    drawTitles();
    for (const CutRow& row : cuts.rows) {
        drawRow(row);
    }
    ImGui::EndTable();
}

void drawLog(const std::vector<LogLine>& log) {
    ImGui::BeginChild("log");
    if (log.empty()) {
        ImGui::TextDisabled("No messages yet.");
    }
    for (const LogLine& line : log) {
        drawLine(line);
    }
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) {
        ImGui::SetScrollHereY(1);
    }
    ImGui::EndChild();
}

}  // namespace kerf::ui
