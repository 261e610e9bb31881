#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include "sim/base/text.h"
#include "ui/base/layout.h"
#include "ui/base/theme.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

constexpr float kRowPadding = 0.2F;  ///< above and below a row [font sizes]
constexpr float kRoomyTitle = 23;    ///< has room for all buttons beside its text [font sizes]

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
    itemTooltip(piece.hidden ? "Show" : "Hide. It still moves and is still cut");
}

ImU32 colorOf(int index, const PieceRow& piece) {
    const Vec3 own = piece.color.value_or(Vec3::Zero());
    return piece.color ? ImGui::ColorConvertFloat4ToU32({static_cast<float>(own.x()),
                                                         static_cast<float>(own.y()),
                                                         static_cast<float>(own.z()), 1})
                       : pieceColor(index);
}

void chipCell(int index, const PieceRow& piece) {
    const float side = 0.75F * ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float top = at.y + (ImGui::GetTextLineHeight() - side) / 2;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, top}, {at.x + side, top + side},
                                              colorOf(index, piece), side / 4);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.3F * side);
    ImGui::Text("%d", index + 1);
}

/// The whole row takes the pointer, the eye on top of it. True while the pointer is there.
bool rowButton(int index, bool selected, std::vector<Action>& actions) {
    const ImGuiSelectableFlags flags =
        ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap;
    if (ImGui::Selectable("##row", selected, flags)) {
        actions.emplace_back(SelectPiece{selected ? -1 : index});
        if (!selected) {
            actions.emplace_back(FramePiece{index});
        }
    }
    noteItem("piece." + std::to_string(index));
    const bool hovered = ImGui::IsItemHovered(
        ImGuiHoveredFlags_AllowWhenOverlapped |
        ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);  // while the eye is held
    ImGui::SameLine(0, 0);
    return hovered;
}

std::string coordinates(const Vec3& v) {
    return fmt::format("{:.3g} {:.3g} {:.3g}", v.x(), v.y(), v.z());
}

/// The columns that are there on demand. Sums come once time stands.
void drawDetails(const PieceRow& piece) {
    ImGui::TableNextColumn();
    textRight(fmt::format("{:.2f}", 100 * piece.shareOfAll));
    ImGui::TableNextColumn();
    textRight(piece.sums ? areaText(piece.sums->skinArea + piece.sums->cutArea) : "-");
    if (piece.sums) {
        itemTooltip("Skin " + areaText(piece.sums->skinArea) + ", cut faces " +
                    areaText(piece.sums->cutArea));
    }
    ImGui::TableNextColumn();
    textRight(piece.bounds.empty() ? "-" : coordinates(piece.bounds.high - piece.bounds.low));
    ImGui::TableNextColumn();
    textRight(piece.sums ? coordinates(piece.sums->centroid) : "-");
}

/// True while the pointer is on the row.
bool drawRow(int index, const PiecesState& pieces, bool details, std::vector<Action>& actions) {
    const PieceRow& piece = pieces.rows[static_cast<std::size_t>(index)];
    ImGui::TableNextRow();
    ImGui::PushID(index);
    ImGui::TableNextColumn();
    const bool hovered = rowButton(index, index == pieces.selected, actions);
    eyeCell(index, piece, actions);
    ImGui::TableNextColumn();
    chipCell(index, piece);
    ImGui::TableNextColumn();
    textRight(std::to_string(piece.triangles));
    ImGui::TableNextColumn();
    textRight(volumeText(piece.volume));
    ImGui::TableNextColumn();
    textRight(fmt::format("{:.2f}", 100 * piece.share));
    if (details) {
        drawDetails(piece);
    }
    ImGui::PopID();
    return hovered;
}

struct ColumnTitle {
    PieceColumn column;
    const char* title;
    float width;  ///< in letters; of what is left in a short list, a share of it
    const char* tooltip;
};
constexpr std::array kColumns{
    ColumnTitle{PieceColumn::number, "#", 2, "In order of creation"},
    ColumnTitle{PieceColumn::triangles, "tri.", 3.6F, "Number of surface triangles"},
    ColumnTitle{PieceColumn::volume, "volume", 5.4F, "Current volume"},
    ColumnTitle{PieceColumn::ofRest, "% rest", 4.6F, "Percentage of its volume at rest"},
    ColumnTitle{PieceColumn::ofAll, "% all", 4, "Percentage of the volume of all pieces"},
    ColumnTitle{PieceColumn::area, "area", 5.5F, "Surface area, including cut faces"},
    ColumnTitle{PieceColumn::size, "size x y z [m]", 9, "Size of its bounding box"},
    ColumnTitle{PieceColumn::centre, "centre x y z [m]", 10, "Centroid of its volume"},
};
constexpr std::size_t kShortColumns = 4;  // without details

std::size_t columnCount(bool details) {
    return details ? kColumns.size() : kShortColumns;
}

void setUpColumns(bool details) {
    const float letter = ImGui::GetFontSize();
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn(
        "##eye", ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_NoSort, 1.3F * letter);
    for (std::size_t i = 0; i < columnCount(details); ++i) {
        const ColumnTitle& column = kColumns[i];
        const bool fixed = details || column.column == PieceColumn::number;
        ImGui::TableSetupColumn(
            column.title,
            fixed ? ImGuiTableColumnFlags_WidthFixed : ImGuiTableColumnFlags_WidthStretch,
            fixed ? column.width * letter : column.width, static_cast<ImGuiID>(column.column));
    }
}

/// A click on a title sorts by it, another one the other way round.
void drawHeader(bool details) {
    setUpColumns(details);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableNextColumn();
    for (std::size_t i = 0; i < columnCount(details); ++i) {
        ImGui::TableNextColumn();
        ImGui::TableHeader(kColumns[i].title);
        describeItem(std::string("pieces.by.") + kColumns[i].title,
                     std::string(kColumns[i].tooltip) + ". Click to sort");
    }
}

std::vector<int> orderOf(const std::vector<PieceRow>& rows) {
    const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
    if (specs == nullptr || specs->SpecsCount == 0) {
        return sortedPieces(rows, PieceColumn::number, false);
    }
    const ImGuiTableColumnSortSpecs& by = specs->Specs[0];
    return sortedPieces(rows, static_cast<PieceColumn>(by.ColumnUserID),
                        by.SortDirection == ImGuiSortDirection_Descending);
}

/// The row under the pointer, -1 for none.
int drawRows(const PiecesState& pieces, bool details, std::vector<Action>& actions) {
    int hovered = -1;
    const std::vector<int> order = orderOf(pieces.rows);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(order.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const int piece = order[static_cast<std::size_t>(i)];
            hovered = drawRow(piece, pieces, details, actions) ? piece : hovered;
        }
    }
    return hovered;
}

/// What can be done with the selected piece, in the heading.
void drawSelected(const PiecesState& pieces, std::vector<Action>& actions) {
    if (pieces.selected < 0 || pieces.selected >= static_cast<int>(pieces.rows.size())) {
        return;
    }
    const ImVec4 usual = ImGui::ColorConvertU32ToFloat4(pieceColor(pieces.selected));
    std::optional<Vec3> color = pieces.rows[static_cast<std::size_t>(pieces.selected)].color;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SameLine(0, gap);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, 0});
    if (chooseColor("##piece", color, {usual.x, usual.y, usual.z},
                    "Colour of the selected piece, in the view only")) {
        actions.emplace_back(ColorPiece{pieces.selected, color});
    }
    ImGui::PopStyleVar();
    ImGui::SameLine(0, gap);
    if (smallButton("Export", "piece.export", "Export the selected piece alone")) {
        actions.emplace_back(ExportSelectedPiece{});
    }
    ImGui::SameLine(0, gap);
    if (smallButton("Delete", "piece.delete",
                    "Delete the selected piece, with what holds or pulls it")) {
        actions.emplace_back(RemovePiece{pieces.selected});
    }
}

/// Buttons at the right end of the heading: all columns, and the export.
void drawTableButtons(const DisplaySettings& chosen, std::vector<Action>& actions) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const char* const label = chosen.pieceDetails ? "Less" : "More";
    ImGui::SameLine(ImGui::GetContentRegionMax().x - buttonWidth(label) - buttonWidth("CSV") - gap);
    if (smallButton(label, "pieces.details",
                    "Show share, area, size and centre, too. Areas and centres are computed while "
                    "paused")) {
        DisplaySettings display = chosen;
        display.pieceDetails = !display.pieceDetails;
        actions.emplace_back(SetDisplay{display});
    }
    ImGui::SameLine(0, gap);
    if (smallButton("CSV", "pieces.csv",
                    "Save the table with all columns as CSV in the current folder")) {
        actions.emplace_back(ExportPieces{});
    }
}

/// Draws the pieces away from each other, without moving them.
void slideApart(const DisplaySettings& chosen, std::vector<Action>& actions) {
    constexpr double kLeast = 0;
    constexpr double kMost = 1;
    DisplaySettings display = chosen;
    const std::string tooltip =
        "Draw the pieces apart without moving them. Ends when you play or cut. " +
        describeAction(ActionId::showApart);
    if (slideRow({"Apart", tooltip, "pieces.apart"},
                 {ImGuiDataType_Double, &display.apart, &kLeast, &kMost, "%.2f"},
                 ImGui::GetContentRegionAvail().x)
            .changed) {
        actions.emplace_back(SetDisplay{display});
    }
}

/// The heading, and what brings hidden pieces back or shows all apart.
void drawTitle(const PiecesState& pieces, const DisplaySettings& chosen,
               std::vector<Action>& actions) {
    const auto hidden = std::ranges::count_if(pieces.rows, &PieceRow::hidden);
    const bool roomy = ImGui::GetContentRegionAvail().x > kRoomyTitle * ImGui::GetFontSize();
    if (roomy || pieces.selected < 0) {
        ImGui::TextDisabled("Pieces: %zu", pieces.rows.size());
    } else {
        ImGui::TextUnformatted("");
    }
    drawSelected(pieces, actions);
    drawTableButtons(chosen, actions);
    if (hidden == 0) {
        if (pieces.rows.size() > 1) {
            slideApart(chosen, actions);
        }
        return;
    }
    ImGui::TextDisabled("(%td hidden)", hidden);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - buttonWidth("Show all"));
    if (smallButton("Show all", "pieces.show_all")) {
        for (std::size_t i = 0; i < pieces.rows.size(); ++i) {
            actions.emplace_back(ShowPiece{static_cast<int>(i), true});
        }
    }
}

}  // namespace

float piecesHeight(const PiecesState& pieces, const DisplaySettings& display) {
    const std::size_t rows = pieces.rows.size();
    const float slider = rows > 1 ? ImGui::GetFrameHeightWithSpacing() : 0;
    const float row = ImGui::GetTextLineHeight() + 2 * kRowPadding * ImGui::GetFontSize();
    const float bar = display.pieceDetails ? ImGui::GetStyle().ScrollbarSize : 0;
    return ImGui::GetFrameHeightWithSpacing() + slider + static_cast<float>(rows + 1) * row + bar;
}

void drawPieces(const PiecesState& pieces, const DisplaySettings& display,
                std::vector<Action>& actions) {
    drawTitle(pieces, display, actions);
    const bool details = display.pieceDetails;
    const ImGuiTableFlags flags =
        ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_Sortable |
        (details ? ImGuiTableFlags_ScrollX | ImGuiTableFlags_SizingFixedFit
                 : ImGuiTableFlags_SizingStretchProp);
    int hovered = -1;
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding,
                        {0.25F * ImGui::GetFontSize(), kRowPadding * ImGui::GetFontSize()});
    const int columns = static_cast<int>(columnCount(details)) + 1;
    if (ImGui::BeginTable(details ? "all columns" : "pieces", columns, flags)) {
        drawHeader(details);
        hovered = drawRows(pieces, details, actions);
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
    if (hovered != pieces.hovered) {
        actions.emplace_back(HoverPiece{hovered});
    }
}

}  // namespace kerf::ui
