#pragma once

#include "app/scene/editor_scene.h"
#include "app/scene/editor_stroke.h"
#include "app/scene/held_hands.h"
#include "app/scene/readout/scene_readout.h"
#include "app/scene/timeline/scene_recorder.h"
#include "sim/run/undo/undo_history.h"

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

}  // namespace kerf::app
