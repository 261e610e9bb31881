#include <imgui.h>

#include "ui/base/layout.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"

namespace kerf::ui {

namespace {

constexpr std::size_t kToolsInARow = 3;
constexpr double kLargestRadius = 0.2;  // of a hand or brush, of the longest blade
constexpr double kMetres = 1;           // longer ones are shown in metres [m]

/// A button with a name of its own, which asks for an action.
void drawButton(const char* label, const std::string& item, float width, ActionId id,
                std::vector<Action>& actions) {
    if (button(label, item, describeAction(id), width)) {
        actions.emplace_back(id);
    }
}

void drawToolButton(const ToolRow& tool, bool chosen, float width, std::vector<Action>& actions) {
    if (chosen) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab));
    }
    drawButton(tool.name, std::string("tool.") + tool.name, width, actionOf(tool.tool), actions);
    if (chosen) {
        ImGui::PopStyleColor();
    }
}

void drawToolButtons(const PanelModel& model, std::vector<Action>& actions) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width =
        (ImGui::GetContentRegionAvail().x - (kToolsInARow - 1) * gap) / kToolsInARow;
    for (std::size_t i = 0; i < kToolRows.size(); ++i) {
        if (i % kToolsInARow > 0) {
            ImGui::SameLine(0, gap);
        }
        drawToolButton(kToolRows[i], model.tools.tool == kToolRows[i].tool, width, actions);
    }
}

/// A length from a hundredth of the longest one up, in millimetres where that is short. `beside`:
/// width of what follows in its row.
bool slideLength(const char* label, double& value, double longest, const char* tooltip,
                 float beside = 0) {
    const bool small = longest < kMetres;
    const double scale = small ? 1e3 : 1;
    const double most = scale * longest;
    const double least = 0.01 * most;
    const float gap = beside > 0 ? ImGui::GetStyle().ItemInnerSpacing.x : 0;
    double shown = scale * value;
    const bool changed =
        slideRow({label, tooltip, std::string("blade.") + label},
                 {ImGuiDataType_Double, &shown, &least, &most,
                  small && most > 10 ? "%.1f mm"
                                     : std::string(lengthFormat(most)) + (small ? " mm" : " m")},
                 ImGui::GetContentRegionAvail().x - beside - gap)
            .changed;
    value = changed ? shown / scale : value;
    return changed;
}

/// What the rows of a tool go by, change and answer.
struct Rows {
    const PanelModel& model;
    ToolSettings& tools;
    std::vector<Action>& actions;
};

bool drawStrokeRows(const Rows& rows) {
    bool changed = checkbox("Full depth", rows.tools.stroke.throughAll, "blade.through",
                            "Cut through the whole body along the line of sight");
    if (!rows.tools.stroke.throughAll) {
        changed |= slideLength("Depth", rows.tools.stroke.depth, rows.tools.longest,
                               "Depth of the cut behind the nearest point of the body");
    }
    return changed;
}

bool drawScalpelRow(const Rows& rows) {
    return slideLength("Depth", rows.tools.scalpel.depth, rows.tools.longest,
                       "Depth of the cut below the surface");
}

bool drawGuillotineRows(const Rows& rows) {
    GuillotineSettings& tool = rows.tools.guillotine;
    bool changed = slideLength("Length", tool.length, rows.tools.longest, "Length of the blade");
    changed |= slideLength("Drop", tool.drop, rows.tools.longest, "How far the blade drops");
    const double up = 0;
    const double down = 1;
    const float button = 4.6F * ImGui::GetFontSize();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    changed |= slideRow({"Lowered", "Lower the blade by hand; it cuts", "blade.lowered"},
                        {ImGuiDataType_Double, &tool.lowered, &up, &down, "%.2f"},
                        ImGui::GetContentRegionAvail().x - button - gap)
                   .changed;
    ImGui::SameLine(0, gap);
    drawButton("Down", "blade.down", button, ActionId::bringDown, rows.actions);
    return changed;
}

/// Of what pulls.
void drawTearing(const Rows& rows) {
    bool tears = rows.model.parameters.now.tearing != 0;
    if (checkbox("What is pulled tears", tears, "pull.tears",
                 "On: the body tears where pulling opens the end of a slit far enough, or where it "
                 "stresses the skin beyond its strength. Off: only a blade cuts.\n"
                 "Toughness and strengths of the material are among the parameters.")) {
        rows.actions.emplace_back(SetParam{"tearing", tears ? 1.0 : 0.0});
    }
}

bool drawGrabRow(const Rows& rows) {
    drawTearing(rows);
    return slideLength("Hand", rows.tools.grab.radius, kLargestRadius * rows.tools.longest,
                       "Radius of the area that is pulled");
}

/// Three numbers below their label.
bool dragVector(const std::string& name, const std::string& unit, Vec3& value, double most) {
    constexpr float kSpeed = 0.01F;
    const double least = -most;
    const std::string label = name + ", " + unit;
    ImGui::TextUnformatted(label.c_str());
    ImGui::SetNextItemWidth(-1);
    const bool changed =
        dragNumbers({value.data(), 3},
                    {ImGuiDataType_Double, nullptr, &least, &most, "%.4g", false, unit}, kSpeed);
    noteItem("pin." + label);
    return changed;
}

bool drawMotionRows(PinSettings& pin) {
    const double forGood = 0;
    const double longest = 100;
    bool changed = dragVector("Velocity", "m/s", pin.velocity, 1000);
    changed |=
        slideRow({"Duration", "How long it moves; then it stays. 0: until unpinned", "pin.seconds"},
                 {ImGuiDataType_Double, &pin.seconds, &forGood, &longest, "%.3g s"},
                 ImGui::GetContentRegionAvail().x)
            .changed;
    return changed;
}

bool choosePinKind(PinSettings& pin) {
    bool changed = false;
    ImGui::PushID("pin");  // There is a tool Move, too.
    for (std::size_t i = 0; i < kPinKinds.size(); ++i) {
        const auto kind = static_cast<PinKind>(i);
        const std::string name(kPinKinds[i]);
        if (ImGui::RadioButton(name.c_str(), pin.kind == kind)) {
            pin.kind = kind;
            changed = true;
        }
        noteItem("pin." + name);
        if (i + 1 < kPinKinds.size()) {
            ImGui::SameLine();
        }
    }
    ImGui::PopID();
    if (pin.kind == PinKind::move) {
        changed |= drawMotionRows(pin);
    } else if (pin.kind == PinKind::push) {
        changed |= dragVector("Force", "N", pin.newtons, 1e6);
        itemTooltip("The force on all that a brush stroke covers, shared by mass");
    }
    return changed;
}

bool drawPinRows(const Rows& rows) {
    const float button = 5.4F * ImGui::GetFontSize();
    bool changed = choosePinKind(rows.tools.pin);
    changed |= slideLength("Brush", rows.tools.pin.radius, kLargestRadius * rows.tools.longest,
                           "Radius of the brush", button);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    drawButton("Unpin all", "pin.free", button, ActionId::freePins, rows.actions);
    return changed;
}

bool drawRetractRow(const Rows& rows) {
    drawTearing(rows);
    if (rows.model.body.hooks > 0) {
        drawButton("Remove last", "retract.remove", -1, ActionId::deleteSelected, rows.actions);
        return false;
    }
    ImGui::TextDisabled("No retractors in use");
    describeItem("retract.remove", describeAction(ActionId::deleteSelected));
    return false;
}

/// A tool with rows of its own: draws them, and answers whether its settings were changed.
struct SettingRows {
    ToolKind tool;
    bool (*draw)(const Rows& rows);
};
constexpr std::array kSettingRows{
    SettingRows{ToolKind::stroke, drawStrokeRows},
    SettingRows{ToolKind::scalpel, drawScalpelRow},
    SettingRows{ToolKind::guillotine, drawGuillotineRows},
    SettingRows{ToolKind::grab, drawGrabRow},
    SettingRows{ToolKind::pin, drawPinRows},
    SettingRows{ToolKind::retract, drawRetractRow},
    SettingRows{
        ToolKind::measure,
        [](const Rows& r) { return drawMeasureRows(r.model.view.measures, r.tools, r.actions); }},
};

void drawTimeWhileCutting(const PanelModel& model, std::vector<Action>& actions) {
    bool runs = model.settings.timeRunsWhileCutting;
    if (checkbox("Time runs while cutting", runs, "blade.time",
                 "On: the body moves while you cut, even when paused. Off: it stays still")) {
        actions.emplace_back(ActionId::timeWhileCutting);
    }
}

struct KindButton {
    MeasureKind kind;
    const char* label;
    const char* tooltip;
};
constexpr std::array kKinds{
    KindButton{MeasureKind::distance, "Distance", "Click two points: straight-line distance"},
    KindButton{MeasureKind::angle, "Angle", "Click three points: angle at the second"},
    KindButton{MeasureKind::piece, "Piece", "Click a piece: areas and volume"},
    KindButton{MeasureKind::point, "Plot",
               "Click a point: plots its strain, displacement and speed over time"},
};

bool chooseKind(ToolSettings& tools) {
    bool changed = false;
    for (const KindButton& button : kKinds) {
        if (button.kind != kKinds.front().kind) {
            ImGui::SameLine();
        }
        const float width = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x +
                            ImGui::CalcTextSize(button.label).x;
        if (ImGui::GetContentRegionAvail().x < width) {
            ImGui::NewLine();
        }
        if (ImGui::RadioButton(button.label, tools.measure == button.kind)) {
            tools.measure = button.kind;
            changed = true;
        }
        describeItem(std::string("measure.") + button.label, button.tooltip);
    }
    return changed;
}

void drawRow(const MeasureRow& row, std::vector<Action>& actions) {
    ImGui::PushID(row.id);
    if (smallButton("\u00d7", "measure.remove." + std::to_string(row.id),
                    "Remove this measurement")) {
        actions.emplace_back(RemoveMeasure{row.id});
    }
    ImGui::SameLine();
    ImGui::BeginGroup();
    for (const MeasureFigure& figure : row.figures) {
        ImGui::TextDisabled("%s%s", figure.quantity.c_str(), row.isOld ? " (outdated)" : "");
        ImGui::SameLine();
        ImGui::TextUnformatted(figure.text.c_str());
    }
    ImGui::EndGroup();
    ImGui::PopID();
}

void drawList(const std::vector<MeasureRow>& measures, std::vector<Action>& actions) {
    for (const MeasureRow& row : measures) {
        drawRow(row, actions);
    }
    if (smallButton("CSV", "measure.csv", "Save the list as CSV in the current folder")) {
        actions.emplace_back(ExportMeasures{});
    }
    ImGui::SameLine();
    if (smallButton("Remove all", "measure.clear")) {
        actions.emplace_back(RemoveMeasure{});
    }
}

}  // namespace

void drawTools(const PanelModel& model, std::vector<Action>& actions) {
    drawToolButtons(model, actions);
    ToolSettings tools = model.tools;
    const auto* rows = std::ranges::find(kSettingRows, tools.tool, &SettingRows::tool);
    if (rows != kSettingRows.end() && rows->draw({model, tools, actions})) {
        actions.emplace_back(SetTools{tools});
    }
    if (rowOf(model.tools.tool).leadsBlade) {
        drawTimeWhileCutting(model, actions);
    }
}

bool drawMeasureRows(const std::vector<MeasureRow>& measures, ToolSettings& tools,
                     std::vector<Action>& actions) {
    const bool changed = chooseKind(tools);
    if (measures.empty()) {
        ImGui::TextDisabled("Click on the body.");
    } else {
        drawList(measures, actions);
    }
    return changed;
}

}  // namespace kerf::ui
