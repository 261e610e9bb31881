#include "ui/state/fault_legend.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "sim/base/mapped.h"
#include "ui/base/item_rects.h"
#include "ui/base/picture_painter.h"
#include "ui/base/widgets.h"

namespace kerf::ui {

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

}  // namespace kerf::ui
