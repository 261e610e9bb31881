#include <imgui.h>

#include "ui/base/layout.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

constexpr std::size_t kMostOfName = 60;  // bytes, as a session can hold
constexpr char kRemove[] = "\u00d7";

struct Addition {
    ActionId id{};
    const char* label = nullptr;  ///< on a button
};
constexpr std::array kAdditions{
    Addition{ActionId::addPicture, "Picture"}, Addition{ActionId::addCheck, "Check"},
    Addition{ActionId::addExport, "Export"}, Addition{ActionId::addCamera, "Camera"},
    Addition{ActionId::addMark, "Name"}};

void drawButtons(std::vector<Action>& actions) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width =
        (ImGui::GetContentRegionAvail().x - (kAdditions.size() - 1) * gap) / kAdditions.size();
    for (const Addition& addition : kAdditions) {
        if (button(addition.label, std::string("session.") + addition.label,
                   describeAction(addition.id), width)) {
            actions.emplace_back(addition.id);
        }
        ImGui::SameLine();
    }
    ImGui::NewLine();
}

/// Of a place on the time line, to be typed over.
void drawName(const SessionMark& mark, std::vector<Action>& actions) {
    char buffer[kMostOfName + 1] = {};
    mark.text.copy(buffer, kMostOfName);
    ImGui::SetNextItemWidth(-1);
    ImGui::InputText("##name", buffer, sizeof buffer);
    if (ImGui::IsItemDeactivatedAfterEdit() && buffer[0] != '\0') {
        actions.emplace_back(RenameMark{mark.id, buffer});
    }
    noteItem("session.name." + std::to_string(mark.step));
}

void drawRow(const SessionPanelState& session, const SessionMark& mark,
             std::vector<Action>& actions) {
    ImGui::PushID(mark.id);
    ImGui::TableNextColumn();
    textRight(std::to_string(mark.step));
    ImGui::TableNextColumn();
    const std::string label = labelOf(mark);
    const bool goes = session.playback.goesBack;
    if (mark.kind == SessionMark::Kind::name) {
        drawName(mark, actions);
    } else if (ImGui::Selectable(label.c_str()) && goes) {
        actions.emplace_back(SeekTo{mark.step});
    }
    itemTooltip(label + ", step " + std::to_string(mark.step) +
                (goes ? "\nClick to go to this step" : ""));
    ImGui::TableNextColumn();
    if (smallButton(kRemove, "session.remove." + std::to_string(mark.step),
                    "Remove from session")) {
        actions.emplace_back(RemoveMark{mark.id});
    }
    ImGui::PopID();
}

/// There may be thousands.
void drawRows(const SessionPanelState& session, std::vector<Action>& actions) {
    if (!ImGui::BeginTable("marks", 3, ImGuiTableFlags_ScrollY)) {
        return;
    }
    ImGui::TableSetupColumn("step", ImGuiTableColumnFlags_WidthFixed,
                            ImGui::CalcTextSize("00000").x);
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("remove", ImGuiTableColumnFlags_WidthFixed, buttonWidth(kRemove));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(session.marks.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            drawRow(session, session.marks[i], actions);
        }
    }
    ImGui::EndTable();
}

}  // namespace

void drawSessionAdditions(std::vector<Action>& actions) {
    for (const ActionId id : {ActionId::addPicture, ActionId::addCheck, ActionId::addExport,
                              ActionId::addCamera, ActionId::addMark, ActionId::useView}) {
        if (ImGui::MenuItem(std::string(rowOf(id).label).c_str(), keysOf(id).c_str())) {
            actions.emplace_back(id);
        }
        noteItem("add." + std::string(keyOf(id)));
    }
}

void drawSessionMarks(const SessionPanelState& session, std::vector<Action>& actions) {
    drawButtons(actions);
    if (session.marks.empty()) {
        textWrapped(
            "Add pictures, checks or exports that each replay of the session makes, keyframes for "
            "the camera of its videos, or names for places on the time line.",
            true);
        return;
    }
    drawRows(session, actions);
}

}  // namespace kerf::ui
