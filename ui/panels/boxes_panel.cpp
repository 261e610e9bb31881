#include <imgui.h>

#include "ui/base/layout.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"

namespace kerf::ui {
namespace {

/// How a row of three numbers is dragged.
struct DragRange {
    float speed = 0.01F;  ///< per pixel
    double low = 0;
    double high = 0;
    const char* unit = "m";
    const char* format = "%.3f";
};

/// A change of a row in this update.
struct DragEdit {
    bool changed = false;
    bool continues = false;  ///< the same gesture had changed it before
};

DragEdit dragVector(const char* label, Vec3& value, const DragRange& range,
                    const std::string& name) {
    ImGui::PushID(label);
    ImGui::TextUnformatted((std::string(label) + ", " + range.unit).c_str());
    ImGui::SetNextItemWidth(-1);
    DragEdit drag;
    drag.changed = dragNumbers(
        {value.data(), 3},
        {ImGuiDataType_Double, nullptr, &range.low, &range.high, range.format, false, range.unit},
        range.speed);
    noteItem(name + "." + label);
    drag.continues = continuesGesture(drag.changed);
    ImGui::PopID();
    return drag;
}

/// There may be thousands of boxes.
bool isClosedAndOutOfView(const char* node) {
    return !ImGui::GetStateStorage()->GetBool(ImGui::GetID(node)) &&
           !ImGui::IsRectVisible({1, ImGui::GetTextLineHeight()});
}

void drawBox(int index, const BodyReport& body, std::vector<Action>& actions) {
    const std::string name = "box." + std::to_string(index);
    ImGui::PushID(index);
    if (isClosedAndOutOfView("##box")) {
        ImGui::Dummy({1, ImGui::GetTextLineHeight()});
        ImGui::PopID();
        return;
    }
    const bool open = ImGui::TreeNodeEx("##box", ImGuiTreeNodeFlags_None, "Box %d", index + 1);
    noteItem(name);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - buttonWidth("Remove"));
    if (smallButton("Remove", name + ".remove")) {
        actions.emplace_back(RemoveBox{index});
    }
    if (open) {
        ChangeBox change{index, body.boxes[index]};
        const auto step = static_cast<float>(0.002 * body.size);
        const char* const metres = lengthFormat(body.size);
        const std::array drags{
            dragVector("Centre", change.box.center,
                       {step, -kFarthestBox, kFarthestBox, "m", metres}, name),
            dragVector("Size", change.box.size, {step, kLeastBoxSize, kLargestBoxSize, "m", metres},
                       name),
            dragVector("Rotate", change.box.rotate,
                       {0.5F, -kLargestBoxTurn, kLargestBoxTurn, "\u00b0", "%.1f"}, name)};
        for (const DragEdit& drag : drags) {
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

void drawBoxes(const BodyReport& body, std::vector<Action>& actions) {
    if (button("Add box", "boxes.add", "Add a cube beside the body as an obstacle", -1)) {
        actions.emplace_back(PlaceBox{});
    }
    for (int i = 0; i < static_cast<int>(body.boxes.size()); ++i) {
        drawBox(i, body, actions);
    }
}

}  // namespace kerf::ui
