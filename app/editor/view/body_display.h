#pragma once

#include <set>
#include <vector>

#include "app/editor/steps/busy_scene.h"
#include "render/scene/scene.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// The way in which the body is shown: its settings, which pieces are hidden, and which one the
/// pointer rests on in their list. It is no part of the simulation: hidden pieces move and are cut
/// all the same, and undo leaves it alone.
class BodyDisplay {
  public:
    ui::DisplaySettings settings;

    bool operator==(const BodyDisplay&) const = default;

    /// Shows a document that was just opened: all of it, together, in the colours of its session.
    void begin(const Document& document);
    /// Highlights the piece under the pointer, -1 for none.
    void hover(int piece) { hovered_ = piece; }
    void show(int piece, bool visible);
    /// Draws the pieces together again. What is shown apart is not where it is: whoever touches it
    /// has it together first. Returns whether it was apart.
    bool join();

    /// The bounds of the body as it is drawn, with its pieces together or apart [m].
    Bounds boundsOf(const BusyScene& scene) const;
    /// Bounds of piece number `piece` as drawn [m]; empty where there is no such piece.
    Bounds boundsOf(const BusyScene& scene, int piece) const;

    /// The look that the body is shown in, as far as it has no colours of its own.
    render::BodyLook look(const Document& document) const;
    /// The scene with all that the person chose to see, where BusyScene::isWhole().
    render::SceneView viewOf(const BusyScene& scene) const;
    /// Sets the settings, and of an open `scene` the colours of the model itself, and which rows of
    /// its pieces are hidden or hovered.
    void describe(const BusyScene& scene, ui::PanelModel& model) const;

  private:
    std::vector<render::PieceLook> looksOf(const std::vector<Bounds>& bounds) const;

    std::set<int> hidden_;
    int hovered_ = -1;
};

}  // namespace kerf::app
