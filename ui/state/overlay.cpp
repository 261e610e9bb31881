#include "ui/state/overlay.h"

#include <imgui.h>

#include "ui/base/theme.h"

namespace kerf::ui {
namespace {

constexpr ImU32 kTouched = IM_COL32(240, 228, 66, 70);
constexpr ImU32 kTouchedEdge = IM_COL32(240, 228, 66, 130);
constexpr ImU32 kSwept = IM_COL32(64, 224, 190, 150);
constexpr ImU32 kShade = IM_COL32(0, 0, 0, 110);
constexpr ImU32 kGuide = IM_COL32(86, 180, 233, 255);
constexpr ImU32 kLabelGround = IM_COL32(12, 14, 18, 200);
constexpr ImU32 kHot = IM_COL32(255, 226, 110, 255);
constexpr ImU32 kWound = IM_COL32(255, 255, 255, 255);

constexpr std::array<ImU32, 4> kAxisColors{IM_COL32(205, 205, 205, 255), IM_COL32(226, 88, 80, 255),
                                           IM_COL32(112, 190, 76, 255),
                                           IM_COL32(86, 140, 236, 255)};

/// By Overlay::Trace::Kind: the palette of Okabe and Ito, which the colour-blind can tell apart.
struct TraceLook {
    ImU32 color;
    float width;
};
constexpr std::array<TraceLook, 7> kTraceLooks{{{IM_COL32(170, 80, 255, 255), 2.5F},
                                                {IM_COL32(170, 80, 255, 150), 1.2F},
                                                {IM_COL32(213, 94, 0, 255), 1.5F},
                                                {IM_COL32(204, 121, 167, 220), 1.2F},
                                                {IM_COL32(86, 180, 233, 255), 2.0F},
                                                {IM_COL32(0, 158, 115, 255), 3.0F},
                                                {IM_COL32(230, 159, 0, 255), 3.0F}}};

ImU32 colorOf(int axis, bool hot) {
    return hot ? kHot : kAxisColors[axis + 1];
}

ImVec2 at(const PlotPoint& p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

/// On a dark ground, a little above its point.
void drawLabel(ImDrawList& draw, const Overlay::Label& label, float scale) {
    const ImVec2 size = ImGui::CalcTextSize(label.text.c_str());
    const ImVec2 low{at(label.at).x - size.x / 2, at(label.at).y - size.y - 9 * scale};
    const float margin = 3 * scale;
    draw.AddRectFilled({low.x - margin, low.y - margin},
                       {low.x + size.x + margin, low.y + size.y + margin}, kLabelGround, margin);
    draw.AddText(low, kWound, label.text.c_str());
}

void drawDot(ImDrawList& draw, const Overlay::AxisDot& dot, float scale) {
    const float radius = (dot.hot ? 7.0F : 5.5F) * scale;
    const ImU32 color = colorOf(dot.axis, dot.hot);
    const ImVec2 p = at(dot.at);
    if (dot.square) {
        const float ground = radius + 1.5F * scale;
        draw.AddRectFilled({p.x - ground, p.y - ground}, {p.x + ground, p.y + ground}, kShade);
        draw.AddRectFilled({p.x - radius, p.y - radius}, {p.x + radius, p.y + radius}, color);
    } else {
        draw.AddCircleFilled(p, radius + 1.5F * scale, kShade, 20);
        draw.AddCircleFilled(p, radius, color, 20);
    }
}

void drawGizmo(ImDrawList& draw, const Overlay& overlay, float scale) {
    for (const Overlay::AxisLine& each : overlay.axisLines) {
        draw.AddLine(at(each.line[0]), at(each.line[1]), kShade, 4 * scale);
    }
    for (const Overlay::AxisLine& each : overlay.axisLines) {
        draw.AddLine(at(each.line[0]), at(each.line[1]), colorOf(each.axis, each.hot),
                     (each.hot ? 3.0F : 2.0F) * scale);
    }
    for (const Overlay::AxisDot& dot : overlay.axisDots) {
        drawDot(draw, dot, scale);
    }
}

/// Evenly spaced dots, where the way is longer than a few of them.
void drawLag(ImDrawList& draw, const std::vector<PlotPoint>& way, float scale) {
    constexpr double kApart = 8;   // [px at scale 1]
    constexpr double kLeast = 16;  // from end to end: the blade covers less
    if (way.empty() ||
        std::hypot(way.back().x - way.front().x, way.back().y - way.front().y) < kLeast * scale) {
        return;
    }
    double next = 0;  // dot, along what is left of the way
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double x = way[i].x - way[i - 1].x;
        const double y = way[i].y - way[i - 1].y;
        const double length = std::hypot(x, y);
        for (; next < length; next += kApart * scale) {
            const ImVec2 p =
                at({way[i - 1].x + next / length * x, way[i - 1].y + next / length * y});
            draw.AddCircleFilled(p, 2.8F * scale, kShade, 12);
            draw.AddCircleFilled(p, 1.7F * scale, kWound, 12);
        }
        next -= length;
    }
}

}  // namespace

void drawOverlay(const Overlay& overlay, float scale) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    for (const Overlay::Face& face : overlay.touched) {
        draw.AddTriangleFilled(at(face[0]), at(face[1]), at(face[2]), kTouched);
        draw.AddTriangle(at(face[0]), at(face[1]), at(face[2]), kTouchedEdge, scale);
    }
    for (const Overlay::Line& line : overlay.swept) {
        draw.AddLine(at(line[0]), at(line[1]), kSwept, 1.5F * scale);
    }
    for (const Overlay::Line& line : overlay.wound) {
        draw.AddLine(at(line[0]), at(line[1]), kShade, 4 * scale);
    }
    for (const Overlay::Line& line : overlay.wound) {
        draw.AddLine(at(line[0]), at(line[1]), kWound, 2 * scale);
    }
    for (const Overlay::Trace& trace : overlay.traces) {
        const TraceLook& look = kTraceLooks[static_cast<std::size_t>(trace.kind)];
        draw.AddLine(at(trace.line[0]), at(trace.line[1]), kShade, (look.width + 1.5F) * scale);
        draw.AddLine(at(trace.line[0]), at(trace.line[1]), look.color, look.width * scale);
    }
    drawLag(draw, overlay.lag, scale);
    for (const Overlay::Line& line : overlay.guides) {
        draw.AddLine(at(line[0]), at(line[1]), kShade, 3.5F * scale);
    }
    for (const Overlay::Line& line : overlay.guides) {
        draw.AddLine(at(line[0]), at(line[1]), kGuide, 1.5F * scale);
    }
    drawGizmo(draw, overlay, scale);
    for (const PlotPoint& dot : overlay.dots) {
        draw.AddCircleFilled(at(dot), 5 * scale, kShade, 16);
        draw.AddCircleFilled(at(dot), 3.5F * scale, kGuide, 16);
    }
    for (const Overlay::Label& label : overlay.labels) {
        drawLabel(draw, label, scale);
    }
    for (const Overlay::Handle& handle : overlay.handles) {
        const float radius = (handle.hot ? 9.0F : 7.0F) * scale;
        draw.AddCircleFilled(at(handle.at), radius + 2 * scale, kShade, 24);
        draw.AddCircleFilled(at(handle.at), radius, handle.hot ? kWound : palette().blade, 24);
    }
}

}  // namespace kerf::ui
