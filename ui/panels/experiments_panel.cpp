#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include "ui/base/layout.h"
#include "ui/base/theme.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"

namespace kerf::ui {
namespace {

/// Draws the lines of a card, from its corner down.
class CardPainter {
  public:
    CardPainter(ImVec2 low, float width) : low_(low), width_(width) {
        const float padding = 0.5F * ImGui::GetFontSize();
        low_.x += padding;
        low_.y += padding;
        width_ -= 2 * padding;
    }

    void title(const ExperimentCard& card) {
        left(card.label, palette().text);
        if (card.triangles > 0) {
            right(std::to_string(card.triangles) + " triangles", palette().dimText);
        }
        next();
    }
    /// "paper    160.5 frames/s    vol. 98.0 %"
    void figures(const char* who, const RunFigures& figures, ImU32 color) {
        left(who, palette().dimText);
        at(0.62F, fmt::format("{:.1f} frames/s", figures.fps), color);
        right(fmt::format("vol. {:.1f} %", figures.volume), color);
        next();
    }
    void sentence(const char* who, const char* text) {
        left(who, palette().dimText);
        right(text, palette().dimText);
        next();
    }

  private:
    void left(const std::string& text, ImU32 color) { put(low_.x, text, color); }
    void right(const std::string& text, ImU32 color) { at(1, text, color); }
    /// Ends at this share of the width.
    void at(float share, const std::string& text, ImU32 color) {
        put(low_.x + share * width_ - ImGui::CalcTextSize(text.c_str()).x, text, color);
    }
    void put(float x, const std::string& text, ImU32 color) {
        ImGui::GetWindowDrawList()->AddText({x, low_.y}, color, text.c_str());
    }
    void next() { low_.y += 1.25F * ImGui::GetFontSize(); }

    ImVec2 low_;
    float width_;
};

float cardHeight() {
    return (1 + 3 * 1.25F - 0.2F) * ImGui::GetFontSize();
}

void drawGround(const ExperimentCard& card) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const ImGuiCol ground = ImGui::IsItemActive()    ? ImGuiCol_FrameBgActive
                            : ImGui::IsItemHovered() ? ImGuiCol_FrameBgHovered
                                                     : ImGuiCol_FrameBg;
    const float rounding = ImGui::GetStyle().FrameRounding;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, high, ImGui::GetColorU32(ground), rounding);
    if (card.open) {
        draw.AddRect(low, high, palette().of(Hue::blue), rounding, 0, ImGui::GetFontSize() / 8);
    }
}

std::string tooltipOf(const ExperimentCard& card) {
    std::string text = (card.open ? "Open now. Click to restart it." : "Open this experiment.");
    text +=
        fmt::format("\nPaper: time step {:.3f} s, {} iterations.", card.timeStep, card.iterations);
    if (card.ours) {
        text += "\nHere: averages over " + std::string(card.open ? "this run" : "the last run") +
                ", now with " + std::to_string(card.ourTriangles) + " triangles.";
    }
    return text;
}

void drawCard(const ExperimentCard& card, std::vector<Action>& actions) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    if (ImGui::InvisibleButton(card.name.c_str(), {width, cardHeight()})) {
        actions.emplace_back(OpenExperiment{card.name});
    }
    noteItem("experiment." + card.name);
    drawGround(card);
    CardPainter painter(low, width);
    painter.title(card);
    painter.figures("paper", card.paper, palette().dimText);
    if (card.ours) {
        painter.figures("here", *card.ours, palette().text);
    } else {
        painter.sentence("here", card.open ? "press Space to run it" : "not run yet");
    }
    itemTooltip(tooltipOf(card));
}

}  // namespace

void drawExperiments(const std::vector<ExperimentCard>& experiments, std::vector<Action>& actions) {
    for (const ExperimentCard& card : experiments) {
        drawCard(card, actions);
    }
}

}  // namespace kerf::ui
