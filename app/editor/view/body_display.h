#pragma once

#include "app/editor/steps/scene_at_work.h"
#include "render/scene/scene.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// The display of the body: its settings, the hidden pieces, and the one hovered in their list. It
/// is not part of the simulation: hidden pieces move and are cut, and undo does not affect it.
class BodyDisplay {
  public:
    ui::DisplaySettings settings;

    bool operator==(const BodyDisplay&) const = default;

    /// Shows a document that was just opened: all of it, together, in the colours of its session.
    void begin(const Document& document);
    /// Highlights the piece under the pointer, -1 for none.
    void hover(int piece) { hovered_ = piece; }
    void show(int piece, bool visible);
    /// Draws the pieces together again, as before any tool touches them. Returns whether they were
    /// apart.
    bool join();

    /// The bounds of the body as it is drawn, with its pieces together or apart [m].
    Bounds boundsOf(const BusyScene& scene) const;
    /// Bounds of piece number `piece` as drawn [m]; empty for no such piece.
    Bounds boundsOf(const BusyScene& scene, int piece) const;

    /// The look of the body, where it has no colours of its own.
    render::BodyLook look(const Document& document) const;
    /// The scene with the display settings, if BusyScene::isWhole().
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
