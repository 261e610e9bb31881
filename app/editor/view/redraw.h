#pragma once

#include <algorithm>
#include <utility>

#include "sim/base/stopwatch.h"

namespace kerf::app {

/// Remembers whether the scene and the panels must be drawn again. A change of the view, of the
/// display or of the size needs no call: EditorPicture sees it.
class Redraw {
  public:
    /// See EditorOptions::drawsAll.
    explicit Redraw(bool all) : drawsAll(all) {}

    const bool drawsAll;
    bool screenshotWanted = false;  ///< of the next picture
    Stopwatch sincePicture;

    /// The body, or what stands around it, has changed: the scene and the panels show that.
    void scene() {
        scene_ = true;
        panels();
    }
    /// Steps have moved the body: the panels show that, the scene once it is asked for steps.
    void steps() {
        steps_ = true;
        panels();
    }
    /// The panels have something else to show.
    void panels() { updates_ = kSettleUpdates; }
    /// Notes an update of the panels. A `quiet` one had no input and no answer.
    void countUpdate(bool quiet) { updates_ = quiet ? std::max(0, updates_ - 1) : kSettleUpdates; }

    /// Whether the scene is to be drawn anew since that was last so; for steps alone where they are
    /// to be shown now (`showSteps`).
    bool takeScene(bool showSteps = true) {
        const bool wanted = scene_ || putOff_ || (showSteps && steps_);
        if (wanted) {
            scene_ = steps_ = putOff_ = false;
        }
        return wanted;
    }
    /// Leaves it to the next takeScene() to say so; nothing is pending until then.
    void putOff() { putOff_ = takeScene(); }
    /// Whether something is still to be drawn, but for steps.
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
