#include <imgui.h>

#include "ui/base/theme.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"

namespace kerf::ui {
namespace {

void drawLine(const LogLine& line) {
    // The sign tells it as well as the colour does.
    textColored(line.isError ? palette().of(Hue::vermillion) : palette().dimText,
                line.isError ? "\u25b2" : "\u2022");
    ImGui::SameLine();
    textWrapped(line.text);
}

}  // namespace

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
