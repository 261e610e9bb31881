#include "ui/plot.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/theme.h"

namespace kerf::ui {
namespace {

std::string formatNumber(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

/// Where the data meets the pixels.
struct Frame {
    ImVec2 low;   ///< top left corner
    ImVec2 high;  ///< bottom right corner
    PlotRange x;
    PlotRange y;

    float atX(double value) const {
        return low.x + (high.x - low.x) * static_cast<float>((value - x.low) / x.span());
    }
    float atY(double value) const {
        return high.y - (high.y - low.y) * static_cast<float>((value - y.low) / y.span());
    }
    int columns() const { return std::max(1, static_cast<int>(high.x - low.x)); }
    bool holds(const ImVec2& p) const {
        return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
    }
};

PlotRange timeRange(std::span<const PlotPoint> points) {
    constexpr double kShortest = 1;  // An empty plot shows its first second.
    if (points.empty()) {
        return {0, kShortest};
    }
    return {0, std::max(kShortest, points.back().x)};
}

void drawHeader(const PlotSpec& spec) {
    ImGui::TextUnformatted(spec.title.data(), spec.title.data() + spec.title.size());
    if (spec.points.empty()) {
        return;
    }
    const std::string value = formatNumber(spec.points.back().y, spec.readoutDecimals);
    const float width = ImGui::CalcTextSize(value.c_str()).x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    ImGui::PushStyleColor(ImGuiCol_Text, spec.color);
    ImGui::TextUnformatted(value.c_str());
    ImGui::PopStyleColor();
}

void drawTicksY(ImDrawList& draw, const Frame& frame) {
    const float line = ImGui::GetFontSize();
    const int most = std::max(2, static_cast<int>((frame.high.y - frame.low.y) / (1.5F * line)));
    const PlotTicks ticks = niceTicks(frame.y, most);
    for (const double value : ticks.values) {
        const float y = std::round(frame.atY(value));
        const std::string text = formatNumber(value, ticks.decimals);
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        draw.AddLine({frame.low.x, y}, {frame.high.x, y}, Theme::kGrid);
        draw.AddText({frame.low.x - width - 0.4F * line, y - line / 2}, Theme::kDimText,
                     text.c_str());
    }
}

void drawTicksX(ImDrawList& draw, const Frame& frame, std::string_view unit) {
    const float line = ImGui::GetFontSize();
    const int most = std::max(2, static_cast<int>((frame.high.x - frame.low.x) / (2.4F * line)));
    const PlotTicks ticks = niceTicks(frame.x, most);
    float freeUntil = frame.high.x;
    for (auto tick = ticks.values.rbegin(); tick != ticks.values.rend(); ++tick) {
        const float x = std::round(frame.atX(*tick));
        std::string text = formatNumber(*tick, ticks.decimals);
        if (tick == ticks.values.rbegin()) {
            text += " " + std::string(unit);
        }
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        const float left = std::min(x - width / 2, frame.high.x - width);
        draw.AddLine({x, frame.low.y}, {x, frame.high.y}, Theme::kGrid);
        if (left + width <= freeUntil) {
            draw.AddText({left, frame.high.y + 0.2F * line}, Theme::kDimText, text.c_str());
            freeUntil = left - 0.3F * line;
        }
    }
}

void drawMarks(ImDrawList& draw, const Frame& frame, std::span<const PlotMark> marks) {
    float freeFrom = frame.low.x;
    for (const PlotMark& mark : marks) {
        if (mark.x < frame.x.low || mark.x > frame.x.high) {
            continue;
        }
        const float x = std::round(frame.atX(mark.x));
        draw.AddLine({x, frame.low.y}, {x, frame.high.y}, Theme::kMark);
        const float width = ImGui::CalcTextSize(mark.label.c_str()).x;
        // A label that would run into the one before or out of the plot is left out.
        if (x >= freeFrom && x + width + 6 < frame.high.x) {
            draw.AddText({x + 3, frame.low.y + 1}, Theme::kDimText, mark.label.c_str());
            freeFrom = x + width + 8;
        }
    }
}

void drawReference(ImDrawList& draw, const Frame& frame, double value) {
    const float y = std::round(frame.atY(value));
    if (y < frame.low.y || y > frame.high.y) {
        return;
    }
    for (float x = frame.low.x; x < frame.high.x; x += 8) {
        draw.AddLine({x, y}, {std::min(x + 4, frame.high.x), y}, Theme::kMark);
    }
}

void drawCurve(ImDrawList& draw, const Frame& frame, const PlotSpec& spec) {
    const std::vector<PlotColumn> columns = gatherColumns(spec.points, frame.x, frame.columns());
    const ImU32 band = (spec.color & ~IM_COL32_A_MASK) | (72U << IM_COL32_A_SHIFT);
    const double pixel = frame.x.span() / frame.columns();
    std::vector<ImVec2> line;
    line.reserve(columns.size());
    for (const PlotColumn& column : columns) {
        const float x = frame.atX(frame.x.low + (column.column + 0.5) * pixel);
        const float top = frame.atY(column.high);
        const float bottom = frame.atY(column.low);
        if (bottom - top > 1) {
            draw.AddRectFilled({x - 0.5F, top}, {x + 0.5F, bottom}, band);
        }
        line.push_back({x, frame.atY(column.mean)});
    }
    const float thickness = ImGui::GetFontSize() / 10;
    // Segment by segment: ImGui's polyline thins out where a curve turns sharply.
    for (std::size_t i = 1; i < line.size(); ++i) {
        draw.AddLine(line[i - 1], line[i], spec.color, thickness);
    }
    if (line.size() == 1) {
        draw.AddCircleFilled(line.front(), thickness, spec.color);
    }
}

/// The point nearest to `x`; the points are not empty.
const PlotPoint& nearestPoint(std::span<const PlotPoint> points, double x) {
    const auto after = std::lower_bound(points.begin(), points.end(), x,
                                        [](const PlotPoint& p, double v) { return p.x < v; });
    if (after == points.begin()) {
        return points.front();
    }
    if (after == points.end()) {
        return points.back();
    }
    const auto before = after - 1;
    return x - before->x < after->x - x ? *before : *after;
}

void drawCrosshair(ImDrawList& draw, const Frame& frame, const PlotSpec& spec) {
    const ImVec2 pointer = ImGui::GetMousePos();
    if (spec.points.empty() || !frame.holds(pointer)) {
        return;
    }
    const double share = (pointer.x - frame.low.x) / (frame.high.x - frame.low.x);
    const PlotPoint& p = nearestPoint(spec.points, frame.x.low + share * frame.x.span());
    const ImVec2 at{frame.atX(p.x), frame.atY(p.y)};
    draw.AddLine({at.x, frame.low.y}, {at.x, frame.high.y}, Theme::kFrame);
    draw.AddCircleFilled(at, ImGui::GetFontSize() / 5, spec.color);
    ImGui::SetTooltip("%s at %s %s", formatNumber(p.y, spec.readoutDecimals).c_str(),
                      formatNumber(p.x, 2).c_str(), std::string(spec.xUnit).c_str());
}

PlotRange valueRange(const PlotSpec& spec) {
    if (spec.points.empty() && spec.reference) {
        return {*spec.reference - spec.minSpan / 2, *spec.reference + spec.minSpan / 2};
    }
    return paddedRange(spec.points, spec.minSpan);
}

Frame placeFrame(const PlotSpec& spec, float height) {
    const float line = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::InvisibleButton(spec.id, {width, height});
    Frame frame;
    frame.low = {std::round(corner.x + 2.9F * line), std::round(corner.y)};
    frame.high = {std::round(corner.x + width), std::round(corner.y + height - 1.3F * line)};
    frame.x = timeRange(spec.points);
    frame.y = valueRange(spec);
    return frame;
}

}  // namespace

void drawPlot(const PlotSpec& spec, float height) {
    drawHeader(spec);
    const Frame frame = placeFrame(spec, height - ImGui::GetTextLineHeightWithSpacing());
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(frame.low, frame.high, Theme::kPlotGround);
    drawTicksY(draw, frame);
    drawTicksX(draw, frame, spec.xUnit);
    draw.PushClipRect(frame.low, frame.high, true);
    if (spec.reference) {
        drawReference(draw, frame, *spec.reference);
    }
    drawMarks(draw, frame, spec.marks);
    drawCurve(draw, frame, spec);
    draw.PopClipRect();
    draw.AddRect(frame.low, frame.high, Theme::kFrame);
    if (hovered) {
        drawCrosshair(draw, frame, spec);
    }
}

}  // namespace kerf::ui
