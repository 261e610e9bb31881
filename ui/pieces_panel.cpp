#include "ui/pieces_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ui/action_table.h"
#include "ui/item_rects.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

/// An open eye, or one with a bar across.
void drawEye(const ImVec2& center, float size, bool open) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 color = open ? palette().text : palette().dimText;
    const float thickness = size / 10;
    for (const float up : {-1.0F, 1.0F}) {
        draw.PathLineTo({center.x - 0.5F * size, center.y});
        draw.PathBezierQuadraticCurveTo({center.x, center.y + up * 0.62F * size},
                                        {center.x + 0.5F * size, center.y}, 12);
        draw.PathStroke(color, 0, thickness);
    }
    if (open) {
        draw.AddCircleFilled(center, 0.16F * size, color, 12);
    } else {
        draw.AddLine({center.x - 0.42F * size, center.y + 0.42F * size},
                     {center.x + 0.42F * size, center.y - 0.42F * size}, color, 1.4F * thickness);
    }
}

void eyeCell(int index, const PieceRow& piece, std::vector<Action>& actions) {
    const float side = ImGui::GetTextLineHeight();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("eye", {1.3F * side, side})) {
        actions.emplace_back(ShowPiece{index, piece.hidden});
    }
    noteItem("eye." + std::to_string(index));
    drawEye({low.x + 0.65F * side, low.y + 0.5F * side}, side, !piece.hidden);
    itemTooltip(piece.hidden ? "Show it again"
                             : "Hide it; it goes on moving and is cut all the same");
}

void chipCell(int index) {
    const float side = 0.75F * ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float top = at.y + (ImGui::GetTextLineHeight() - side) / 2;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, top}, {at.x + side, top + side},
                                              pieceColor(index), side / 4);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.3F * side);
    ImGui::Text("%d", index + 1);
}

/// The whole row takes the pointer, the eye on top of it. True while the pointer is there.
bool rowButton(int index, std::vector<Action>& actions) {
    const ImGuiSelectableFlags flags =
        ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap;
    if (ImGui::Selectable("##row", false, flags)) {
        actions.emplace_back(FramePiece{index});
    }
    noteItem("piece." + std::to_string(index));
    const bool hovered = ImGui::IsItemHovered(
        ImGuiHoveredFlags_AllowWhenOverlapped |
        ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);  // while the eye is held
    ImGui::SameLine(0, 0);
    return hovered;
}

/// True while the pointer is on the row.
bool drawRow(int index, const PieceRow& piece, std::vector<Action>& actions) {
    char text[32];
    ImGui::TableNextRow();
    ImGui::PushID(index);
    ImGui::TableNextColumn();
    const bool hovered = rowButton(index, actions);
    eyeCell(index, piece, actions);
    ImGui::TableNextColumn();
    chipCell(index);
    ImGui::TableNextColumn();
    textRight(std::to_string(piece.triangles));
    ImGui::TableNextColumn();
    textRight(volumeText(piece.volume));
    ImGui::TableNextColumn();
    std::snprintf(text, sizeof text, "%.2f", 100 * piece.share);
    textRight(text);
    ImGui::PopID();
    return hovered;
}

void drawHeader() {
    const float letter = ImGui::GetFontSize();
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 1.3F * letter);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 2 * letter);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 1.2F);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 1.1F);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 1);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("#");
    for (const char* title : {"triangles", "volume", "% rest"}) {
        ImGui::TableNextColumn();
        textRight(title);
    }
}

/// The row under the pointer, -1 for none.
int drawRows(const PanelModel& model, std::vector<Action>& actions) {
    int hovered = -1;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(model.pieces.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            hovered = drawRow(i, model.pieces[static_cast<std::size_t>(i)], actions) ? i : hovered;
        }
    }
    return hovered;
}

/// Draws the pieces away from each other, without moving them.
void slideApart(const PanelModel& model, std::vector<Action>& actions) {
    constexpr double kLeast = 0;
    constexpr double kMost = 1;
    DisplaySettings display = model.display;
    const std::string tooltip =
        "Shows the pieces apart without moving them, until time runs or a blade comes. " +
        describeAction(ActionId::showApart);
    if (slideRow({"Apart", tooltip, "pieces.apart"},
                 {ImGuiDataType_Double, &display.apart, &kLeast, &kMost, "%.2f"},
                 ImGui::GetContentRegionAvail().x)
            .changed) {
        actions.emplace_back(SetDisplay{display});
    }
}

/// The heading, and what brings hidden pieces back or shows all apart.
void drawTitle(const PanelModel& model, std::vector<Action>& actions) {
    const auto hidden = std::ranges::count_if(model.pieces, &PieceRow::hidden);
    ImGui::TextDisabled("Pieces: %zu", model.pieces.size());
    if (hidden == 0) {
        if (model.pieces.size() > 1) {
            slideApart(model, actions);
        }
        return;
    }
    ImGui::SameLine();
    ImGui::TextDisabled("(%td hidden)", hidden);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - buttonWidth("Show all"));
    if (ImGui::SmallButton("Show all")) {
        for (std::size_t i = 0; i < model.pieces.size(); ++i) {
            actions.emplace_back(ShowPiece{static_cast<int>(i), true});
        }
    }
    noteItem("pieces.show_all");
}

}  // namespace

std::string volumeText(double volume) {
    struct Unit {
        double size;
        const char* name;
    };
    static constexpr std::array kUnits{Unit{1, "m\u00b3"}, Unit{1e-3, "l"}, Unit{1e-6, "ml"}};
    const auto* unit = std::ranges::find_if(
        kUnits, [volume](const Unit& u) { return std::abs(volume) >= 0.1 * u.size; });
    const Unit& chosen = unit == kUnits.end() ? kUnits.back() : *unit;
    char text[32];
    std::snprintf(text, sizeof text, "%.3g %s", volume / chosen.size, chosen.name);
    return text;
}

void drawPieces(const PanelModel& model, std::vector<Action>& actions) {
    drawTitle(model, actions);
    constexpr ImGuiTableFlags kFlags =
        ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingStretchProp;
    int hovered = -1;
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding,
                        {0.25F * ImGui::GetFontSize(), 0.2F * ImGui::GetFontSize()});
    if (ImGui::BeginTable("pieces", 5, kFlags)) {
        drawHeader();
        hovered = drawRows(model, actions);
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
    if (hovered != model.hoveredPiece) {
        actions.emplace_back(HoverPiece{hovered});
    }
}

}  // namespace kerf::ui
