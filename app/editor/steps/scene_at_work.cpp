#include "app/editor/steps/scene_at_work.h"

#include <utility>

#include "sim/base/freed_memory.h"

namespace kerf::app {

void SceneAtWork::set(std::unique_ptr<EditorScene> scene) {
    work_.giveUp();
    waiting.clear();
    onceSought = nullptr;
    scene_ = std::move(scene);
    giveBackFreedMemory();
}

std::unique_ptr<EditorScene> SceneAtWork::exchange(std::unique_ptr<EditorScene> scene) {
    return std::exchange(scene_, std::move(scene));
}

EditorScene* SceneAtWork::get() {
    if (!work_.isWorking()) {
        work_.finish();
    }
    return scene_.get();
}

void SceneAtWork::begin(SceneWork kind, std::function<void(EditorScene&)> work) {
    kind_ = kind;
    work_.begin([work = std::move(work), scene = scene_.get()] { work(*scene); });
}

}  // namespace kerf::app
