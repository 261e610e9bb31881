#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>

#include "app/editor/steps/busy_scene.h"
#include "app/editor/steps/work_in_portions.h"
#include "gpu/bindings.h"
#include "ui/state/action.h"

namespace kerf::app {

/// What a scene is doing: steps, or something that was asked for.
enum class SceneWork { steps, change };

/// The open scene, and what it is doing: steps and commands are done in portions, so that pictures
/// come meanwhile. Whoever asks for the scene gets it between two of them: what is under way is
/// done to its end first. meanwhile() alone doesn't wait.
class SceneAtWork {
  public:
    std::deque<ui::Action> waiting;  ///< for the scene to be done with what it does

    /// Instead of the one before, of which what is under way and what waits is given up; null
    /// for none.
    void set(std::unique_ptr<EditorScene> scene);

    /// Sets a scene and hands back the one before; nothing must be under way.
    std::unique_ptr<EditorScene> exchange(std::unique_ptr<EditorScene> scene);

    /// The scene, with nothing under way; null while none is open. Throws what the work throws.
    EditorScene* get();
    EditorScene* operator->() { return get(); }
    EditorScene& operator*() { return *get(); }
    friend bool operator==(const SceneAtWork& scene, std::nullptr_t) {
        return scene.scene_ == nullptr;
    }

    /// The scene, perhaps in the midst of what it does: as much of it as may be used then.
    BusyScene meanwhile() const { return {scene_.get(), underWay() && !work_.isWorking()}; }
    /// The scene where nothing is under way; null otherwise, and while none is open.
    EditorScene* atRest() const { return meanwhile().atRest(); }

    /// Begins something, to be done by goOn(); nothing must be under way.
    void begin(SceneWork kind, std::function<void(EditorScene&)> work);
    bool underWay() const { return work_.underWay(); }
    bool isAt(SceneWork kind) const { return underWay() && kind_ == kind; }
    /// Goes on for about `seconds`. Throws what the work throws, which ends it.
    void goOn(double seconds) { work_.goOn(seconds); }
    /// Since what is under way was begun [s].
    double seconds() const { return work_.seconds(); }

  private:
    std::unique_ptr<EditorScene> scene_;
    SceneWork kind_ = SceneWork::steps;
    WorkInPortions work_{gpu::clearBindings};  // gone before the scene
};

}  // namespace kerf::app
