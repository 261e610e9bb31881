#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "app/editor/steps/busy_scene.h"
#include "app/editor/steps/work_in_portions.h"
#include "gpu/bindings.h"
#include "ui/state/action.h"

namespace kerf::app {

/// The work of a scene: steps, or a requested change.
enum class SceneWork { steps, change };

/// The open scene and its work: steps and commands are done in portions, so that frames are drawn
/// in between. All access to the scene first completes the current work; only meanwhile() doesn't
/// wait.
class SceneAtWork {
  public:
    std::deque<ui::Action> waiting;    ///< until the scene has finished its work
    std::function<void()> onceSought;  ///< called when a seek has come to its end; may be null
    bool stops = false;  ///< its steps were cancelled, and the last one is not done yet

    /// Replaces the previous one, cancelling its work and what waits; null for none.
    void set(std::unique_ptr<EditorScene> scene);

    /// Sets a scene and returns the previous one; there must be no work.
    std::unique_ptr<EditorScene> exchange(std::unique_ptr<EditorScene> scene);

    /// The scene, after completing its work; null if none is open. Throws what the work throws.
    EditorScene* get();
    EditorScene* operator->() { return get(); }
    EditorScene& operator*() { return *get(); }
    friend bool operator==(const SceneAtWork& scene, std::nullptr_t) {
        return scene.scene_ == nullptr;
    }

    /// The scene, perhaps during its work: as much of it as may be used then.
    BusyScene meanwhile() const { return {scene_.get(), underWay() && !work_.isWorking()}; }
    /// The scene if it has no work; null otherwise, and if none is open.
    EditorScene* atRest() const { return meanwhile().atRest(); }

    /// Begins work, to be done by goOn(); there must be none.
    void begin(SceneWork kind, std::function<void(EditorScene&)> work);
    bool underWay() const { return work_.underWay(); }
    bool isAt(SceneWork kind) const { return underWay() && kind_ == kind; }
    /// Continues for about `seconds`. Throws what the work throws, which ends it.
    void goOn(double seconds) { work_.goOn(seconds); }
    /// Age of the current work [s].
    double seconds() const { return work_.seconds(); }

  private:
    std::unique_ptr<EditorScene> scene_;
    SceneWork kind_ = SceneWork::steps;
    WorkInPortions work_{gpu::clearBindings};  // gone before the scene
};

}  // namespace kerf::app
