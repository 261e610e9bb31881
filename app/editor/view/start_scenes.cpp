#include "app/editor/view/start_scenes.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/session/session.h"
#include "gpu/data_path.h"

namespace kerf::app {
namespace {

constexpr std::array kScenes{
    StartScene{"citrus", "Citrus", "Drag all the way across it, then press Shift+Space."},
    StartScene{"banana", "Banana", "Cut off a few slices, then press Shift+Space."},
    StartScene{"octopus", "Octopus", "Cut off an arm, then press D and pull at another."},
    StartScene{"liver", "Liver",
               "Press S and draw an incision, then Y and drag across it to hold it open."},
    StartScene{"jelly", "Jelly cube", "Press Shift+Space: it falls and wobbles. Then cut it."},
    StartScene{"egg", "Hollow egg", "Cut it in two, then press A to look inside."},
    StartScene{"cloth", "Cloth", "Press Shift+Space: it drapes itself. Then cut it."},
};

std::filesystem::path inFolder(const StartScene& scene, std::string_view ending) {
    return gpu::dataPath("assets/start") / (scene.name + std::string(ending));
}

ui::StartCard cardOf(const StartScene& scene) {
    ui::StartCard card{scene.name, scene.title, scene.tip, nullptr};
    try {
        card.picture = std::make_shared<render::Image>(readPicture(scene.picture()));
    } catch (const InputError& error) {
        spdlog::warn("{}", error.what());
    }
    return card;
}

}  // namespace

std::filesystem::path StartScene::session() const {
    return inFolder(*this, kSessionEnding);
}

std::filesystem::path StartScene::picture() const {
    return inFolder(*this, ".png");
}

std::span<const StartScene> startScenes() {
    return kScenes;
}

const StartScene* findStartScene(std::string_view name) {
    const auto* const found = std::ranges::find(kScenes, name, &StartScene::name);
    return found == kScenes.end() ? nullptr : found;
}

std::shared_ptr<const std::vector<ui::StartCard>> startCards() {
    static const auto cards = [] {
        auto made = std::make_shared<std::vector<ui::StartCard>>();
        std::ranges::transform(kScenes, std::back_inserter(*made), cardOf);
        return made;
    }();
    return cards;
}

}  // namespace kerf::app
