#include <imgui.h>

#include "ui/base/layout.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

constexpr std::size_t kMostName = 60;

struct Column {
    const char* title;
    std::string ScoreRow::*text;
};
constexpr std::array kScoreColumns{Column{"Now", &ScoreRow::now}, Column{"Limit", &ScoreRow::limit},
                                   Column{"Last", &ScoreRow::last},
                                   Column{"Expert", &ScoreRow::expert}};

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

void drawScoreRow(const ScoreRow& row, std::span<const Column> columns) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    textWrapped((row.broken ? "! " : "") + row.figure);
    for (const Column& column : columns) {
        drawCell(row.*column.text);
    }
    noteItem("practice." + row.figure);
}

/// Those with anything to show.
std::vector<Column> columnsOf(const PracticeState& practice) {
    std::vector<Column> columns(kScoreColumns.begin(), kScoreColumns.end());
    std::erase_if(columns, [&](const Column& column) {
        return std::ranges::all_of(practice.rows, &std::string::empty, column.text);
    });
    return columns;
}

void drawScore(const PracticeState& practice) {
    const std::vector<Column> columns = columnsOf(practice);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding,
                        {ImGui::GetFontSize() / 5, ImGui::GetStyle().CellPadding.y});
    const bool open =
        ImGui::BeginTable("score", 1 + static_cast<int>(columns.size()), ImGuiTableFlags_RowBg);
    ImGui::PopStyleVar();
    if (!open) {
        return;
    }
    ImGui::TableSetupColumn("figure", ImGuiTableColumnFlags_WidthStretch);
    for (const Column& column : columns) {
        float width = ImGui::CalcTextSize(column.title).x;
        for (const ScoreRow& row : practice.rows) {
            width = std::max(width, ImGui::CalcTextSize((row.*column.text).c_str()).x);
        }
        ImGui::TableSetupColumn(column.title, ImGuiTableColumnFlags_WidthFixed, width);
    }
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableNextColumn();
    for (const Column& column : columns) {
        drawCell(column.title);
    }
    for (const ScoreRow& row : practice.rows) {
        drawScoreRow(row, columns);
    }
    ImGui::EndTable();
}

/// Advice before figures.
void drawVerdict(const PracticeState& practice) {
    if (practice.violations.empty()) {
        textWrapped("Passed: every limit was kept.");
        return;
    }
    textWrapped("Next time: " + practice.advice);
    noteItem("practice.advice");
}

}  // namespace

void drawPractice(const PracticeState& practice, const Settings& settings,
                  std::vector<Action>& actions) {
    textWrapped(practice.name);
    textWrapped(practice.about);
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
        if (button(finishes ? "Finish" : "Try again",
                   finishes ? "practice.finish" : "practice.again", describeAction(id))) {
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
