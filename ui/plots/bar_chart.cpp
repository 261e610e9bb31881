#include "ui/plots/bar_chart.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/plots/plot_math.h"

namespace kerf::ui {
namespace {

constexpr float kGroupShare = 0.8F;  ///< of a group's room that its bars take

/// The frame that the bars stand in [px].
struct BarFrame {
    ImVec2 low;   ///< top left corner
    ImVec2 high;  ///< bottom right corner
    double most = 1;
    std::size_t groups = 1;
    std::size_t kinds = 1;

    float atY(double value) const {
        return high.y - (high.y - low.y) * static_cast<float>(value / most);
    }
    float groupWidth() const { return (high.x - low.x) / static_cast<float>(groups); }
    float middleOf(std::size_t group) const {
        return low.x + (static_cast<float>(group) + 0.5F) * groupWidth();
    }
    float barWidth() const { return kGroupShare * groupWidth() / static_cast<float>(kinds); }
    float leftOf(std::size_t group, std::size_t kind) const {
        return middleOf(group) - kGroupShare * groupWidth() / 2 +
               static_cast<float>(kind) * barWidth();
    }
};

double highestOf(const BarChart& chart) {
    double highest = 0;
    for (const BarGroup& group : chart.groups) {
        for (const std::optional<Bar>& bar : group.bars) {
            if (bar) {
                highest = std::max({highest, bar->value, bar->spread ? bar->spread->high : 0});
            }
        }
    }
    return highest > 0 ? highest : 1;
}

void drawCentred(ImDrawList& draw, float x, float top, ImU32 color, const std::string& text) {
    draw.AddText({x - ImGui::CalcTextSize(text.c_str()).x / 2, top}, color, text.c_str());
}

void drawLegend(const BarChart& chart) {
    const float line = ImGui::GetFontSize();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImVec2 corner = ImGui::GetCursorScreenPos();
    for (const BarKind& kind : chart.kinds) {
        draw.AddRectFilled({corner.x, corner.y + 0.15F * line},
                           {corner.x + 0.8F * line, corner.y + 0.95F * line},
                           palette().of(kind.hue));
        draw.AddText({corner.x + 1.1F * line, corner.y}, palette().dimText, kind.label.c_str());
        corner.x += ImGui::CalcTextSize(kind.label.c_str()).x + 2.4F * line;
    }
    ImGui::Dummy({1, line});
}

/// The rest of the panel, with a line below for the labels and room left for the ticks.
BarFrame placeFrame(const BarChart& chart) {
    const float line = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    BarFrame frame;
    frame.low = {std::round(corner.x + 2.9F * line), std::round(corner.y + 0.2F * line)};
    frame.high = {std::round(corner.x + room.x), std::round(corner.y + room.y - 1.5F * line)};
    frame.most = 1.15 * highestOf(chart);  // room for the value above the highest bar
    frame.groups = std::max<std::size_t>(1, chart.groups.size());
    frame.kinds = std::max<std::size_t>(1, chart.kinds.size());
    return frame;
}

void drawTicks(ImDrawList& draw, const BarFrame& frame) {
    const float line = ImGui::GetFontSize();
    const int most = std::max(2, static_cast<int>((frame.high.y - frame.low.y) / (2 * line)));
    const PlotTicks ticks = niceTicks({0, frame.most}, most);
    for (const double value : ticks.values) {
        const float y = std::round(frame.atY(value));
        const std::string text = fixedText(value, ticks.decimals);
        draw.AddLine({frame.low.x, y}, {frame.high.x, y}, palette().grid);
        draw.AddText({frame.low.x - ImGui::CalcTextSize(text.c_str()).x - 0.4F * line,
                      std::min(y - line / 2, frame.high.y - line)},
                     palette().dimText, text.c_str());
    }
}

/// The error bar: a line from the smallest to the largest value, with a cap at both ends.
void drawSpread(ImDrawList& draw, const BarFrame& frame, float x, const Bar::Spread& spread) {
    const float thickness = std::max(1.0F, ImGui::GetFontSize() / 10);
    const float cap = 0.22F * frame.barWidth();
    const float low = frame.atY(spread.low);
    const float high = frame.atY(spread.high);
    draw.AddLine({x, low}, {x, high}, palette().text, thickness);
    for (const float y : {low, high}) {
        draw.AddLine({x - cap, y}, {x + cap, y}, palette().text, thickness);
    }
}

void drawBar(ImDrawList& draw, const BarFrame& frame, float left, const Bar& bar, ImU32 color,
             int decimals) {
    const float line = ImGui::GetFontSize();
    const float gap = 0.06F * frame.barWidth();
    const float middle = left + frame.barWidth() / 2;
    draw.AddRectFilled({left + gap, frame.atY(bar.value)},
                       {left + frame.barWidth() - gap, frame.high.y}, color);
    const double top = bar.spread ? std::max(bar.value, bar.spread->high) : bar.value;
    if (bar.spread) {
        drawSpread(draw, frame, middle, *bar.spread);
    }
    drawCentred(draw, middle, frame.atY(top) - 1.2F * line, palette().text,
                fixedText(bar.value, decimals));
}

void drawGroups(ImDrawList& draw, const BarFrame& frame, const BarChart& chart) {
    const float line = ImGui::GetFontSize();
    for (std::size_t g = 0; g < chart.groups.size(); ++g) {
        const BarGroup& group = chart.groups[g];
        for (std::size_t k = 0; k < std::min(group.bars.size(), chart.kinds.size()); ++k) {
            if (group.bars[k]) {
                drawBar(draw, frame, frame.leftOf(g, k), *group.bars[k],
                        palette().of(chart.kinds[k].hue), chart.decimals);
            }
        }
        drawCentred(draw, frame.middleOf(g), frame.high.y + 0.3F * line, palette().text,
                    group.label);
    }
}

void drawChart(const BarChart& chart) {
    ImGui::TextUnformatted(chart.title.c_str());
    drawLegend(chart);
    const BarFrame frame = placeFrame(chart);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(frame.low, frame.high, palette().plotGround);
    drawTicks(draw, frame);
    drawGroups(draw, frame, chart);
    draw.AddRect(frame.low, frame.high, palette().frame);
}

}  // namespace

render::Image drawBarChart(PicturePainter& painter, const BarChart& chart, int width, int height) {
    return painter.draw(width, height, [&] { drawChart(chart); });
}

}  // namespace kerf::ui
