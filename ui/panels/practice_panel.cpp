#include <imgui.h>

#include "ui/base/layout.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

constexpr std::size_t kMostName = 60;
constexpr std::size_t kMostAbout = 300;
constexpr double kFirstDepth = 0.03;  // of the body's size
constexpr double kDeepest = 0.3;      // of it
constexpr double kMostOff = 0.1;      // of it
constexpr double kMostSeconds = 300;

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

bool editText(const char* label, std::string& text, std::size_t most, const std::string& name,
              const char* tooltip) {
    std::string buffer(most + 1, '\0');
    text.copy(buffer.data(), most);
    ImGui::SetNextItemWidth(-1);
    const bool changed =
        ImGui::InputTextWithHint(("##" + name).c_str(), label, buffer.data(), most + 1);
    noteItem(name);
    itemTooltip(tooltip);
    text = changed ? buffer.substr(0, buffer.find('\0')) : text;
    return changed;
}

bool slideMillimetres(const SlideText& text, double& metres, double most) {
    double shown = 1e3 * metres;
    const double longest = 1e3 * most;
    const double least = 0.1;
    const bool changed = slideRow(text, {ImGuiDataType_Double, &shown, &least, &longest, "%.1f mm"},
                                  ImGui::GetContentRegionAvail().x)
                             .changed;
    metres = changed ? shown / 1e3 : metres;
    return changed;
}

/// What a teacher sets of a task that is being made.
void drawDraft(TaskDraft draft, std::vector<Action>& actions) {
    const double none = 0;
    bool changed = editText("Name of the task", draft.name, kMostName, "task.name", "Its name.");
    changed |= editText("What to do", draft.about, kMostAbout, "task.about", "What to do.");
    bool through = draft.depth <= 0;
    if (checkbox("Right through", through, "task.through", "The cut goes right through.")) {
        draft.depth = through ? 0 : kFirstDepth * draft.longest;
        changed = true;
    }
    if (!through) {
        changed |= slideMillimetres({"Depth", "How deep to cut", "task.depth"}, draft.depth,
                                    kDeepest * draft.longest);
    }
    changed |= slideMillimetres(
        {"Off the line", "How far the cut may be from the line, at most", "task.deviation"},
        draft.deviation, kMostOff * draft.longest);
    changed |= slideRow({"Time", "The time for it; 0 s as long as it takes", "task.seconds"},
                        {ImGuiDataType_Double, &draft.seconds, &none, &kMostSeconds, "%.0f s"},
                        ImGui::GetContentRegionAvail().x)
                   .changed;
    for (TaskDraft::Spared& model : draft.models) {
        changed |= checkbox(("Spare " + model.name).c_str(), model.spared,
                            "task.spare." + std::to_string(model.model),
                            "A cut in this model breaks a limit.");
    }
    if (changed) {
        actions.emplace_back(ChangeTask{draft});
    }
    if (button("Save task...", "task.save",
               "Without your tries. One that passed is saved beside it as the expert's.")) {
        actions.emplace_back(ActionId::saveSession);
    }
}

}  // namespace

void drawPractice(const PracticeState& practice, const Settings& settings,
                  std::vector<Action>& actions) {
    if (practice.draft) {
        drawDraft(*practice.draft, actions);
    } else {
        textWrapped(practice.name);
        textWrapped(practice.about);
    }
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
