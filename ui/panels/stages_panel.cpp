#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include "ui/base/widgets.h"
#include "ui/panels/panels.h"

namespace kerf::ui {
namespace {

struct StageText {
    Reading reading;
    const char* name;
    const char* meaning;
};
constexpr std::array kTexts{
    StageText{Reading::deformMs, "Deform", "Constraints and volume: GPU time of a step"},
    StageText{Reading::collideMs, "Collide", "Floor and contact: GPU time of a step"},
    StageText{Reading::cutMs, "Cut", "Cutting the mesh: CPU time of a step"},
    StageText{Reading::renderMs, "Render", "Drawing the scene: GPU time of a frame"},
    StageText{Reading::otherMs, "Other",
              "The rest of the steps of a frame: measuring and reading the body"},
    StageText{Reading::windowMs, "Window",
              "The rest of a frame: panels, and waiting until the driver has drawn all of it"},
    StageText{Reading::frameMs, "Frame", "Time between two frames while playing, including panels"},
};

/// Of all rows but the frame's [ms].
double sumOfStages(const History& history) {
    double sum = 0;
    for (const StageText& row : kTexts) {
        sum += row.reading == Reading::frameMs ? 0 : history[row.reading].sum();
    }
    return sum;
}

void numberCell(const std::string& text) {
    ImGui::TableNextColumn();
    textRight(text);
}

void millisecondsCell(double value) {
    numberCell(fmt::format("{:.{}f}", value, value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2));
}

void explainCut(const SubdivisionCounts& counts) {
    ImGui::TextUnformatted("Triangles divided so far");
    for (int i = 0; i < kPaperPatterns; ++i) {
        ImGui::Text("%s: %d", nameOf(static_cast<SubdivisionPattern>(i)), counts[i]);
    }
    ImGui::Text("other: %d", otherPatterns(counts));
}

void explain(const StageText& row, const SubdivisionCounts& subdivisions) {
    if (!ImGui::IsItemHovered()) {
        return;
    }
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(row.meaning);
    if (row.reading == Reading::cutMs) {
        explainCut(subdivisions);
    }
    ImGui::EndTooltip();
}

/// What is told of a stage's times.
struct TimeColumn {
    const char* title;
    double (Series::*value)() const;
};
constexpr std::array kTimes{TimeColumn{"last", &Series::last}, TimeColumn{"mean", &Series::mean},
                            TimeColumn{"max", &Series::max}, TimeColumn{"min", &Series::min}};

/// A narrow panel leaves out the last of them.
std::span<const TimeColumn> timesFor(float width) {
    constexpr float kLeastLetters = 17;
    return std::span(kTimes).first(kTimes.size() -
                                   (width < kLeastLetters * ImGui::GetFontSize() ? 1 : 0));
}

void drawRow(const StageText& row, std::span<const TimeColumn> times, const History& history,
             const SubdivisionCounts& subdivisions) {
    const Series& series = history[row.reading];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.name);
    explain(row, subdivisions);
    if (series.empty()) {
        return;
    }
    for (const TimeColumn& time : times) {
        millisecondsCell((series.*time.value)());
    }
    const double sum = sumOfStages(history);
    if (row.reading != Reading::frameMs && sum > 0) {
        numberCell(fmt::format("{:.0f} %", 100 * series.sum() / sum));
    }
}

void drawHeader(std::span<const TimeColumn> times) {
    const auto title = [](const char* text) {
        ImGui::TableNextColumn();
        textRight(text);
    };
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableNextColumn();
    ImGui::TextDisabled("ms");
    for (const TimeColumn& time : times) {
        title(time.title);
    }
    title("share");
}

}  // namespace

std::string sharesOfStages(const History& history) {
    const double sum = sumOfStages(history);
    std::string text;
    for (const StageText& row : kTexts) {
        const double share = sum > 0 ? history[row.reading].sum() / sum : 0;
        if (row.reading != Reading::frameMs && share >= 0.005) {
            text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", row.name, 100 * share);
        }
    }
    return text;
}

void drawStages(const History& history, const SubdivisionCounts& subdivisions) {
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding,
                        {0.25F * ImGui::GetFontSize(), 0.2F * ImGui::GetFontSize()});
    const std::span<const TimeColumn> times = timesFor(ImGui::GetContentRegionAvail().x);
    const int columns = static_cast<int>(times.size()) + 2;
    if (ImGui::BeginTable("stages", columns,
                          ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed,
                                ImGui::CalcTextSize("Window").x);
        drawHeader(times);
        for (const StageText& row : kTexts) {
            drawRow(row, times, history, subdivisions);
        }
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

}  // namespace kerf::ui
