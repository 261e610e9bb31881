#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include "sim/base/text.h"
#include "ui/base/layout.h"
#include "ui/base/unit_text.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

constexpr double kLeastScale = 1e-6;
constexpr double kMostScale = 1e6;
constexpr double kMostTurn = 360;  // [degrees]

/// Goes on with the line where a small button with that word has room there.
void nextOrNewLine(const std::string& word) {
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (ImGui::GetContentRegionAvail().x < buttonWidth(word)) {
        ImGui::NewLine();
    }
}

/// Small buttons of one row, of which one is chosen. Returns the one that was clicked.
std::optional<std::size_t> drawChoice(const char* label, const std::string& name,
                                      std::span<const std::string_view> words, std::size_t chosen) {
    std::optional<std::size_t> clicked;
    ImGui::TextUnformatted(label);
    ImGui::PushID(label);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string word(words[i]);
        nextOrNewLine(word);
        if (i == chosen) {
            ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab));
        }
        if (smallButton(word.c_str(), std::string(name).append(".").append(word))) {
            clicked = i;
        }
        if (i == chosen) {
            ImGui::PopStyleColor();
        }
    }
    ImGui::PopID();
    return clicked;
}

/// How a row of numbers is changed.
struct NumberRow {
    const char* label;
    std::size_t count;
    float speed;  ///< per pixel of a drag
    double low;
    double high;
    const char* format;
    bool logarithmic = false;
};
constexpr NumberRow kTurnRow{"Rotate", 3, 0.5F, -kMostTurn, kMostTurn, "%.1f\u00b0"};
constexpr NumberRow kScaleRow{"Scale", 1, 0.005F, kLeastScale, kMostScale, "%.4g", true};

/// A body that is too large to follow each move of a drag takes typed numbers.
bool changeNumbers(const NumberRow& row, bool live, double* values) {
    return dragNumbers(
        {values, row.count},
        {ImGuiDataType_Double, nullptr, &row.low, &row.high, row.format, row.logarithmic},
        live ? row.speed : kTypedOnly);
}

/// A model that a person looks at in the panel.
struct ShownModel {
    const ModelState& state;
    int number = 0;
    bool live = true;  ///< see ModelPanelState::live
};

void drawNumbers(const NumberRow& row, const ShownModel& model, const Placement& edited,
                 double* values, std::vector<Action>& actions) {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 4.2F * ImGui::GetFontSize());
    ImGui::PushID(row.label);
    const bool changed = changeNumbers(row, model.live, values);
    noteItem(std::string("model.") + row.label);
    const bool continues = continuesGesture(changed);
    if (changed) {
        actions.emplace_back(PlaceModel{edited, continues, model.number});
    }
    ImGui::SameLine();
    ImGui::TextUnformatted(row.label);
    ImGui::PopID();
}

void drawTurnAndScale(const ShownModel& model, std::vector<Action>& actions) {
    Placement turned = model.state.placement;
    drawNumbers(kTurnRow, model, turned, turned.rotate.data(), actions);
    Placement scaled = model.state.placement;
    drawNumbers(kScaleRow, model, scaled, &scaled.scale, actions);
}

std::string sizeText(const Vec3& size) {
    return lengthText(size.x()) + " \u00d7 " + lengthText(size.y()) + " \u00d7 " +
           lengthText(size.z());
}

void drawChoices(const ShownModel& model, std::vector<Action>& actions) {
    Placement placement = model.state.placement;
    const auto unit = static_cast<std::size_t>(placement.unit.value_or(LengthUnit::metre));
    if (const auto clicked = drawChoice("Unit", "model.unit", kLengthUnitNames, unit)) {
        placement.unit = static_cast<LengthUnit>(*clicked);
        actions.emplace_back(PlaceModel{placement, false, model.number});
    }
    const auto up = static_cast<std::size_t>(placement.up.value_or(UpAxis::y));
    if (const auto clicked = drawChoice("Up", "model.up", kUpAxisNames, up)) {
        placement.up = static_cast<UpAxis>(*clicked);
        actions.emplace_back(PlaceModel{placement, false, model.number});
    }
}

/// The lines of the list, with one between those that come with Kerf and a person's own.
void offerMaterials(const ModelPanelState& model, const ShownModel& shown,
                    std::vector<Action>& actions) {
    for (int m = 0; m < static_cast<int>(model.materials.size()); ++m) {
        const MaterialRow& row = model.materials[m];
        if (m > 0 && row.own != model.materials[m - 1].own) {
            ImGui::Separator();
        }
        ImGui::PushID(m);
        if (ImGui::Selectable(row.label.c_str(), m == shown.state.material)) {
            actions.emplace_back(TakeMaterial{m, shown.number});
        }
        ImGui::PopID();
        describeItem("material." + row.label, withRaisedDigits(row.tooltip));
    }
    ImGui::Separator();
    if (ImGui::Selectable("Save material...")) {
        actions.emplace_back(SaveMaterial{});
    }
    describeItem("material.save", "Save these values and the look as your own material");
}

void drawMaterial(const ModelPanelState& model, const ShownModel& shown,
                  std::vector<Action>& actions) {
    const bool known = shown.state.material >= 0;
    const MaterialRow* const row = known ? &model.materials[shown.state.material] : nullptr;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Material");
    ImGui::SameLine(0.3F * ImGui::GetContentRegionAvail().x);
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo("##material", known ? row->label.c_str() : "Custom",
                                        ImGuiComboFlags_HeightLargest);
    noteItem("model.material");
    if (open) {
        offerMaterials(model, shown, actions);
        ImGui::EndCombo();
    } else {
        itemTooltip(known ? withRaisedDigits(row->tooltip)
                          : "Sets stiffness, density, friction, damping and look");
    }
}

/// With edges as long as proposed, or as typed: that is kept as a share of the proposal. Shown as
/// long as they are in the scene.
void drawRemesh(const ShownModel& shown, std::vector<Action>& actions) {
    const ModelState& state = shown.state;
    float& share = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID(state.name.c_str()), 1);
    const double proposed = state.placement.scale * state.edge;
    double edge = share * proposed;
    const bool clicked = button(
        "Remesh", "model.remesh",
        fmt::format("Rebuild the surface with about {:.0f} evenly sized triangles. Resets the cuts "
                    "and drops texture coordinates and vertex colours (undoable)",
                    state.remeshed / (share * share)));
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    const LengthUnit unit = state.placement.unit.value_or(LengthUnit::metre);
    const std::string format = fmt::format("Edge length %.3g {}", nameOf(unit));
    if (changeNumbers({"", 1, static_cast<float>(proposed / 200), proposed / 10, 10 * proposed,
                       format.c_str()},
                      true, &edge)) {
        share = static_cast<float>(edge / proposed);
    }
    noteItem("model.edge");
    if (clicked) {
        actions.emplace_back(Remesh{shown.number, edge / state.placement.scale});
        share = 1;
    }
}

/// How poor the triangles are, and what can be done about it.
void drawTriangles(const ModelPanelState& model, const ShownModel& shown,
                   const DisplaySettings& shownNow, std::vector<Action>& actions) {
    const ModelState& state = shown.state;
    textWrapped(state.triangles);
    describeItem(
        "model.triangles",
        "Soft bodies behave best with evenly sized triangles. Slivers are triangles whose height "
        "is below a tenth of their longest edge");
    drawRemesh(shown, actions);
    if (state.crosses) {
        if (button("Unite pieces", "model.unite",
                   "Some triangles intersect. Merge intersecting pieces into one surface, so that "
                   "overlaps count once")) {
            actions.emplace_back(UnitePieces{shown.number});
        }
    }
    if (model.objects > 1) {
        if (button("Split into models", "model.part",
                   fmt::format(
                       "Make a model of each of the file's {} objects, with its own placement and "
                       "material. Resets the cuts (undoable)",
                       model.objects))) {
            actions.emplace_back(ActionId::partModel);
        }
    }
    if (model.faultCount > 0) {
        DisplaySettings display = shownNow;
        if (checkbox("Show faults", display.overlays.faults, "model.faults",
                     "Highlight slivers and intersecting triangles that are not cut yet")) {
            actions.emplace_back(SetDisplay{display});
        }
    }
}

/// A row per model of the scene. Returns the chosen one.
int chooseModel(const ModelPanelState& model, std::vector<Action>& actions) {
    int& chosen = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("chosen model"), 0);
    chosen = std::min(chosen, static_cast<int>(model.models.size()) - 1);
    for (int m = 0; m < static_cast<int>(model.models.size()); ++m) {
        ImGui::PushID(m);
        const std::string number = std::to_string(m);
        const float room = m > 0 ? 1.5F * ImGui::GetFrameHeight() : 0;
        if (ImGui::Selectable((number + "  " + model.models[m].name).c_str(), m == chosen, 0,
                              {ImGui::GetContentRegionAvail().x - room, 0})) {
            chosen = m;
        }
        noteItem("model." + number);
        if (m > 0) {
            ImGui::SameLine();
            if (smallButton("\u00d7", "model.remove." + number,
                            "Remove this model from the scene")) {
                actions.emplace_back(RemoveModel{m});
            }
        }
        ImGui::PopID();
    }
    return chosen;
}

}  // namespace

void drawModel(const ModelPanelState& model, const ParametersState& parameters,
               const DisplaySettings& display, std::vector<Action>& actions) {
    if (model.models.empty()) {
        return;
    }
    const int number = model.models.size() > 1 ? chooseModel(model, actions) : 0;
    const ShownModel shown{model.models[number], number, model.live};
    const ModelState& state = shown.state;
    textWrapped(sizeText(state.size));
    describeItem("model.size", "Width, height and depth of the uncut model in the scene");
    drawChoices(shown, actions);
    drawTurnAndScale(shown, actions);
    drawMaterial(model, shown, actions);
    if (number > 0) {
        drawOwnParameters(number, parameters, actions);
    }
    textWrapped(state.physics);
    if (!state.guess.empty()) {
        textWrapped(state.guess, true);
    }
    drawTriangles(model, shown, display, actions);
    if (!model.untouched) {
        textWrapped("Changing the placement resets the cuts (undoable).", true);
    }
    if (button("Add model...", "model.add",
               "Add another model to the scene: " + keysOf(ActionId::addModel))) {
        actions.emplace_back(ActionId::addModel);
    }
}

}  // namespace kerf::ui
