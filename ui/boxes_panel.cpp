#include "ui/boxes_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

#include "ui/item_places.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

/// How a row of three numbers is dragged.
struct Range {
    float speed = 0.01F;  ///< per pixel
    double low = 0;
    double high = 0;
    const char* format = "%.3f";
};

/// What happened to a row in this pass.
struct Drag {
    bool changed = false;
    bool continues = false;  ///< the same gesture had changed it before
};

Drag dragVector(const char* label, Vec3& value, const Range& range, const std::string& place) {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 4.2F * ImGui::GetFontSize());
    ImGui::PushID(label);
    Drag drag;
    drag.changed =
        ImGui::DragScalarN("##value", ImGuiDataType_Double, value.data(), 3, range.speed,
                           &range.low, &range.high, range.format, ImGuiSliderFlags_AlwaysClamp);
    noteItem(place + "." + label);
    drag.continues = continuesGesture(drag.changed);
    ImGui::SameLine();
    ImGui::TextUnformatted(label);
    ImGui::PopID();
    return drag;
}

/// There may be thousands of boxes.
bool isClosedAndOutOfView(const char* node) {
    return !ImGui::GetStateStorage()->GetBool(ImGui::GetID(node)) &&
           !ImGui::IsRectVisible({1, ImGui::GetTextLineHeight()});
}

void drawBox(int index, const PanelModel& model, std::vector<Action>& actions) {
    const std::string place = "box." + std::to_string(index);
    ImGui::PushID(index);
    if (isClosedAndOutOfView("##box")) {
        ImGui::Dummy({1, ImGui::GetTextLineHeight()});
        ImGui::PopID();
        return;
    }
    const bool open = ImGui::TreeNodeEx("##box", ImGuiTreeNodeFlags_None, "Box %d", index);
    noteItem(place);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - buttonWidth("Remove"));
    if (ImGui::SmallButton("Remove")) {
        actions.emplace_back(RemoveBox{index});
    }
    noteItem(place + ".remove");
    if (open) {
        ChangeBox change{index, model.boxes[index]};
        const auto step = static_cast<float>(0.002 * model.bodySize);
        const std::array drags{
            dragVector("Center", change.box.center, {step, -kFarthestBox, kFarthestBox}, place),
            dragVector("Size", change.box.size, {step, kLeastBoxSize, kLargestBoxSize}, place),
            dragVector("Rotate", change.box.rotate,
                       {0.5F, -kLargestBoxTurn, kLargestBoxTurn, "%.1f\u00b0"}, place)};
        for (const Drag& drag : drags) {
            if (drag.changed) {
                change.continues = drag.continues;
                actions.emplace_back(change);
            }
        }
        ImGui::TreePop();
    }
    ImGui::PopID();
}

}  // namespace

void drawBoxes(const PanelModel& model, std::vector<Action>& actions) {
    if (ImGui::Button("Add a box", {-1, 0})) {
        actions.emplace_back(PlaceBox{});
    }
    noteItem("boxes.add");
    itemTooltip("A cube beside the body, which it collides with");
    for (int i = 0; i < static_cast<int>(model.boxes.size()); ++i) {
        drawBox(i, model, actions);
    }
}

}  // namespace kerf::ui
