#include <imgui.h>

#include <cfloat>

#include "ui/base/layout.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"
#include "ui/state/legends.h"

namespace kerf::ui {
namespace {

struct Switch {
    ActionId id;
    const char* label;
};
constexpr std::array kSwitches{
    Switch{ActionId::wireframe, "Wireframe"},
    Switch{ActionId::showEdges, "Edge springs"},
    Switch{ActionId::showIspcs, "Internal springs"},
    Switch{ActionId::showBends, "Bending"},
    Switch{ActionId::showErrors, "Constraint error"},
    Switch{ActionId::showContacts, "Contacts"},
    Switch{ActionId::showBoxes, "Bounding boxes"},
    Switch{ActionId::showCutLines, "Cut outlines"},
    Switch{ActionId::showAhead, "Cut preview"},
    Switch{ActionId::fineQuality, "High quality"},
    Switch{ActionId::section, "Section plane"},
};

void drawSwitches(const PanelModel& model, std::vector<Action>& actions) {
    const ImGuiStyle& style = ImGui::GetStyle();
    std::array<float, 2> widths{};
    for (std::size_t i = 0; i < kSwitches.size(); ++i) {
        const float text = ImGui::CalcTextSize(kSwitches[i].label).x;
        widths[i % 2] =
            std::max(widths[i % 2], text + ImGui::GetFrameHeight() + 2 * style.ItemInnerSpacing.x);
    }
    const int columns = widths[0] + widths[1] <= ImGui::GetContentRegionAvail().x ? 2 : 1;
    for (std::size_t i = 0; i < kSwitches.size(); ++i) {
        if (i % columns > 0) {
            ImGui::SameLine(style.WindowPadding.x + widths[0]);
        }
        bool on = isOn(model, kSwitches[i].id);
        if (checkbox(kSwitches[i].label, on, std::string("display.") + kSwitches[i].label,
                     describeAction(kSwitches[i].id))) {
            actions.emplace_back(kSwitches[i].id);
        }
    }
}

const char* labelOf(std::optional<render::LookName> look) {
    return look ? render::rowOf(*look).label : "As in the file";
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
    describeItem("display.look",
                 "Appearance of skin and cut faces. It does not affect the simulation");
    return changed;
}

bool chooseHardEdges(double& angle) {
    constexpr double kLow = 0;
    constexpr double kHigh = 180;
    const float width = ImGui::GetContentRegionAvail().x;
    return slideRow({"Hard edges above",
                     "Faces that meet at a larger angle have a hard edge: 0\u00b0 shades all flat, "
                     "180\u00b0 all smooth",
                     "display.hard_edges"},
                    {ImGuiDataType_Double, &angle, &kLow, &kHigh, "%.0f\u00b0"}, width)
        .changed;
}

/// Where the colours of the skin come from, for models that have some.
bool chooseSource(const PanelModel& model, render::ChosenColors& colors) {
    if (!model.looks.hasOwnColors) {
        return false;
    }
    bool own = colors.showOwn();
    const bool changed =
        checkbox("Model colours", own, "color.own",
                 "Show the colours and textures of the model's file instead of the skin colour");
    if (changed) {
        colors.ofLook = !own;
        if (own) {
            colors.look.reset();
            colors.skin.reset();
        }
    }
    return changed;
}

/// One of the quantities, or the look.
bool chooseField(render::FieldChoice& choice) {
    bool changed = false;
    const std::string current(render::infoOf(choice.field).name);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Colour by");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo("##field", current.c_str());
    noteItem("display.field");
    if (!open) {
        itemTooltip(describeAction(ActionId::nextField));
        return false;
    }
    for (int i = 0; i < render::kSurfaceFields; ++i) {
        const auto field = static_cast<render::SurfaceField>(i);
        const render::FieldInfo& info = render::infoOf(field);
        if (ImGui::Selectable(std::string(info.name).c_str(), field == choice.field)) {
            choice = {field, std::nullopt, choice.map};
            changed = true;
        }
        describeItem("field." + std::string(info.name), info.meaning);
    }
    ImGui::EndCombo();
    return changed;
}

/// The colours, by name and look.
bool chooseColorMap(render::FieldChoice& choice) {
    bool changed = false;
    rowLabel("Colours");
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##colors", render::colorsOf(choice).name)) {
        for (std::size_t i = 0; i < render::kColorMaps.size(); ++i) {
            const render::ColorMapRow& row = render::kColorMaps[i];
            const bool chosen = &row == &render::colorsOf(choice);
            if (ImGui::Selectable(row.name, chosen)) {
                choice.map = static_cast<render::ColorMapName>(i);
                changed = true;
            }
            noteItem(std::string("colors.") + row.name);
            const ImVec2 low = ImGui::GetItemRectMin();
            const ImVec2 size = ImGui::GetItemRectSize();
            drawColors(row.colors, low.x + size.x / 2, low.y, size.x / 2, size.y);
        }
        ImGui::EndCombo();
    }
    noteItem("display.colors");
    return changed;
}

/// A box for the automatic range, and where it is off, the ends of the fixed one.
bool chooseRange(render::FieldChoice& choice, const FieldLegend& legend) {
    bool automatic = !choice.range;
    bool changed = checkbox(
        "Automatic range", automatic, "display.automatic_range",
        "On: from the 2nd to the 98th percentile of the surface. Off: between two numbers of your "
        "choice");
    if (changed) {
        choice.range = automatic ? std::nullopt : std::optional(legend.range);
    }
    if (!choice.range) {
        return changed;
    }
    const bool length = render::infoOf(choice.field).isLength;
    const double unit = length ? 1 : 100;
    const double most = 1e6;
    const double least = -most;
    std::array<double, 2> ends{choice.range->low * unit, choice.range->high * unit};
    const auto speed = static_cast<float>(std::abs(ends[1] - ends[0]) / 200);
    ImGui::SetNextItemWidth(-1);
    if (dragNumbers(ends,
                    {ImGuiDataType_Double, nullptr, &least, &most, length ? "%.4g m" : "%.4g %%"},
                    std::max(speed, 1e-5F))) {
        const auto low = static_cast<float>(ends[0] / unit);
        const auto high = static_cast<float>(ends[1] / unit);
        choice.range = {low, high == low ? std::nextafter(low, FLT_MAX) : high};
        changed = true;
    }
    describeItem("display.range", "The values of the first and of the last colour");
    return changed;
}

/// A row of buttons: square to an axis, or the other half. True where one was pressed.
bool chooseSide(render::SectionPlane& plane, const Vec3& center) {
    constexpr std::array kAxes{"X", "Y", "Z"};
    bool changed = false;
    for (int axis = 0; axis < 3; ++axis) {
        if (smallButton(kAxes[axis], std::string("section.") + kAxes[axis],
                        "Perpendicular to this axis, through the centre of the body")) {
            plane = {center, Vec3::Unit(axis)};
            changed = true;
        }
        ImGui::SameLine();
    }
    if (smallButton("Flip", "section.other_half", "Swap the shown and the hidden half")) {
        plane.normal = -plane.normal;
        changed = true;
    }
    return changed;
}

/// Where the section lies and what it hides.
bool chooseSection(render::SectionPlane& plane, const PanelModel& model) {
    const Vec3 center = model.body.bounds.center();
    bool changed = chooseSide(plane, center);
    const double reach = 0.5 * model.body.bounds.diagonal();
    const double low = -reach;
    double along = -plane.distance(center);
    if (slideRow({"Offset", "Distance of the plane from the centre of the body", "section.along"},
                 {ImGuiDataType_Double, &along, &low, &reach,
                  std::string(lengthFormat(model.body.size)) + " m"},
                 ImGui::GetContentRegionAvail().x)
            .changed) {
        plane.point = center + along * plane.normal;
        changed = true;
    }
    return changed;
}

}  // namespace

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
    describeItem(std::string("color.") + label, tooltip);
    if (chosen) {
        ImGui::SameLine();
        if (resetButton(label)) {
            chosen.reset();
            changed = true;
        }
        itemTooltip("Reset colour");
    }
    return changed;
}

void drawDisplay(const PanelModel& model, std::vector<Action>& actions) {
    DisplaySettings display = model.display;
    bool changed = chooseLook(display.colors);
    drawSwitches(model, actions);
    changed |= chooseHardEdges(display.hardEdges);
    changed |= chooseColor("Skin", display.colors.skin, model.looks.ownSkin, "Colour of the skin");
    ImGui::SameLine(ImGui::GetContentRegionAvail().x / 2 + ImGui::GetStyle().WindowPadding.x);
    changed |= chooseColor("Inside", display.colors.flesh, model.looks.ownFlesh,
                           "Colour of the cut faces");
    changed |= chooseSource(model, display.colors);
    changed |= chooseField(display.field);
    if (display.field.field != render::SurfaceField::look) {
        changed |= chooseColorMap(display.field);
        changed |= chooseRange(display.field, model.looks.field);
    }
    if (display.section) {
        changed |= chooseSection(*display.section, model);
    }
    if (changed) {
        actions.emplace_back(SetDisplay{display});
    }
}

namespace {

ImU32 packed(const render::DisplayColor& c) {
    return IM_COL32(c[0], c[1], c[2], 255);
}

/// The colours of what overlays show.
void drawOverlayRows(const render::Overlays& overlays) {
    const auto add = [&](bool shown, const char* label, const render::DisplayColor& color) {
        if (shown) {
            colorRow(label, color);
        }
    };
    add(!overlays.errors && overlays.edges, "edge springs", render::kEdgeColor);
    add(!overlays.errors && overlays.bends, "bending", render::kBendColor);
    add(!overlays.errors && overlays.ispcs, "Internal springs", render::kIspcColor);
    add(overlays.contacts, "contacts", render::kContactColor);
    add(overlays.boxes, "bounding boxes", render::kBoxColor);
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

void drawLegend(const LooksState& looks, const DisplaySettings& display, const Rect& view,
                bool belowBoxes, float scale) {
    const bool field = display.field.field != render::SurfaceField::look;
    const bool body = !looks.showsFaulty && (display.overlays.any() || field);
    if (!body && looks.faults.empty()) {
        return;
    }
    const float margin = 10 * scale;
    const float top = belowBoxes ? topBoxesHeight() : margin;
    ImGui::SetNextWindowPos({view.x + view.width - margin, view.y + top}, ImGuiCond_Always, {1, 0});
    ImGui::SetNextWindowBgAlpha(0.7F);
    ImGui::Begin("legend", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (body && field) {
        drawFieldScale(looks.field, scale);
    }
    if (body) {
        drawOverlayRows(display.overlays);
    }
    drawFaultRows(looks.faults);
    if (body && display.overlays.errors) {
        drawErrorScale(scale);
    }
    ImGui::End();
}

}  // namespace kerf::ui
