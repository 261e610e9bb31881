#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include "ui/base/theme.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

bool isChosen(const Settings& settings, const char* id) {
    return std::ranges::find(settings.plots, id) != settings.plots.end();
}

PlotReference paperValue(double value) {
    return {value, fmt::format("paper {:.1f}", value)};
}

std::optional<PlotReference> referenceOf(const PlotKind& kind, const PlotsState& plots) {
    if (kind.paper != nullptr && plots.paper) {
        return paperValue((*plots.paper).*kind.paper);
    }
    if (kind.atRest) {
        return PlotReference{*kind.atRest, "at rest " + std::to_string(std::lround(*kind.atRest))};
    }
    return std::nullopt;
}

std::vector<PlotCurve> curvesOfPieces(const std::vector<Series>& pieces) {
    static constexpr std::array kStyles{CurveStyle::solid, CurveStyle::dashed, CurveStyle::dotted};
    std::vector<PlotCurve> curves;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        curves.push_back({.label = std::to_string(i + 1),
                          .color = pieceColor(static_cast<int>(i)),
                          .style = kStyles[i % kStyles.size()],
                          .series = &pieces[i]});
    }
    return curves;
}

std::vector<PlotCurve> curvesOf(const PlotKind& kind, const History& history) {
    if (kind.curves[0].label == nullptr) {
        return curvesOfPieces(history.piecePercent);
    }
    std::vector<PlotCurve> curves;
    for (const CurveKind& curve : kind.curves) {
        if (curve.label != nullptr) {
            curves.push_back({.label = curve.label,
                              .hue = curve.hue,
                              .style = curve.style,
                              .series = &history[curve.reading]});
        }
    }
    return curves;
}

// --- The line of buttons -----------------------------------------------------------------------

/// The plots in the order of kPlots, with `id` on or off.
std::vector<std::string> withPlot(const Settings& settings, const char* id, bool on) {
    std::vector<std::string> plots;
    for (const PlotKind& kind : kPlots) {
        const bool isIt = std::string_view(kind.id) == id;
        if (isIt ? on : isChosen(settings, kind.id)) {
            plots.emplace_back(kind.id);
        }
    }
    return plots;
}

void drawChooser(const Settings& chosen, std::vector<Action>& actions) {
    if (button("Plots \u25be", "plots.choose", "Choose the plots to show")) {
        ImGui::OpenPopup("choose plots");
    }
    placePopupBelowItem();
    if (!ImGui::BeginPopup("choose plots")) {
        return;
    }
    for (const PlotKind& kind : kPlots) {
        bool on = isChosen(chosen, kind.id);
        if (checkbox(kind.title, on, std::string("plots.") + kind.id)) {
            Settings settings = chosen;
            settings.plots = withPlot(chosen, kind.id, on);
            actions.emplace_back(SetSettings{settings});
        }
    }
    ImGui::EndPopup();
}

bool barButton(const char* label, const char* name, const std::string& tooltip) {
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (ImGui::GetContentRegionAvail().x < buttonWidth(label)) {
        ImGui::NewLine();
    }
    return button(label, name, tooltip);
}

void drawHold(const PlotView& view, std::vector<Action>& actions) {
    const bool held = view.end.has_value();
    if (held) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab));
    }
    if (barButton("Hold", "plots.hold", describeAction(ActionId::holdPlots))) {
        actions.emplace_back(ActionId::holdPlots);
    }
    if (held) {
        ImGui::PopStyleColor();
    }
}

void drawButtons(const PlotView& view, const Settings& settings, std::vector<Action>& actions) {
    drawChooser(settings, actions);
    drawHold(view, actions);
    if (barButton("Fit", "plots.fit", describeAction(ActionId::fitPlots))) {
        actions.emplace_back(ActionId::fitPlots);
    }
    if (barButton("CSV", "plots.csv",
                  "Save the values of these plots as CSV in the current folder")) {
        actions.emplace_back(ExportPlots{false});
    }
    if (barButton("PNG", "plots.png", "Save a picture of these plots in the current folder")) {
        actions.emplace_back(ExportPlots{true});
    }
}

/// Height of each plot [px].
float plotHeight(float room, std::size_t count) {
    const float least = 7.2F * ImGui::GetTextLineHeightWithSpacing();
    const float gaps = ImGui::GetStyle().ItemSpacing.y * static_cast<float>(count - 1);
    return std::max(least, (room - gaps) / static_cast<float>(count));
}

}  // namespace

std::vector<PlotSpec> chosenPlots(const PlotsState& state, const Settings& settings) {
    std::vector<PlotSpec> plots;
    const auto add = [&](const PlotKind& kind) {
        plots.push_back({.id = kind.id,
                         .title = kind.title,
                         .curves = curvesOf(kind, *state.history),
                         .marks = state.history->marks,
                         .reference = referenceOf(kind, state),
                         .minSpan = kind.minSpan,
                         .readoutDecimals = kind.readoutDecimals});
    };
    if (!(*state.history)[Reading::pointStrain].empty()) {
        std::ranges::for_each(kPointPlots, add);
    }
    for (const PlotKind& kind : kPlots) {
        if (isChosen(settings, kind.id)) {
            add(kind);
        }
    }
    return plots;
}

void drawPlots(const PlotsState& state, const TransportState& transport, const Settings& settings,
               float height, std::vector<Action>& actions) {
    ImGui::BeginChild("plots", {0, height});
    drawButtons(state.view, settings, actions);
    ImGui::BeginChild("curves");
    const std::vector<PlotSpec> plots = chosenPlots(state, settings);
    PlotTimeline timeline{state.view, transport.time, transport.playing, ImGui::IsWindowHovered()};
    const float each = plotHeight(ImGui::GetContentRegionAvail().y, plots.size());
    for (const PlotSpec& plot : plots) {
        timeline.labels = std::max(timeline.labels, labelsWidth(plot, timeline, each));
    }
    for (const PlotSpec& plot : plots) {
        if (const auto view = drawPlot(plot, timeline, each)) {
            actions.emplace_back(SetPlotView{*view});
        }
    }
    if (plots.empty()) {
        ImGui::TextDisabled("No plots selected.");
    }
    ImGui::EndChild();
    ImGui::EndChild();
}

}  // namespace kerf::ui
