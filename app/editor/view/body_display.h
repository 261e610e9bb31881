#pragma once

#include "app/editor/steps/scene_at_work.h"
#include "render/scene/scene.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// The rows of a list that the pointer is on, and that is selected; -1 for none.
struct ListMarks {
    int hovered = -1;
    int selected = -1;

    bool operator==(const ListMarks&) const = default;
    /// The one to be highlighted; -1 for none.
    int shown() const { return hovered < 0 ? selected : hovered; }
};

/// The display of the body: its settings, the hidden and the coloured pieces, and what is marked in
/// their list and in that of the loads. It is not part of the simulation: hidden pieces move and
/// are cut, and undo does not affect it.
class BodyDisplay {
  public:
    ui::DisplaySettings settings;
    ListMarks pieces;
    ListMarks loads;

    bool operator==(const BodyDisplay&) const = default;

    /// Shows a document that was just opened: all of it, together, in the colours of its session.
    void begin(const Document& document);
    void show(int piece, bool visible) { own(piece).hidden = !visible; }
    /// Gives a piece a colour, in display colours, or its look again.
    void color(int piece, const std::optional<Vec3>& color) { own(piece).color = color; }
    /// The hidden and the coloured pieces, as a session keeps them.
    std::vector<ShownPiece> ownLooks() const;
    void setOwnLooks(std::vector<ShownPiece> looks) { own_ = std::move(looks); }
    /// Selects a row of the loads, -1 for none, and keeps to that load while rows come and go.
    void select(const std::vector<Load>& rows, int row);
    /// Follows that a piece was removed, or came back: those behind it have other numbers now.
    void followRemoval(int piece, bool back);
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
    /// its pieces and loads are hidden or marked.
    void describe(const BusyScene& scene, ui::PanelModel& model);

  private:
    ShownPiece& own(int piece);
    std::vector<render::PieceLook> looksOf(const std::vector<Bounds>& bounds) const;

    std::vector<ShownPiece> own_;       ///< of the first pieces; the others look as always
    std::optional<Load> selectedLoad_;  ///< as it was listed last
};

}  // namespace kerf::app
