#include <imgui.h>

#include "ui/base/layout.h"
#include "ui/base/theme.h"
#include "ui/over_view.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

constexpr double kPutAway = 0.6;  // of the least width: a panel that is dragged below this goes

/// One side panel as its edge sees it.
struct PanelSide {
    const char* name;  ///< in ItemRects
    const char* arrow;
    bool Settings::*shown;
    double Settings::*width;
    bool isLeft;
};
constexpr PanelSide kLeft{"edge.controls", "\u25b8", &Settings::showControls,
                          &Settings::controlsWidth, true};
constexpr PanelSide kRight{"edge.readings", "\u25c2", &Settings::showReadings,
                           &Settings::readingsWidth, false};

void beginBare(const char* name, const Rect& rect) {
    ImGui::SetNextWindowPos({rect.x, rect.y});
    ImGui::SetNextWindowSize({rect.width, rect.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoFocusOnAppearing);  // A press would be taken from its item.
    ImGui::PopStyleVar(2);
}

/// The line in the middle of the last item, while the pointer is there.
void lightUp(bool upright) {
    if (!ImGui::IsItemHovered() && !ImGui::IsItemActive()) {
        return;
    }
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    const float half = ImGui::GetFontSize() / 15;
    const ImVec2 middle{std::round((low.x + high.x) / 2), std::round((low.y + high.y) / 2)};
    const ImVec2 from = upright ? ImVec2{middle.x - half, low.y} : ImVec2{low.x, middle.y - half};
    const ImVec2 to = upright ? ImVec2{middle.x + half, high.y} : ImVec2{high.x, middle.y + half};
    ImGui::GetWindowDrawList()->AddRectFilled(from, to, palette().splitter, half);
}

/// Sets the width to which the edge is dragged.
void dragEdge(const Settings& chosen, const PanelSide& side, const Rect& edge, float scale,
              std::vector<Action>& actions) {
    const float x = ImGui::GetIO().MousePos.x;
    const float reach =
        side.isLeft ? x - 1.5F * edge.width : ImGui::GetIO().DisplaySize.x - x - 1.5F * edge.width;
    const double wanted = reach / scale;
    Settings settings = chosen;
    settings.*side.shown = wanted > kPutAway * Settings::kLeastWidth;
    if (settings.*side.shown) {
        settings.*side.width = std::clamp(wanted, Settings::kLeastWidth, Settings::kMostWidth);
    }
    if (!(settings == chosen)) {
        actions.emplace_back(SetSettings{settings});
    }
}

void drawEdge(const Settings& chosen, const PanelSide& side, const Rect& edge, float scale,
              std::vector<Action>& actions) {
    beginBare(side.name, edge);
    ImGui::InvisibleButton("edge", {edge.width, edge.height});
    noteItem(side.name);
    lightUp(true);
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
        dragEdge(chosen, side, edge, scale, actions);
    }
    ImGui::End();
}

/// A button at the border of the picture.
void drawOpener(const Settings& chosen, const PanelSide& side, float scale,
                std::vector<Action>& actions) {
    const ImVec2 picture = ImGui::GetIO().DisplaySize;
    const float width = 18 * scale;
    const float height = 56 * scale;
    const float x = side.isLeft ? 0 : picture.x - width;
    const std::string name = std::string(side.name) + ".open";
    beginBare(name.c_str(), {x, (picture.y - height) / 2, width, height});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
    if (ImGui::Button(side.arrow, {width, height})) {
        Settings settings = chosen;
        settings.*side.shown = true;
        actions.emplace_back(SetSettings{settings});
    }
    ImGui::PopStyleVar();
    describeItem(name, "Show the panel (Tab shows and hides both)");
    ImGui::End();
}

void drawSide(const Settings& chosen, const PanelSide& side, const Rect& edge, float scale,
              std::vector<Action>& actions) {
    // The edge stays where it is held, so that one drag can put the panel away and bring it back.
    if (chosen.*side.shown || ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        drawEdge(chosen, side, edge, scale, actions);
    }
    if (!(chosen.*side.shown)) {
        drawOpener(chosen, side, scale, actions);
    }
}

}  // namespace

void drawEdges(const Settings& chosen, const Layout& layout, float scale,
               std::vector<Action>& actions) {
    drawSide(chosen, kLeft, layout.controlsEdge, scale, actions);
    drawSide(chosen, kRight, layout.plotsEdge, scale, actions);
}

std::optional<double> horizontalSplitter(const char* id, float top, float height) {
    const float thickness = splitterHeight() - ImGui::GetStyle().ItemSpacing.y;
    ImGui::InvisibleButton(id, {ImGui::GetContentRegionAvail().x, thickness});
    noteItem(std::string("splitter.") + id);
    lightUp(false);
    if (!ImGui::IsItemActive() || !ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
        return std::nullopt;
    }
    const float share = (ImGui::GetIO().MousePos.y - thickness / 2 - top) / height;
    return std::clamp(static_cast<double>(share), 0.0, 1.0);
}

float splitterHeight() {
    return 0.4F * ImGui::GetFontSize() + ImGui::GetStyle().ItemSpacing.y;
}

}  // namespace kerf::ui
