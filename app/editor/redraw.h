#pragma once

#include <algorithm>
#include <utility>

namespace kerf::app {

/// Remembers whether the scene and the panels must be drawn again. A change of the view, of the
/// display or of the size needs no call: EditorPicture sees it.
class Redraw {
  public:
    /// The body, or what stands around it, has changed: the scene and the panels show that.
    void scene() {
        scene_ = true;
        panels();
    }
    /// The panels have something else to show.
    void panels() { updates_ = kSettleUpdates; }
    /// Notes an update of the panels. A `quiet` one had no input and no answer.
    void countUpdate(bool quiet) { updates_ = quiet ? std::max(0, updates_ - 1) : kSettleUpdates; }

    /// Whether the scene has changed since the last call.
    bool takeScene() { return std::exchange(scene_, false); }
    /// Whether something is still to be drawn.
    bool pending() const { return scene_ || updates_ > 0; }

  private:
    /// Updates of the panels after the last change, for those that answer late.
    static constexpr int kSettleUpdates = 2;

    bool scene_ = true;
    int updates_ = kSettleUpdates;
};

}  // namespace kerf::app
