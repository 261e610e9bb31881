#pragma once

#include <vector>

#include "render/scene/scene.h"
#include "ui/panel_model.h"

namespace kerf::app {

/// How the pieces are shown: which are hidden, and which one the pointer rests on in the list. No
/// part of the simulation: hidden pieces move and are cut all the same, and undo leaves it alone.
class PieceDisplay {
  public:
    /// All visible.
    void clear() { *this = PieceDisplay{}; }
    /// Whether that changes the picture.
    bool hover(int piece);
    void show(int piece, bool visible);

    /// What the renderer needs; empty where all pieces look as always. `bounds`: of the pieces [m];
    /// `apart`: see ui::DisplaySettings.
    std::vector<render::PieceLook> looks(const std::vector<Bounds>& bounds, double apart) const;
    /// Sets the rows' `hidden`, and which one is hovered.
    void describe(ui::PanelModel& model) const;

  private:
    bool isHidden(std::size_t piece) const { return piece < hidden_.size() && hidden_[piece]; }

    std::vector<bool> hidden_;
    int hovered_ = -1;
};

}  // namespace kerf::app
