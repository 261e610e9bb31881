#pragma once

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
    bool hidden = false;            ///< nobody sees the window

    /// The body or its surroundings have changed: redraws the scene and the panels.
    void scene() {
        scene_ = true;
        panels();
    }
    /// Steps have moved the body: redraws the scene, with the panels, when steps are shown.
    void steps() { steps_ = true; }
    /// The content of the panels has changed.
    void panels() { updates_ = kSettleUpdates; }
    /// Counts an update of the panels. A `quiet` one had no input and no action.
    void countUpdate(bool quiet) { updates_ = quiet ? std::max(0, updates_ - 1) : kSettleUpdates; }

    /// Whether the scene must be redrawn, and resets that; for steps only if they are to be shown
    /// now (`showSteps`).
    bool takeScene(bool showSteps = true) {
        const bool wanted = scene_ || putOff_ || (showSteps && steps_);
        if (wanted) {
            shown_ = shown_ || (steps_ && !hidden);
            scene_ = steps_ = putOff_ = false;
            drawing_ = true;
            sinceScene_.restart();
        }
        return wanted;
    }
    /// Whether steps were shown since the last call.
    bool takeShown() { return std::exchange(shown_, false); }
    /// A picture is about to be drawn; what comes before that took `before` [s].
    void begin(double before) {
        before_ = before;
        sincePicture_.restart();
    }
    /// It is on the screen.
    void end() {
        if (std::exchange(drawing_, false)) {
            cost_ = before_ + sinceScene_.seconds();
        }
    }
    /// Since the last picture was begun, perhaps of the panels alone [s].
    double sincePicture() const { return sincePicture_.seconds(); }
    /// Whether steps that can't keep up with the clock have run long enough for a picture of them:
    /// pictures take a quarter of the time at most. Unless they are cheap, they come 12 times a
    /// second; but once a second however much they cost.
    bool stepsAreDue() const {
        constexpr double kUsual = 1.0 / 12;  // [s]
        constexpr double kCheap = 12;        // times its cost
        constexpr double kLeast = 4;         // the same
        constexpr double kMost = 1;          // beside its cost [s]
        const double rest = std::max(kLeast * cost_, std::min(kCheap * cost_, kUsual));
        return sinceScene_.seconds() >= std::min(rest, cost_ + kMost);
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
    bool shown_ = false;
    bool drawing_ = false;
    Stopwatch sincePicture_;
    Stopwatch sinceScene_;  ///< was begun to be drawn
    double before_ = 0;     ///< [s]
    double cost_ = 0;       ///< of its picture, with the panels [s]
    int updates_ = kSettleUpdates;
};

}  // namespace kerf::app
