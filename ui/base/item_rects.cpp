#include "ui/base/item_rects.h"

#include <imgui.h>

namespace kerf::ui {
namespace {

ItemRects* rectsNow = nullptr;

}  // namespace

ItemNotes::ItemNotes(ItemRects& rects) {
    rects.clear();
    rectsNow = &rects;
}

ItemNotes::~ItemNotes() {
    rectsNow = nullptr;
}

void noteItem(const std::string& name) {
    if (rectsNow != nullptr) {
        const ImVec2 low = ImGui::GetItemRectMin();
        const ImVec2 size = ImGui::GetItemRectSize();
        (*rectsNow)[name] = {low.x, low.y, size.x, size.y};
    }
}

}  // namespace kerf::ui
