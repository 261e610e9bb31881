#include "ui/plots_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "ui/item_places.h"
#include "ui/shortcuts.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

constexpr std::array kKinds{
    PlotKind{"frames", "Frames per second"}, PlotKind{"times", "Times, ms"},
    PlotKind{"volume", "Volume, % of rest"}, PlotKind{"pieces", "Volume by piece, % of rest"},
    PlotKind{"energy", "Energy, J"},         PlotKind{"touched", "Triangles that a cut divides"},
};

bool isChosen(const Settings& settings, const char* id) {
    return std::ranges::find(settings.plots, id) != settings.plots.end();
}

PlotReference paperValue(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "paper %.1f", value);
    return {value, text};
}

void fillFrames(PlotSpec& spec, const PanelModel& model) {
    spec.curves = {{.label = "frames/s", .series = &model.history->framesPerSecond}};
    spec.minSpan = 10;
    if (model.paper) {
        spec.reference = paperValue(model.paper->fps);
    }
}

void fillTimes(PlotSpec& spec, const PanelModel& model) {
    const auto curve = [&](const char* label, Stage stage, Hue hue, CurveStyle style) {
        return PlotCurve{.label = label,
                         .hue = hue,
                         .style = style,
                         .series = &model.history->stages[static_cast<std::size_t>(stage)]};
    };
    spec.curves = {curve("frame", Stage::frame, Hue::gray, CurveStyle::dotted),
                   curve("render", Stage::render, Hue::purple, CurveStyle::dashed),
                   curve("deform", Stage::deform, Hue::blue, CurveStyle::solid),
                   curve("cut", Stage::cut, Hue::vermillion, CurveStyle::solid),
                   curve("collide", Stage::collide, Hue::green, CurveStyle::dashed)};
    spec.readoutDecimals = 2;
}

void fillVolume(PlotSpec& spec, const PanelModel& model) {
    spec.curves = {{.label = "volume", .hue = Hue::green, .series = &model.history->volumePercent}};
    spec.readoutDecimals = 2;
    spec.reference =
        model.paper ? paperValue(model.paper->volume) : PlotReference{100, "at rest 100"};
}

void fillPieces(PlotSpec& spec, const PanelModel& model) {
    static constexpr std::array kStyles{CurveStyle::solid, CurveStyle::dashed, CurveStyle::dotted};
    const std::vector<Series>& pieces = model.history->piecePercent;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        spec.curves.push_back({.label = std::to_string(i + 1),
                               .color = pieceColor(static_cast<int>(i)),
                               .style = kStyles[i % kStyles.size()],
                               .series = &pieces[i]});
    }
    spec.readoutDecimals = 2;
}

void fillEnergy(PlotSpec& spec, const PanelModel& model) {
    const History& history = *model.history;
    spec.curves = {{.label = "sum",
                    .hue = Hue::gray,
                    .style = CurveStyle::dotted,
                    .series = &history.totalEnergy},
                   {.label = "potential",
                    .hue = Hue::blue,
                    .style = CurveStyle::dashed,
                    .series = &history.potentialEnergy},
                   {.label = "strain", .hue = Hue::green, .series = &history.strainEnergy},
                   {.label = "kinetic", .hue = Hue::orange, .series = &history.kineticEnergy}};
}

void fillTouched(PlotSpec& spec, const PanelModel& model) {
    spec.curves = {
        {.label = "triangles", .hue = Hue::vermillion, .series = &model.history->touchedTriangles}};
    spec.minSpan = 10;
    spec.readoutDecimals = 0;
}

void fill(PlotSpec& spec, const PanelModel& model) {
    using Filler = void (*)(PlotSpec&, const PanelModel&);
    static constexpr std::array<Filler, kKinds.size()> kFillers{
        fillFrames, fillTimes, fillVolume, fillPieces, fillEnergy, fillTouched};
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        if (std::string_view(kKinds[i].id) == spec.id) {
            kFillers[i](spec, model);
        }
    }
}

// --- The line of buttons -----------------------------------------------------------------------

/// The plots in the order of plotKinds(), with `id` on or off.
std::vector<std::string> withPlot(const Settings& settings, const char* id, bool on) {
    std::vector<std::string> plots;
    for (const PlotKind& kind : kKinds) {
        const bool isIt = std::string_view(kind.id) == id;
        if (isIt ? on : isChosen(settings, kind.id)) {
            plots.emplace_back(kind.id);
        }
    }
    return plots;
}

void drawChooser(const PanelModel& model, std::vector<Action>& actions) {
    if (ImGui::Button("Plots \u25be")) {
        ImGui::OpenPopup("choose plots");
    }
    noteItem("plots.choose");
    itemTooltip("Which plots are shown");
    if (!ImGui::BeginPopup("choose plots")) {
        return;
    }
    for (const PlotKind& kind : kKinds) {
        bool on = isChosen(model.settings, kind.id);
        if (ImGui::Checkbox(kind.title, &on)) {
            Settings settings = model.settings;
            settings.plots = withPlot(model.settings, kind.id, on);
            actions.emplace_back(SetSettings{settings});
        }
        noteItem(std::string("plots.") + kind.id);
    }
    ImGui::EndPopup();
}

bool barButton(const char* label, const char* name, const std::string& tooltip) {
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    const bool pressed = ImGui::Button(label);
    noteItem(name);
    itemTooltip(tooltip);
    return pressed;
}

void drawHold(const PanelModel& model, std::vector<Action>& actions) {
    const bool held = model.plotView.end.has_value();
    if (held) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab));
    }
    if (barButton("Hold", "plots.hold", describeShortcut(ActionId::holdPlots))) {
        actions.emplace_back(ActionId::holdPlots);
    }
    if (held) {
        ImGui::PopStyleColor();
    }
}

void drawButtons(const PanelModel& model, std::vector<Action>& actions) {
    drawChooser(model, actions);
    drawHold(model, actions);
    if (barButton("Fit", "plots.fit", describeShortcut(ActionId::fitPlots))) {
        actions.emplace_back(ActionId::fitPlots);
    }
    if (barButton("CSV", "plots.csv", "Save the values of these plots as CSV")) {
        actions.emplace_back(ExportPlots{false});
    }
    if (barButton("PNG", "plots.png", "Save a picture of these plots")) {
        actions.emplace_back(ExportPlots{true});
    }
}

/// Of each plot [px].
float plotHeight(float room, std::size_t count) {
    const float least = 7.2F * ImGui::GetTextLineHeightWithSpacing();
    const float gaps = ImGui::GetStyle().ItemSpacing.y * static_cast<float>(count - 1);
    return std::max(least, (room - gaps) / static_cast<float>(count));
}

}  // namespace

std::span<const PlotKind> plotKinds() {
    return kKinds;
}

std::vector<PlotSpec> chosenPlots(const PanelModel& model) {
    std::vector<PlotSpec> plots;
    for (const PlotKind& kind : kKinds) {
        if (isChosen(model.settings, kind.id)) {
            PlotSpec& spec = plots.emplace_back();
            spec.id = kind.id;
            spec.title = kind.title;
            spec.marks = model.history->marks;
            fill(spec, model);
        }
    }
    return plots;
}

void drawPlots(const PanelModel& model, float height, std::vector<Action>& actions) {
    ImGui::BeginChild("plots", {0, height});
    drawButtons(model, actions);
    ImGui::BeginChild("curves");
    const std::vector<PlotSpec> plots = chosenPlots(model);
    const PlotTimeline timeline{model.plotView, model.time, model.playing};
    const float room = ImGui::GetContentRegionAvail().y;
    for (const PlotSpec& plot : plots) {
        if (const auto view = drawPlot(plot, timeline, plotHeight(room, plots.size()))) {
            actions.emplace_back(SetPlotView{*view});
        }
    }
    if (plots.empty()) {
        ImGui::TextDisabled("No plot is chosen.");
    }
    ImGui::EndChild();
    ImGui::EndChild();
}

}  // namespace kerf::ui
