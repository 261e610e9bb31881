#include "app/editor/view/start_scenes.h"

#include <spdlog/spdlog.h>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "gpu/data_path.h"

namespace kerf::app {
namespace {

using Cards = std::vector<ui::StartCard>;

std::shared_ptr<const Cards> readCards() {
    auto cards = std::make_shared<Cards>(Cards{
        {"citrus", "Citrus", "Drag all the way across it, then press Shift+Space."},
        {"banana", "Banana", "Cut off a few slices, then press Shift+Space."},
        {"octopus", "Octopus", "Cut off an arm, then press D and pull at another."},
        {"liver", "Liver",
         "Press S and draw an incision, then Y and drag across it to hold it open."},
        {"jelly", "Jelly cube", "Press Shift+Space: it falls and wobbles. Then cut it."},
        {"tear", "Jelly to tear", "Press D and pull its right half away from the slit."},
        {"orange", "Orange to open", "Press D, double the Hand, and pull its right half far off."},
        {"incision", "Incision to tear",
         "Press Y and drag across the slit to hold it open. Too far, and it tears on."},
        {"egg", "Hollow egg", "Cut it in two, then press Shift+Space: it falls open."},
        {"cloth", "Cloth", "Press Shift+Space: it drapes itself. Then cut it."},
        {"../practice/incision", "Practise: incision",
         "Press S, set 5 mm, and draw along the line. Shift+Enter scores it."},
        {"../practice/excision", "Practise: excision",
         "Press C and lead the blade once round, and a little farther. Then Shift+Enter."},
        {"../practice/slice", "Practise: slice",
         "Press C and cut down through the right line, then the left one. Then Shift+Enter."},
    });
    for (ui::StartCard& card : *cards) {
        try {
            card.picture = std::make_shared<render::Image>(
                readPicture(gpu::dataPath("assets/start/" + card.name + ".png")));
        } catch (const InputError& error) {
            spdlog::warn("{}", error.what());
        }
    }
    return cards;
}

}  // namespace

std::shared_ptr<const Cards> startCards() {
    static const std::shared_ptr<const Cards> cards = readCards();
    return cards;
}

std::filesystem::path startSession(const std::string& name) {
    return gpu::dataPath("assets/start/" + name + ".kerf.json");
}

}  // namespace kerf::app
