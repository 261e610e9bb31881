#include "ui/parameters_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdio>

#include "sim/solve/sweep_strength.h"
#include "ui/action_table.h"
#include "ui/item_rects.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

constexpr std::array<std::string_view, 4> kProminent{"time_step", "iterations", "ispc_stiffness",
                                                     "gravity"};

bool isProminent(const ParamInfo& info) {
    return std::ranges::find(kProminent, info.name) != kProminent.end();
}

/// 0 or 1.
bool isSwitch(const ParamInfo& info) {
    return info.type == ParamType::integer && info.low == 0 && info.high == 1;
}

int decimalsFor(const ParamInfo& info) {
    if (info.type == ParamType::vector || info.type == ParamType::optionalReal) {
        return 2;
    }
    if (info.logarithmic) {
        return std::clamp(-static_cast<int>(std::floor(std::log10(info.low))), 0, 6);
    }
    return std::clamp(2 - static_cast<int>(std::floor(std::log10(info.high))), 0, 6);
}

ImGuiSliderFlags sliderFlags(const ParamInfo& info) {
    // Wide signed ranges get the logarithmic scale too: fine near zero, and zero easy to hit.
    const bool wide = info.type == ParamType::vector || info.type == ParamType::optionalReal;
    const ImGuiSliderFlags scale = info.logarithmic || wide ? ImGuiSliderFlags_Logarithmic : 0;
    return ImGuiSliderFlags_AlwaysClamp | scale;
}

/// "m/s^2" as people write it: with a raised digit.
std::string unitText(const ParamInfo& info) {
    std::string text;
    for (std::size_t i = 0; i < info.unit.size(); ++i) {
        if (info.unit.substr(i, 2) == "^2" || info.unit.substr(i, 2) == "^3") {
            text += info.unit[++i] == '2' ? "\u00b2" : "\u00b3";
        } else {
            text += info.unit[i];
        }
    }
    return text;
}

/// The value that the paper's section 3.1 gives a parameter; "" where it gives no value.
std::string_view paperValue(std::string_view name) {
    if (name == "time_step") {
        return "0.005 s for the spheres, 0.003 s for the octopus and the banana";
    }
    if (name == "iterations") {
        return "30 for Sphere 20 and 80, 20 for Sphere 768 and the octopus, 10 for the banana";
    }
    if (name == "gravity") {
        return "none while the blade cuts, then on";
    }
    return "";
}

std::string numberText(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string rangeText(const ParamInfo& info) {
    std::string text = "Range: " + numberText(info.low) + " to " + numberText(info.high);
    if (!info.unit.empty()) {
        text += " " + unitText(info);
    }
    return text + (info.type == ParamType::vector ? ", each of x, y and z" : "");
}

std::string tooltipOf(const ParamInfo& info) {
    std::string text(info.meaning);
    if (info.type != ParamType::choice && !isSwitch(info)) {
        text += "\n" + rangeText(info) + ". Ctrl+click to type a value.";
    }
    if (const std::string_view paper = paperValue(info.name); !paper.empty()) {
        text += "\nPaper: " + std::string(paper) + ".";
    }
    return text + "\nIn a session: " + std::string(info.name);
}

/// Width of an item that leaves room for the reset mark [px].
float resetRoom() {
    return -(ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x);
}

/// A slider over a double. True while its value is being changed.
bool slideReal(const ParamInfo& info, const char* id, double& value) {
    const std::string format = sliderFormat(info);
    return ImGui::SliderScalar(id, ImGuiDataType_Double, &value, &info.low, &info.high,
                               format.c_str(), sliderFlags(info));
}

bool flipSwitch(double& value) {
    bool on = value != 0;
    const bool changed = ImGui::Checkbox("##value", &on);
    value = on ? 1 : 0;
    return changed;
}

bool slideInteger(const ParamInfo& info, double& value) {
    int whole = static_cast<int>(std::lround(value));
    const bool changed =
        ImGui::SliderInt("##value", &whole, static_cast<int>(info.low), static_cast<int>(info.high),
                         sliderFormat(info).c_str(), sliderFlags(info));
    value = whole;
    return changed;
}

bool slideVector(const ParamInfo& info, Vec3& value) {
    static constexpr std::array<const char*, 3> kAxes{"##x", "##y", "##z"};
    static constexpr std::array<const char*, 3> kFormats{"x %.2f", "y %.2f", "z %.2f"};
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (ImGui::CalcItemWidth() - 2 * gap) / 3;
    bool changed = false;
    for (int axis = 0; axis < 3; ++axis) {
        ImGui::SetNextItemWidth(width);
        changed |= ImGui::SliderScalar(kAxes[axis], ImGuiDataType_Double, &value[axis], &info.low,
                                       &info.high, kFormats[axis], sliderFlags(info));
        if (axis < 2) {
            ImGui::SameLine(0, gap);
        }
    }
    return changed;
}

bool slideOptional(const ParamInfo& info, ParamValue& value) {
    bool present = !std::holds_alternative<std::monostate>(value);
    bool changed = false;
    if (ImGui::Checkbox("##present", &present)) {
        value = present ? ParamValue{std::clamp(0.0, info.low, info.high)} : std::monostate{};
        changed = true;
    }
    ImGui::SameLine();
    if (double* number = std::get_if<double>(&value)) {
        ImGui::SetNextItemWidth(resetRoom());
        changed |= slideReal(info, "##value", *number);
    } else {
        ImGui::TextDisabled("none");
    }
    return changed;
}

bool chooseValue(const ParamInfo& info, std::string& value) {
    if (!ImGui::BeginCombo("##value", value.c_str())) {
        return false;
    }
    bool changed = false;
    for (const std::string_view choice : info.choices) {
        if (ImGui::Selectable(std::string(choice).c_str(), value == choice)) {
            value = choice;
            changed = true;
        }
    }
    ImGui::EndCombo();
    return changed;
}

bool slideValue(const ParamInfo& info, ParamValue& value) {
    switch (info.type) {
        case ParamType::real:
            return slideReal(info, "##value", std::get<double>(value));
        case ParamType::integer:
            return isSwitch(info) ? flipSwitch(std::get<double>(value))
                                  : slideInteger(info, std::get<double>(value));
        case ParamType::vector:
            return slideVector(info, std::get<Vec3>(value));
        case ParamType::optionalReal:
            return slideOptional(info, value);
        case ParamType::choice:
            return chooseValue(info, std::get<std::string>(value));
    }
    return false;
}

/// Only a vector has its label, and its unit, on a line of their own.
void drawLabel(const ParamInfo& info) {
    if (info.type == ParamType::vector) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted((std::string(info.label) + ", " + unitText(info)).c_str());
    } else {
        rowLabel(info.label);
    }
    itemTooltip(tooltipOf(info));
}

/// At the right end of the line, where the value is not what it was at the start.
void drawReset(const ParamInfo& info, const PanelModel& model, std::vector<Action>& actions) {
    const ParamValue start = getParam(model.startParams, info.name);
    if (getParam(model.params, info.name) == start) {
        return;
    }
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFrameHeight());
    if (resetButton("##reset")) {
        actions.emplace_back(SetParam{std::string(info.name), start});
    }
    noteItem("reset." + std::string(info.name));
    itemTooltip("Back to the value at the start");
}

void drawGravitySwitch(const PanelModel& model, std::vector<Action>& actions) {
    bool on = model.params.gravity.norm() > 0;
    if (ImGui::Checkbox("##switch", &on)) {
        actions.emplace_back(ActionId::toggleGravity);
    }
    itemTooltip(describeAction(ActionId::toggleGravity));
    ImGui::SameLine();
}

void drawRow(const ParamInfo& info, const PanelModel& model, std::vector<Action>& actions) {
    ImGui::PushID(info.name.data(), info.name.data() + info.name.size());
    if (info.name == "gravity") {
        drawGravitySwitch(model, actions);
    }
    drawLabel(info);
    const bool isVector = info.type == ParamType::vector;
    if (isVector) {
        drawReset(info, model, actions);
    }
    ParamValue value = getParam(model.params, info.name);
    ImGui::SetNextItemWidth(isVector ? -FLT_MIN : resetRoom());
    ImGui::BeginGroup();
    const bool changed = slideValue(info, value);
    ImGui::EndGroup();
    noteItem("param." + std::string(info.name));
    const bool continues = continuesGesture(changed);
    if (!ImGui::IsItemActive()) {
        itemTooltip(tooltipOf(info));
    }
    if (changed) {
        actions.emplace_back(SetParam{std::string(info.name), value, continues});
    }
    if (!isVector) {
        drawReset(info, model, actions);
    }
    if (const std::string remark = remarkOn(info, model); !remark.empty()) {
        ImGui::TextWrapped("%s", remark.c_str());
        noteItem("remark." + std::string(info.name));
    }
    ImGui::PopID();
}

}  // namespace

std::string remarkOn(const ParamInfo& info, const PanelModel& model) {
    if (info.name != "iterations" || !hasTooFewSweeps(model.params, model.edgeLength)) {
        return "";
    }
    const std::optional<int> enough = enoughIterations(model.params, model.edgeLength);
    const std::string advice = enough ? "From " + std::to_string(*enough) + " on it is not."
                                      : "A smaller time step helps.";
    return "Too few for this stiffness: the body is softer than its modulus. " + advice;
}

std::string sliderFormat(const ParamInfo& info) {
    const std::string tail = info.unit.empty() ? "" : " " + unitText(info);
    if (info.type == ParamType::integer) {
        return "%d" + tail;
    }
    return "%." + std::to_string(decimalsFor(info)) + "f" + tail;
}

void drawParameters(const PanelModel& model, std::vector<Action>& actions) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        {ImGui::GetStyle().ItemSpacing.x, 0.2F * ImGui::GetFontSize()});
    for (const std::string_view name : kProminent) {
        drawRow(*findParam(name), model, actions);
    }
    if (ImGui::CollapsingHeader("More")) {
        for (const ParamInfo& info : paramTable()) {
            if (!isProminent(info)) {
                drawRow(info, model, actions);
            }
        }
    }
    ImGui::PopStyleVar();
}

}  // namespace kerf::ui
