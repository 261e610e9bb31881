#include "ui/item_places.h"

#include <imgui.h>

namespace kerf::ui {
namespace {

ItemPlaces* placesNow = nullptr;

}  // namespace

ItemNotes::ItemNotes(ItemPlaces& places) {
    places.clear();
    placesNow = &places;
}

ItemNotes::~ItemNotes() {
    placesNow = nullptr;
}

void noteItem(const std::string& name) {
    if (placesNow != nullptr) {
        const ImVec2 low = ImGui::GetItemRectMin();
        const ImVec2 size = ImGui::GetItemRectSize();
        (*placesNow)[name] = {low.x, low.y, size.x, size.y};
    }
}

}  // namespace kerf::ui
