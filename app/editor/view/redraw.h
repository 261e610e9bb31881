#pragma once

#include <algorithm>

#include "sim/base/stopwatch.h"

namespace kerf::app {

/// Records whether the scene and the panels must be redrawn. Changes of view, display or size need
/// no call: EditorPicture detects them.
class Redraw {
  public:
    /// See EditorOptions::drawsAll.
    explicit Redraw(bool all) : drawsAll(all) {}

    const bool drawsAll;
    bool screenshotWanted = false;  ///< of the next picture
    Stopwatch sincePicture;

    /// The body or its surroundings have changed: redraws the scene and the panels.
    void scene() {
        scene_ = true;
        panels();
    }
    /// Steps have moved the body: redraws the panels, and the scene when steps are shown.
    void steps() {
        steps_ = true;
        panels();
    }
    /// The content of the panels has changed.
    void panels() { updates_ = kSettleUpdates; }
    /// Counts an update of the panels. A `quiet` one had no input and no action.
    void countUpdate(bool quiet) { updates_ = quiet ? std::max(0, updates_ - 1) : kSettleUpdates; }

    /// Whether the scene must be redrawn, and resets that; for steps only if they are to be shown
    /// now (`showSteps`).
    bool takeScene(bool showSteps = true) {
        const bool wanted = scene_ || putOff_ || (showSteps && steps_);
        if (wanted) {
            scene_ = steps_ = putOff_ = false;
        }
        return wanted;
    }
    /// Postpones it to the next takeScene(); nothing is pending until then.
    void putOff() { putOff_ = takeScene(); }
    /// Whether something is still to be drawn, apart from steps.
    bool pending() const { return scene_ || updates_ > 0; }
    /// Whether steps are still to be shown.
    bool stepsPending() const { return steps_; }

  private:
    /// Updates of the panels after the last change, for those that answer late.
    static constexpr int kSettleUpdates = 2;

    bool scene_ = true;
    bool steps_ = false;
    bool putOff_ = false;
    int updates_ = kSettleUpdates;
};

}  // namespace kerf::app
