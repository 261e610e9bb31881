#include "ui/state/menu_icons.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace kerf::ui {
namespace {

/// Lines through points in percent of a square, from its upper left corner. After its points a line
/// is drawn open (-), closed (o) or filled (*).
struct Icon {
    ActionId id;
    const char* lines;
};
constexpr const char* kCamera =
    "5 28 33 28 40 14 60 14 67 28 95 28 95 85 5 85 o 50 40 63 46 66 57 60 68 50 72 40 68 34 57 "
    "37 46 o";
constexpr std::array kIcons{
    Icon{ActionId::openFile, "5 20 40 20 50 32 95 32 95 85 5 85 o"},
    Icon{ActionId::addModel, "50 12 50 88 - 12 50 88 50 -"},
    Icon{ActionId::saveSession,
         "10 10 75 10 90 25 90 90 10 90 o 30 10 30 36 65 36 65 10 - "
         "26 90 26 60 74 60 74 90 -"},
    Icon{ActionId::exportBody, "12 55 12 90 88 90 88 55 - 50 70 50 12 - 27 35 50 12 73 35 -"},
    Icon{ActionId::makeFilm, "5 25 66 25 66 78 5 78 o 70 52 98 28 98 76 *"},
    Icon{ActionId::screenshot, kCamera},
    Icon{ActionId::quit, "18 18 82 82 - 82 18 18 82 -"},
    Icon{ActionId::undo, "25 42 60 42 80 52 84 66 78 82 60 90 40 90 - 2 42 34 20 34 64 *"},
    Icon{ActionId::redo, "75 42 40 42 20 52 16 66 22 82 40 90 60 90 - 98 42 66 64 66 20 *"},
    Icon{ActionId::toggleGravity, "50 8 50 65 - 22 60 78 60 50 94 *"},
    Icon{ActionId::playPause, "20 10 90 50 20 90 *"},
    Icon{ActionId::stepOnce, "12 12 70 50 12 88 * 82 12 82 88 -"},
    Icon{ActionId::reset, "88 12 88 88 30 50 * 18 12 18 88 -"},
    Icon{ActionId::record, "50 12 77 23 88 50 77 77 50 88 23 77 12 50 23 23 *"},
    Icon{ActionId::addCamera, kCamera},
    Icon{ActionId::frameBody,
         "10 35 10 10 35 10 - 65 10 90 10 90 35 - 90 65 90 90 65 90 - "
         "35 90 10 90 10 65 -"},
    Icon{ActionId::resetView, "5 52 50 12 95 52 - 20 42 20 90 80 90 80 42 -"},
    Icon{ActionId::manual, "15 10 85 10 85 90 15 90 o 32 10 32 90 -"},
    Icon{ActionId::about,
         "50 8 80 20 92 50 80 80 50 92 20 80 8 50 20 20 o 50 44 50 74 - "
         "50 24 50 34 -"},
};

}  // namespace

void drawIcon(ActionId id, const ImVec2& low, float side, ImU32 color) {
    const auto* const icon = std::ranges::find(kIcons, id, &Icon::id);
    std::istringstream words(icon == kIcons.end() ? "" : icon->lines);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (std::string x; words >> x;) {
        float y = 0;
        if (x == "*") {
            draw.PathFillConvex(color);
        } else if (x == "-" || x == "o") {
            draw.PathStroke(color, x == "o" ? ImDrawFlags_Closed : ImDrawFlags_None, 0.1F * side);
        } else if (words >> y) {
            draw.PathLineTo({low.x + std::stof(x) * side / 100, low.y + y * side / 100});
        }
    }
}

}  // namespace kerf::ui
