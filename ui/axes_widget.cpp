#include <imgui.h>

#include "ui/over_view.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

// In pixels of a display at scale 1.
constexpr float kArm = 34;
constexpr float kBall = 9;
constexpr float kMargin = 12;
constexpr float kLine = 2.2F;

constexpr std::array<std::array<int, 3>, 3> kColors{
    {{214, 92, 84}, {110, 176, 78}, {88, 134, 222}}};
constexpr std::array<const char*, 3> kNames{"X", "Y", "Z"};
constexpr std::array<std::array<ActionId, 2>, 3> kViewActions{
    {{ActionId::viewRight, ActionId::viewLeft},
     {ActionId::viewTop, ActionId::viewBottom},
     {ActionId::viewFront, ActionId::viewBack}}};

/// One end of one axis.
struct AxisEnd {
    int axis = 0;
    bool positive = true;
    Vec3 at = Vec3::Zero();  ///< as in ViewAxes

    ActionId action() const { return kViewActions[axis][positive ? 0 : 1]; }
    /// Fainter behind.
    ImU32 color(bool hot) const {
        const auto& c = kColors[axis];
        const float depth = 0.72F + 0.28F * static_cast<float>(at.z());
        const auto part = [&](int i) {
            return std::min(255,
                            static_cast<int>(static_cast<float>(c[i]) * depth) + (hot ? 50 : 0));
        };
        return IM_COL32(part(0), part(1), part(2), 255);
    }
};

/// The farthest first.
std::array<AxisEnd, 6> endsOf(const ViewAxes& axes) {
    std::array<AxisEnd, 6> ends;
    for (int axis = 0; axis < 3; ++axis) {
        ends[2 * axis] = {axis, true, axes.axes[axis]};
        ends[2 * axis + 1] = {axis, false, -axes.axes[axis]};
    }
    std::ranges::stable_sort(ends, {}, [](const AxisEnd& end) { return end.at.z(); });
    return ends;
}

void drawEnd(const AxisEnd& end, const ImVec2& center, const ImVec2& at, float scale, bool hot) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 color = end.color(hot);
    const float radius = kBall * scale;
    if (!end.positive) {
        draw.AddCircleFilled(at, 0.8F * radius, IM_COL32(30, 34, 42, 230), 24);
        draw.AddCircle(at, 0.8F * radius, color, 24, 1.5F * scale);
        return;
    }
    draw.AddLine(center, at, color, kLine * scale);
    draw.AddCircleFilled(at, radius, color, 24);
    const ImVec2 size = ImGui::CalcTextSize(kNames[end.axis]);
    draw.AddText({at.x - size.x / 2, at.y - size.y / 2}, IM_COL32(16, 18, 22, 255),
                 kNames[end.axis]);
}

/// Whether the pointer is over it.
bool addButton(const AxisEnd& end, const ImVec2& at, float scale, std::vector<Action>& actions) {
    const float radius = kBall * scale;
    ImGui::SetCursorScreenPos({at.x - radius, at.y - radius});
    const std::string name = std::string(end.positive ? "" : "-") + kNames[end.axis];
    if (ImGui::InvisibleButton(name.c_str(), {2 * radius, 2 * radius})) {
        actions.emplace_back(end.action());
    }
    describeItem("axes." + name, describeAction(end.action()));
    return ImGui::IsItemHovered();
}

}  // namespace

bool hasRoomForAxes(const Rect& view, float scale) {
    const float half = (kArm + kBall) * scale;
    return view.width >= 6 * half && view.height >= 4 * half;
}

void drawAxes(const ViewAxes& axes, const Rect& view, float scale, std::vector<Action>& actions) {
    const float half = (kArm + kBall) * scale;
    const float margin = kMargin * scale;
    if (!hasRoomForAxes(view, scale)) {
        return;
    }
    const ImVec2 center{view.x + view.width - margin - half, view.y + margin + half};
    ImGui::SetNextWindowPos({center.x - half, center.y - half});
    ImGui::SetNextWindowSize({2 * half, 2 * half});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::Begin("axes", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav);
    std::array<AxisEnd, 6> ends = endsOf(axes);
    std::array<ImVec2, 6> positions;
    std::array<bool, 6> hot{};
    // The nearest takes the pointer first.
    for (int i = 5; i >= 0; --i) {
        positions[i] = {center.x + kArm * scale * static_cast<float>(ends[i].at.x()),
                        center.y - kArm * scale * static_cast<float>(ends[i].at.y())};
        hot[i] = addButton(ends[i], positions[i], scale, actions);
    }
    for (int i = 0; i < 6; ++i) {
        drawEnd(ends[i], center, positions[i], scale, hot[i]);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace kerf::ui
