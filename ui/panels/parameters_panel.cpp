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

/// Wide signed ranges get the logarithmic scale too: fine near zero, and zero easy to hit.
bool isLogarithmic(const ParamInfo& info) {
    return info.logarithmic || info.type == ParamType::vector ||
           info.type == ParamType::optionalReal;
}

std::string unitText(const ParamInfo& info) {
    return withRaisedDigits(info.unit);
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

std::string rangeText(const ParamInfo& info) {
    std::string text = fmt::format("Range: {:g} to {:g}", info.low, info.high);
    if (!info.unit.empty()) {
        text += " " + unitText(info);
    }
    return text + (info.type == ParamType::vector ? ", each of x, y and z" : "");
}

std::string tooltipOf(const ParamInfo& info) {
    std::string text(info.meaning);
    if (isSwitch(info)) {
        for (const auto& [number, word] : {std::pair("1: ", "On: "), std::pair("0: ", "off: ")}) {
            if (const std::size_t at = text.find(number); at != std::string::npos) {
                text.replace(at, 3, word);
            }
        }
    } else if (info.type != ParamType::choice) {
        text += "\n" + rangeText(info) + ". Click the number to type a value.";
    }
    if (const std::string_view paper = paperValue(info.name); !paper.empty()) {
        text += "\nPaper: " + std::string(paper) + ".";
    }
    return text + "\nName in sessions: " + std::string(info.name);
}

/// Room for the reset mark [px].
float resetRoom() {
    return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
}

SlideText textOf(const ParamInfo& info) {
    return {std::string(info.label), tooltipOf(info), "param." + std::string(info.name)};
}

/// A floor is slid about the origin; sessions may have it farther away.
constexpr double kHighestSlide = 1000;
constexpr double kLowestSlide = -1000;

Slide slideOf(const ParamInfo& info, double& value) {
    const bool far = info.high > kHighestSlide && info.type == ParamType::optionalReal;
    return {ImGuiDataType_Double,
            &value,
            far ? &kLowestSlide : &info.low,
            far ? &kHighestSlide : &info.high,
            sliderFormat(info),
            isLogarithmic(info),
            std::string(info.unit)};
}

SlideEdit slideInteger(const ParamInfo& info, double& value, const std::string& format) {
    int whole = static_cast<int>(std::lround(value));
    const int low = static_cast<int>(info.low);
    const int high = static_cast<int>(info.high);
    const SlideEdit edit = slideRow(
        textOf(info), {ImGuiDataType_S32, &whole, &low, &high, format, isLogarithmic(info)},
        ImGui::GetContentRegionAvail().x, resetRoom());
    value = whole;
    return edit;
}

/// With a switch behind the label that leaves the number to the program: the slider then shows the
/// one that it has chosen, and whoever moves it takes over.
SlideEdit slideOrAuto(const ParamInfo& info, ParamValue& value, int chosen) {
    bool isAuto = std::holds_alternative<std::string>(value);
    double number = isAuto ? chosen : std::get<double>(value);
    ImVec2 behind = ImGui::GetCursorPos();
    behind.x += ImGui::CalcTextSize(info.label.data()).x + ImGui::GetStyle().ItemSpacing.x;
    SlideEdit edit = slideInteger(info, number, sliderFormat(info));
    const ImVec2 below = ImGui::GetCursorPos();
    ImGui::SetCursorPos(behind);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, 0});
    if (ImGui::Checkbox("Auto", &isAuto)) {
        edit = {true, false};
        value = isAuto ? ParamValue(std::string(info.choices.front())) : ParamValue(number);
    } else if (edit.changed) {
        value = number;
    }
    ImGui::PopStyleVar();
    describeItem("auto." + std::string(info.name), tooltipOf(info));
    ImGui::SetCursorPos(below);
    return edit;
}

SlideEdit slideReal(const ParamInfo& info, double& value) {
    return slideRow(textOf(info), slideOf(info, value), ImGui::GetContentRegionAvail().x,
                    resetRoom());
}

/// Side by side.
SlideEdit slideVector(const ParamInfo& info, Vec3& value) {
    static constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    const std::string item = textOf(info).item;
    SlideEdit all;
    ImGui::BeginGroup();
    for (int axis = 0; axis < 3; ++axis) {
        Slide slide = slideOf(info, value[axis]);
        slide.format = "%.2f";
        const std::string name = axis == 0 ? item : item + "." + kAxes[axis];
        const SlideEdit edit = slideRow({kAxes[axis], tooltipOf(info), name}, slide, width);
        all = {all.changed || edit.changed, all.continues || edit.continues};
        if (axis < 2) {
            ImGui::SameLine(0, gap);
        }
    }
    ImGui::EndGroup();
    return all;
}

bool chooseValue(const ParamInfo& info, std::string& value) {
    if (!ImGui::BeginCombo("##value", asLabel(value).c_str())) {
        return false;
    }
    bool changed = false;
    for (const std::string_view choice : info.choices) {
        if (ImGui::Selectable(asLabel(choice).c_str(), value == choice)) {
            value = choice;
            changed = true;
        }
    }
    ImGui::EndCombo();
    return changed;
}

bool flipSwitch(double& value) {
    bool on = value != 0;
    const bool changed = ImGui::Checkbox("##value", &on);
    value = on ? 1 : 0;
    return changed;
}

/// A row whose label is followed by something else than a number.
template <class Draw>
SlideEdit labelledRow(const ParamInfo& info, Draw draw) {
    rowLabel(info.label);
    itemTooltip(tooltipOf(info));
    ImGui::SetNextItemWidth(-resetRoom());
    const bool changed = draw();
    describeItem(textOf(info).item, tooltipOf(info));
    return {changed, false};
}

/// With a switch in front that takes the value away.
SlideEdit slideOptional(const ParamInfo& info, ParamValue& value) {
    bool present = !std::holds_alternative<std::monostate>(value);
    bool changed = ImGui::Checkbox("##present", &present);
    itemTooltip(tooltipOf(info));
    ImGui::SameLine();
    if (changed) {
        value = present ? ParamValue{std::clamp(0.0, info.low, info.high)} : std::monostate{};
    }
    if (double* number = std::get_if<double>(&value)) {
        const SlideEdit edit = slideReal(info, *number);
        return {changed || edit.changed, edit.continues};
    }
    ImGui::TextUnformatted(std::string(info.label).c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("none");
    noteItem(textOf(info).item);
    return {changed, false};
}

SlideEdit slideValue(const ParamInfo& info, ParamValue& value, const ParametersState& parameters) {
    if (info.type == ParamType::integer && !info.choices.empty()) {
        return slideOrAuto(info, value, parameters.iterations);
    }
    switch (info.type) {
        case ParamType::real:
            return slideReal(info, std::get<double>(value));
        case ParamType::integer:
            return isSwitch(info)
                       ? labelledRow(info, [&] { return flipSwitch(std::get<double>(value)); })
                       : slideInteger(info, std::get<double>(value), sliderFormat(info));
        case ParamType::vector:
            return slideVector(info, std::get<Vec3>(value));
        case ParamType::optionalReal:
            return slideOptional(info, value);
        case ParamType::choice:
            return labelledRow(info,
                               [&] { return chooseValue(info, std::get<std::string>(value)); });
    }
    return {};
}

/// Only a vector has its label, and its unit, on a line of their own.
void drawVectorLabel(const ParamInfo& info) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted((std::string(info.label) + ", " + unitText(info)).c_str());
    itemTooltip(tooltipOf(info));
}

/// A mark at the right end of the line that begins at `top`, which sets a parameter to a value.
void drawMark(const std::string& param, const ParamValue& value, const char* tooltip, float top,
              std::vector<Action>& actions) {
    const ImVec2 below = ImGui::GetCursorPos();
    ImGui::SetCursorPos({ImGui::GetContentRegionMax().x - ImGui::GetFrameHeight(),
                         top - ImGui::GetStyle().FramePadding.y});
    if (resetButton("##reset")) {
        actions.emplace_back(SetParam{param, value});
    }
    describeItem("reset." + param, tooltip);
    ImGui::SetCursorPos(below);
}

/// Where the value is not what it was at the start.
void drawReset(const ParamInfo& info, const ParametersState& parameters, float top,
               std::vector<Action>& actions) {
    const ParamValue start = getParam(parameters.start, info.name);
    if (getParam(parameters.now, info.name) != start) {
        drawMark(std::string(info.name), start, "Reset to the initial value", top, actions);
    }
}

void drawOwnRow(const ParamInfo& info, int model, const ParametersState& parameters,
                std::vector<Action>& actions) {
    const std::string name = ownName(info.name, model);
    ImGui::PushID(name.c_str());
    const float top = ImGui::GetCursorPosY();
    const ParamValue own = getParam(parameters.now, name);
    const bool has = !std::holds_alternative<std::monostate>(own);
    double value = std::get<double>(has ? own : getParam(parameters.now, info.name));
    SlideText text = textOf(info);
    text.item = "param." + name;
    text.label.append(has ? "" : " (shared)");
    const SlideEdit edit =
        slideRow(text, slideOf(info, value), ImGui::GetContentRegionAvail().x, resetRoom());
    if (edit.changed) {
        actions.emplace_back(SetParam{name, value, edit.continues});
    }
    if (has) {
        drawMark(name, std::monostate{}, "Use the shared value again", top, actions);
    }
    ImGui::PopID();
}

void drawGravitySwitch(const ParametersState& parameters, std::vector<Action>& actions) {
    bool on = parameters.now.gravity.norm() > 0;
    if (ImGui::Checkbox("##switch", &on)) {
        actions.emplace_back(ActionId::toggleGravity);
    }
    itemTooltip(describeAction(ActionId::toggleGravity));
    ImGui::SameLine();
}

void drawRow(const ParamInfo& info, const ParametersState& parameters,
             std::vector<Action>& actions) {
    ImGui::PushID(info.name.data(), info.name.data() + info.name.size());
    const float top = ImGui::GetCursorPosY();
    if (info.name == "gravity") {
        drawGravitySwitch(parameters, actions);
    }
    if (info.type == ParamType::vector) {
        drawVectorLabel(info);
    }
    ParamValue value = getParam(parameters.now, info.name);
    const SlideEdit edit = slideValue(info, value, parameters);
    if (edit.changed) {
        actions.emplace_back(SetParam{std::string(info.name), value, edit.continues});
    }
    drawReset(info, parameters, top, actions);
    if (const std::string remark = remarkOn(info, parameters); !remark.empty()) {
        textWrapped(remark);
        noteItem("remark." + std::string(info.name));
    }
    ImGui::PopID();
}

}  // namespace

void drawOwnParameters(int model, const ParametersState& parameters, std::vector<Action>& actions) {
    for (const ParamInfo& info : paramTable()) {
        if (info.perModel) {
            drawOwnRow(info, model, parameters, actions);
        }
    }
}

bool isShown(const ParamInfo& info, const Params& now) {
    const bool ofSkin = info.name == "skin_toughness" || info.name == "skin_tensile_strength";
    const bool ofTearing = ofSkin || info.name == "tensile_strength";
    return (!ofTearing || now.tearing != 0) && (!ofSkin || now.skinThickness > 0);
}

std::string remarkOn(const ParamInfo& info, const ParametersState& parameters) {
    const bool isShown = info.name == "iterations" && parameters.implicitSteps > 0 &&
                         parameters.now.solver == SolverMode::implicit;
    return isShown ? partsOfStep(parameters) : "";
}

std::string partsOfStep(const ParametersState& parameters) {
    const int steps = parameters.implicitSteps;
    const std::string left =
        parameters.residual ? fmt::format(" (left: {:.1g} %)", 100 * *parameters.residual) : "";
    const std::string iterations = counted(parameters.iterations, "iteration", "iterations") + left;
    return parameters.now.solver == SolverMode::implicit
               ? fmt::format("{} of {:.3g} ms, {}",
                             counted(steps, "implicit step", "implicit steps"),
                             1000 * parameters.now.timeStep / steps, iterations)
               : iterations;
}

std::string sliderFormat(const ParamInfo& info) {
    const std::string tail = info.unit.empty() ? "" : " " + unitText(info);
    if (info.type == ParamType::integer) {
        return "%d" + tail;
    }
    return "%." + std::to_string(decimalsFor(info)) + "f" + tail;
}

void drawParameters(const ParametersState& parameters, std::vector<Action>& actions) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        {ImGui::GetStyle().ItemSpacing.x, 0.2F * ImGui::GetFontSize()});
    for (const std::string_view name : kProminent) {
        drawRow(*findParam(name), parameters, actions);
    }
    if (std::ranges::any_of(paramTable(), [](const ParamInfo& info) {
            return !isProminent(info) && isSought("param." + std::string(info.name));
        })) {
        ImGui::SetNextItemOpen(true);
    }
    const bool more = ImGui::CollapsingHeader("More");
    noteItem("parameters.more");
    if (more) {
        for (const ParamInfo& info : paramTable()) {
            if (!isProminent(info) && isShown(info, parameters.now)) {
                drawRow(info, parameters, actions);
            }
        }
    }
    ImGui::PopStyleVar();
}

}  // namespace kerf::ui
