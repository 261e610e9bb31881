#include "ui/display_panel.h"

#include <imgui.h>

#include <array>
#include <optional>
#include <string>

#include "ui/action_table.h"
#include "ui/item_rects.h"
#include "ui/menu_bar.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

struct Switch {
    ActionId id;
    const char* label;
};
constexpr std::array kSwitches{
    Switch{ActionId::wireframe, "Triangles"},      Switch{ActionId::showEdges, "Edges"},
    Switch{ActionId::showBends, "Bends"},          Switch{ActionId::showIspcs, "ISPCs"},
    Switch{ActionId::showErrors, "Errors"},        Switch{ActionId::showContacts, "Contacts"},
    Switch{ActionId::showBoxes, "Boxes"},          Switch{ActionId::showCutLines, "Lines of cuts"},
    Switch{ActionId::fineQuality, "Fine picture"},
};

void drawSwitches(const PanelModel& model, std::vector<Action>& actions) {
    const float half = ImGui::GetContentRegionAvail().x / 2;
    for (std::size_t i = 0; i < kSwitches.size(); ++i) {
        if (i % 2 == 1) {
            ImGui::SameLine(half + ImGui::GetStyle().WindowPadding.x);
        }
        bool on = isOn(model, kSwitches[i].id);
        if (ImGui::Checkbox(kSwitches[i].label, &on)) {
            actions.emplace_back(kSwitches[i].id);
        }
        noteItem(std::string("display.") + kSwitches[i].label);
        itemTooltip(describeAction(kSwitches[i].id));
    }
}

/// A colour that can be chosen, and a mark that brings the model's own back.
bool chooseColor(const char* label, std::optional<Vec3>& chosen, const Vec3& own,
                 const char* tooltip) {
    const Vec3f shown = chosen.value_or(own).cast<float>();
    std::array<float, 3> color{shown.x(), shown.y(), shown.z()};
    bool changed = false;
    if (ImGui::ColorEdit3(label, color.data(),
                          ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoOptions)) {
        chosen = Vec3(color[0], color[1], color[2]);
        changed = true;
    }
    noteItem(std::string("color.") + label);
    itemTooltip(tooltip);
    if (chosen) {
        ImGui::SameLine();
        if (resetButton(label)) {
            chosen.reset();
            changed = true;
        }
        itemTooltip("Back to the model's own colour");
    }
    return changed;
}

const char* labelOf(std::optional<render::LookName> look) {
    return look ? render::rowOf(*look).label : "The model's own";
}

/// Another look takes the colours that were chosen for the last one along with it.
bool chooseLook(render::ChosenColors& colors) {
    bool changed = false;
    const auto offer = [&](std::optional<render::LookName> look) {
        if (ImGui::Selectable(labelOf(look), colors.look == look)) {
            colors = {.look = look, .skin = {}, .flesh = {}};
            changed = true;
        }
        noteItem(std::string("look.") + labelOf(look));
    };
    rowLabel("Look");
    ImGui::SameLine(0.3F * ImGui::GetContentRegionAvail().x);
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##look", labelOf(colors.look), ImGuiComboFlags_HeightLargest)) {
        offer(std::nullopt);
        for (std::size_t i = 0; i < render::kLookNames; ++i) {
            offer(static_cast<render::LookName>(i));
        }
        ImGui::EndCombo();
    }
    noteItem("display.look");
    itemTooltip(
        "What the body looks made of, cut faces included; the simulation knows nothing of "
        "it");
    return changed;
}

bool chooseHardEdges(double& angle) {
    constexpr double kLow = 0;
    constexpr double kHigh = 180;
    const float width = ImGui::GetContentRegionAvail().x;
    return slideRow({"Hard edges above",
                     "Faces that meet at more than this angle have a hard edge "
                     "between them; 0 draws every triangle flat, 180 none",
                     "display.hard_edges"},
                    {ImGuiDataType_Double, &angle, &kLow, &kHigh, "%.0f\u00b0"}, width)
        .changed;
}

}  // namespace

void drawDisplay(const PanelModel& model, std::vector<Action>& actions) {
    DisplaySettings display = model.display;
    bool changed = chooseLook(display.colors);
    drawSwitches(model, actions);
    changed |= chooseHardEdges(display.hardEdges);
    changed |= chooseColor("Skin", display.colors.skin, model.ownSkin, "Colour of the skin");
    ImGui::SameLine(ImGui::GetContentRegionAvail().x / 2 + ImGui::GetStyle().WindowPadding.x);
    changed |=
        chooseColor("Flesh", display.colors.flesh, model.ownFlesh, "Colour of the cut faces");
    if (changed) {
        actions.emplace_back(SetDisplay{display});
    }
}

namespace {

/// A name and its colour.
struct LegendRow {
    const char* label;
    render::DisplayColor color;
};

ImU32 packed(const render::DisplayColor& c) {
    return IM_COL32(c[0], c[1], c[2], 255);
}

/// The rows that are shown, and how many.
std::array<LegendRow, 5> legendRows(const render::Overlays& overlays, std::size_t& count) {
    std::array<LegendRow, 5> rows{};
    const auto add = [&](bool shown, const char* label, const render::DisplayColor& color) {
        if (shown) {
            rows[count++] = {label, color};
        }
    };
    add(!overlays.errors && overlays.edges, "edges", render::kEdgeColor);
    add(!overlays.errors && overlays.bends, "bends", render::kBendColor);
    add(!overlays.errors && overlays.ispcs, "ISPCs", render::kIspcColor);
    add(overlays.contacts, "contacts", render::kContactColor);
    add(overlays.boxes, "boxes of pieces", render::kBoxColor);
    return rows;
}

void drawErrorScale(float scale) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = 150 * scale;
    const float height = 10 * scale;
    const ImU32 low = packed(render::kShortColor);
    const ImU32 middle = packed(render::kRestColor);
    const ImU32 high = packed(render::kLongColor);
    const float half = at.x + width / 2;
    draw.AddRectFilledMultiColor(at, {half, at.y + height}, low, middle, middle, low);
    draw.AddRectFilledMultiColor({half, at.y}, {at.x + width, at.y + height}, middle, high, high,
                                 middle);
    ImGui::Dummy({width, height});
    ImGui::TextUnformatted("-20 % or rad    at rest    +20 %");
}

}  // namespace

void drawLegend(const DisplaySettings& display, const Rect& view, float scale) {
    if (!display.overlays.any()) {
        return;
    }
    // Below the axes; what the editor says comes in the middle.
    const float margin = 10 * scale;
    ImGui::SetNextWindowPos({view.x + view.width - margin, view.y + 115 * scale}, ImGuiCond_Always,
                            {1, 0});
    ImGui::SetNextWindowBgAlpha(0.7F);
    ImGui::Begin("legend", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    std::size_t count = 0;
    const std::array<LegendRow, 5> rows = legendRows(display.overlays, count);
    for (std::size_t i = 0; i < count; ++i) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float line = ImGui::GetTextLineHeight();
        ImGui::GetWindowDrawList()->AddRectFilled(
            {at.x, at.y + 0.2F * line}, {at.x + line, at.y + 0.8F * line}, packed(rows[i].color));
        ImGui::Dummy({line, line});
        ImGui::SameLine();
        ImGui::TextUnformatted(rows[i].label);
    }
    if (display.overlays.errors) {
        drawErrorScale(scale);
    }
    ImGui::End();
}

}  // namespace kerf::ui
