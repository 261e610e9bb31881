#include "app/editor/piece_display.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/theme.h"

namespace kerf::app {
namespace {

constexpr float kHighlight = 0.7F;  // strength of the tint

/// The colour of an IM_COL32 in linear light.
Eigen::Vector3f linearOf(unsigned color) {
    const auto channel = [color](int shift) {
        return std::pow(static_cast<float>((color >> shift) & 0xffU) / 255.0F, 2.2F);
    };
    return {channel(0), channel(8), channel(16)};
}

/// Away from the middle of all. None goes down: there may be a floor.
void shiftApart(const std::vector<Bounds>& bounds, double apart,
                std::vector<render::PieceLook>& looks) {
    Bounds all;
    for (const Bounds& piece : bounds) {
        all.add(piece);
    }
    double lowest = 0;
    for (std::size_t p = 0; p < looks.size(); ++p) {
        if (!bounds[p].empty()) {
            looks[p].shift = apart * (bounds[p].center() - all.center());
            lowest = std::min(lowest, looks[p].shift.y());
        }
    }
    for (render::PieceLook& look : looks) {
        look.shift.y() -= lowest;
    }
}

}  // namespace

bool PieceDisplay::hover(int piece) {
    return std::exchange(hovered_, piece) != piece;
}

void PieceDisplay::show(int piece, bool visible) {
    hidden_.resize(std::max(hidden_.size(), static_cast<std::size_t>(piece) + 1), false);
    hidden_[static_cast<std::size_t>(piece)] = !visible;
}

std::vector<render::PieceLook> PieceDisplay::looks(const std::vector<Bounds>& bounds,
                                                   double apart) const {
    const bool plain =
        hovered_ < 0 && apart == 0 && std::ranges::find(hidden_, true) == hidden_.end();
    std::vector<render::PieceLook> looks(plain ? 0 : bounds.size());
    if (apart > 0) {
        shiftApart(bounds, apart, looks);
    }
    for (std::size_t p = 0; p < looks.size(); ++p) {
        looks[p].hidden = isHidden(p);
        if (static_cast<int>(p) == hovered_) {
            looks[p].tint = linearOf(ui::pieceColor(hovered_));
            looks[p].strength = kHighlight;
        }
    }
    return looks;
}

void PieceDisplay::describe(ui::PanelModel& model) const {
    model.hoveredPiece = hovered_;
    for (std::size_t p = 0; p < model.pieces.size(); ++p) {
        model.pieces[p].hidden = isHidden(p);
    }
}

}  // namespace kerf::app
