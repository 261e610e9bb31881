#pragma once

#include <boost/context/fiber.hpp>
#include <deque>
#include <exception>

#include "app/scene/editor_scene.h"
#include "app/scene/editor_stroke.h"
#include "app/scene/held_hands.h"
#include "app/scene/readout/scene_readout.h"
#include "app/scene/timeline/scene_recorder.h"
#include "gpu/bindings.h"
#include "sim/base/stopwatch.h"
#include "sim/run/undo/undo_history.h"
#include "ui/state/action.h"

namespace kerf::app {

/// What may be used of the open scene while a step is paused: see "Steps in portions" in
/// docs/architecture.md. Null where nothing is open.
class BusyScene {
  public:
    BusyScene() = default;
    BusyScene(EditorScene* scene, bool underWay) : scene_(scene), underWay_(underWay) {}
    explicit operator bool() const { return scene_ != nullptr; }
    /// All of it if no step is in progress, otherwise null.
    EditorScene* atRest() const { return underWay_ ? nullptr : scene_; }

    // What a step takes up when it begins, so that it may be changed at any time.
    BladeStroke& stroke() const { return scene_->stroke(); }
    bool& playing() const { return scene_->timeline().playing; }
    void stopSeeking() const { scene_->timeline().stopSeeking(); }

    // What no step changes, or changes as a whole between two pauses.
    const Document& document() const { return scene_->document(); }
    double timeStep() const { return scene_->simulation().params().timeStep; }
    const UndoHistory& history() const { return scene_->simulation().history(); }
    const render::Camera& homeView() const { return scene_->rest().homeView(); }
    double diagonal() const { return scene_->rest().bounds().diagonal(); }  ///< at rest [m]
    const Bounds& bounds() const { return scene_->simulation().bounds(); }
    /// What the home view has room for [m].
    Bounds homeBounds() const { return scene_->rest().lines().value_or(bounds()); }
    const std::vector<Bounds>& pieceBounds() const { return scene_->simulation().pieceBounds(); }
    const auto& faultMarks() const { return scene_->readout().faultMarks(); }
    const std::vector<Load>& loads() const { return scene_->readout().loads(); }
    bool running() const { return scene_->running(); }
    bool pulling() const { return scene_->hands().pulling(); }
    bool recording() const { return scene_->recorder().recording(); }
    bool takesPictures() const { return scene_->recorder().takesPictures(); }
    int seekSteps() const { return scene_->timeline().seekSteps(); }
    int seekTarget() const { return scene_->simulation().stepCount() + seekSteps(); }
    int deeds() const { return scene_->recorder().deeds(); }
    /// Whether a thread computes something for the panels or the colours.
    bool workingOut() const {
        return scene_->readout().thickness().working() || scene_->readout().cuts().working();
    }
    /// Whether it may be drawn, as by BodyDisplay::viewOf(): not while the body is inconsistent.
    bool isWhole() const { return scene_->simulation().isWhole(); }

  private:
    friend class BodyDisplay;

    EditorScene* scene_ = nullptr;
    bool underWay_ = false;
};

/// Work of this thread in portions: a fiber with its own stack that pauses at pausePoint()s. The
/// OpenGL context is the same, so code between two portions may read what the work writes, but must
/// not change it.
class WorkInPortions {
  public:
    /// `check`: of Pauses.
    explicit WorkInPortions(std::function<std::string()> check = {}) : check_(std::move(check)) {}
    ~WorkInPortions() { giveUp(); }
    WorkInPortions(const WorkInPortions&) = delete;
    WorkInPortions& operator=(const WorkInPortions&) = delete;

    /// Takes work, which starts with goOn(). There must be none in progress.
    void begin(std::function<void()> work);
    bool underWay() const { return static_cast<bool>(work_); }
    /// Whether the caller is the work.
    bool isWorking() const { return working_; }
    /// Continues for about `seconds`, up to the next pausePoint(). Throws what the work throws,
    /// which ends it.
    void goOn(double seconds);
    /// Completes the work. Throws what it throws.
    void finish();
    /// Cancels the work: its stack is unwound.
    void giveUp() { work_ = {}; }
    /// Since it was begun [s].
    double seconds() const { return underWay() ? sinceBegun_.seconds() : 0; }

  private:
    using Fiber = boost::context::fiber;
    Fiber run(Fiber&& caller, const std::function<void()>& work);
    void rest();
    void resume();

    Fiber work_;  ///< where it pauses; none without work
    Fiber caller_;
    bool working_ = false;
    double portion_ = 0;  ///< [s]
    Stopwatch sinceResumed_, sinceBegun_;
    std::exception_ptr failure_;
    std::function<std::string()> check_;
};

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
