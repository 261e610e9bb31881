#pragma once

#include <vector>

#include "render/scene/scene.h"
#include "ui/panel_model.h"

namespace kerf::app {

/// The display of the pieces: which are hidden, and which one the pointer rests on in the list. It
/// is no part of the simulation: hidden pieces move and are cut all the same, and undo leaves it
/// alone.
class PieceDisplay {
  public:
    /// Makes all pieces visible.
    void clear() { *this = PieceDisplay{}; }
    /// Notes the piece under the pointer, -1 for none. Returns whether that changes the picture.
    bool hover(int piece);
    void show(int piece, bool visible);

    /// The look of each piece; empty where all look as always. `bounds` are those of the pieces
    /// [m]; for `apart` see ui::DisplaySettings.
    std::vector<render::PieceLook> looks(const std::vector<Bounds>& bounds, double apart) const;
    /// Sets the rows' `hidden`, and which one is hovered.
    void describe(ui::PanelModel& model) const;

  private:
    bool isHidden(std::size_t piece) const { return piece < hidden_.size() && hidden_[piece]; }

    std::vector<bool> hidden_;
    int hovered_ = -1;
};

}  // namespace kerf::app
