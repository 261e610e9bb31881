#include "ui/state/legends.h"

#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include "sim/base/containers.h"
#include "sim/base/text.h"
#include "ui/base/layout.h"
#include "ui/base/panel_context.h"
#include "ui/base/widgets.h"

namespace kerf::ui {

namespace {

constexpr float kWidth = 180;  // of the bar [px at scale 1]
constexpr float kHeight = 12;

ImU32 asHue(const render::DisplayColor& c) {
    return IM_COL32(c[0], c[1], c[2], 255);
}

/// A triangle below the bar.
void drawPointer(const ImVec2& at, float size) {
    ImGui::GetWindowDrawList()->AddTriangleFilled(at, {at.x + 0.6F * size, at.y + size},
                                                  {at.x - 0.6F * size, at.y + size},
                                                  ImGui::GetColorU32(ImGuiCol_Text));
}

/// Low, middle and high, below the bar.
void drawNumbers(const FieldLegend& legend, const ImVec2& at, float width) {
    const render::FieldRange& range = legend.range;
    for (const double share : {0.0, 0.5, 1.0}) {
        const std::string text =
            fieldText(legend.field, range.low + share * (double(range.high) - range.low));
        const float room = width - ImGui::CalcTextSize(text.c_str()).x;
        ImGui::GetWindowDrawList()->AddText({at.x + static_cast<float>(share) * room, at.y},
                                            ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    }
}

}  // namespace

std::vector<FaultRow> faultRows(const std::vector<render::Marks>& marks) {
    return mapped(marks, [](const render::Marks& each) -> FaultRow {
        return {each.label, each.color};
    });
}

void drawFaultRows(const std::vector<FaultRow>& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        colorRow(rows[i].label, rows[i].color);
        noteItem("fault." + std::to_string(i));
    }
}

render::Image drawFaultLegend(const std::string& title, const std::vector<FaultRow>& rows) {
    PicturePainter painter;
    painter.makeCurrent();
    const ImGuiStyle& style = ImGui::GetStyle();
    float width = ImGui::CalcTextSize(title.c_str()).x;
    for (const FaultRow& row : rows) {
        const float patch = ImGui::GetTextLineHeight() + style.ItemSpacing.x;
        width = std::max(width, patch + ImGui::CalcTextSize(row.label.c_str()).x);
    }
    const auto lines = static_cast<float>(rows.size() + 1);
    const float height = lines * ImGui::GetTextLineHeightWithSpacing() - style.ItemSpacing.y;
    return painter.draw(static_cast<int>(std::ceil(width + 2 * style.WindowPadding.x)),
                        static_cast<int>(std::ceil(height + 2 * style.WindowPadding.y)), [&] {
                            ImGui::TextUnformatted(title.c_str());
                            for (const FaultRow& row : rows) {
                                colorRow(row.label, row.color);
                            }
                        });
}

std::string fieldText(render::SurfaceField field, double value) {
    if (render::infoOf(field).isLength) {
        return value == 0 ? "0" : lengthText(value);
    }
    return fmt::format("{:.3g} %", 100 * value);
}

void drawColors(const render::ColorMap& map, float left, float top, float width, float height) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float part = width / static_cast<float>(map.size() - 1);
    for (std::size_t i = 0; i + 1 < map.size(); ++i, left += part) {
        const ImU32 from = asHue(map[i]);
        const ImU32 to = asHue(map[i + 1]);
        draw.AddRectFilledMultiColor({left, top}, {left + part, top + height}, from, to, to, from);
    }
}

void drawFieldScale(const FieldLegend& legend, float scale) {
    const render::FieldInfo& info = render::infoOf(legend.field);
    const std::string under =
        legend.underPointer ? fieldText(legend.field, *legend.underPointer) : "-";
    ImGui::Text("%s: %s", std::string(info.name).c_str(), under.c_str());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = kWidth * scale;
    const float height = kHeight * scale;
    drawColors(legend.colors->colors, at.x, at.y, width, height);
    const float span = legend.range.high - legend.range.low;
    if (legend.underPointer && span != 0) {
        const float share = (static_cast<float>(*legend.underPointer) - legend.range.low) / span;
        const float x = at.x + width * std::min(std::max(share, 0.0F), 1.0F);
        drawPointer({x, at.y + 0.4F * height}, 0.6F * height);
    }
    drawNumbers(legend, {at.x, at.y + 1.15F * height}, width);
    ImGui::Dummy({width, 1.15F * height + ImGui::GetTextLineHeight()});
    noteItem("legend.field");
    if (!legend.note.empty()) {
        ImGui::TextDisabled("%s", wrapped(legend.note, width).c_str());
    }
}

}  // namespace kerf::ui
