#include <imgui.h>

#include "ui/base/layout.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

constexpr std::size_t kMostName = 60;

void drawPerson(const Settings& settings, std::vector<Action>& actions) {
    char buffer[kMostName + 1] = {};
    settings.person.copy(buffer, kMostName);
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##person", "Your name", buffer, sizeof buffer)) {
        Settings changed = settings;
        changed.person = buffer;
        actions.emplace_back(SetSettings{changed});
    }
    noteItem("practice.person");
    itemTooltip("It stands in the files of your tries and in the table of a class.");
}

void drawSwitch(const char* label, const char* id, const char* tooltip, bool Settings::*member,
                const Settings& settings, std::vector<Action>& actions) {
    Settings changed = settings;
    if (checkbox(label, changed.*member, id, tooltip)) {
        actions.emplace_back(SetSettings{changed});
    }
}

void drawCell(const std::string& text) {
    ImGui::TableNextColumn();
    textRight(text);
}

void drawScoreRow(const ScoreRow& row) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    textShortened((row.broken ? "! " : "") + row.figure, ImGui::GetContentRegionAvail().x);
    itemTooltip(row.limit.empty() ? row.figure : row.figure + ": " + row.limit);
    drawCell(row.now);
    noteItem("practice." + row.figure);
    drawCell(row.last);
    drawCell(row.expert);
}

void drawScore(const PracticeState& practice) {
    if (!ImGui::BeginTable("score", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) {
        return;
    }
    ImGui::TableSetupColumn("figure", ImGuiTableColumnFlags_WidthStretch);
    for (const auto& [title, member] : {std::pair{"Now", &ScoreRow::now},
                                        {"Last", &ScoreRow::last},
                                        {"Expert", &ScoreRow::expert}}) {
        float width = ImGui::CalcTextSize(title).x;
        for (const ScoreRow& row : practice.rows) {
            width = std::max(width, ImGui::CalcTextSize((row.*member).c_str()).x);
        }
        ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthFixed, width);
    }
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableNextColumn();
    for (const char* title : {"Now", "Last", "Expert"}) {
        drawCell(title);
    }
    for (const ScoreRow& row : practice.rows) {
        drawScoreRow(row);
    }
    ImGui::EndTable();
}

void drawVerdict(const PracticeState& practice) {
    if (practice.violations.empty()) {
        ImGui::TextWrapped("Passed: every limit was kept.");
    }
    for (const std::string& violation : practice.violations) {
        ImGui::TextWrapped("! %s", violation.c_str());
    }
}

}  // namespace

void drawPractice(const PracticeState& practice, const Settings& settings,
                  std::vector<Action>& actions) {
    ImGui::TextWrapped("%s", practice.name.c_str());
    ImGui::TextWrapped("%s", practice.about.c_str());
    drawPerson(settings, actions);
    if (practice.hasExpert) {
        drawSwitch("Expert's blade", "practice.expert", "Shows how an expert leads the blade.",
                   &Settings::showExpert, settings, actions);
    }
    if (practice.hasLast) {
        drawSwitch("My last try", "practice.last", "Shows the path of your blade then.",
                   &Settings::showLastTry, settings, actions);
    }
    for (const ActionId id : {ActionId::finishTry, ActionId::reset}) {
        const bool finishes = id == ActionId::finishTry;
        if (button(finishes ? "Finish" : "Again", finishes ? "practice.finish" : "practice.again",
                   describeAction(id))) {
            actions.emplace_back(id);
        }
        if (finishes) {
            ImGui::SameLine();
        }
    }
    if (practice.finished) {
        drawVerdict(practice);
    }
    if (practice.finished || practice.hasLast || practice.hasExpert) {
        drawScore(practice);
    }
}

}  // namespace kerf::ui
