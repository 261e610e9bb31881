#include "app/editor/view/body_display.h"

#include "app/scene/readout/scene_readout.h"
#include "sim/base/math.h"
#include "ui/base/theme.h"

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

/// Out of a piece that a core runs through, along the way that it was cut; none of other pieces.
Vec3 outOfOther(const std::vector<Bounds>& bounds, std::size_t core) {
    constexpr double kSameMiddle = 0.1;  // of the other's diagonal
    constexpr double kThrough = 0.6;     // of the other's side
    const Vec3 size = bounds[core].high - bounds[core].low;
    for (std::size_t other = 0; other < bounds.size(); ++other) {
        const Vec3 around = bounds[other].high - bounds[other].low;
        const Vec3 way = bounds[core].center() - bounds[other].center();
        int axis = 0;
        const double through = size.cwiseQuotient(around).maxCoeff(&axis);
        if (other != core && !bounds[other].empty() && size.prod() < around.prod() &&
            way.norm() < kSameMiddle * around.norm() && through > kThrough) {
            return around[axis] * (way[axis] < 0 ? -1 : 1) * Vec3::Unit(axis);
        }
    }
    return Vec3::Zero();
}

/// Away from the middle of all. None goes down: there may be a floor.
void shiftApart(const std::vector<Bounds>& bounds, double apart,
                std::vector<render::PieceLook>& looks) {
    const Bounds all = boxOf(bounds);
    double lowest = 0;
    for (std::size_t p = 0; p < looks.size(); ++p) {
        if (!bounds[p].empty()) {
            looks[p].shift = apart * (bounds[p].center() - all.center() + outOfOther(bounds, p));
            lowest = std::min(lowest, looks[p].shift.y());
        }
    }
    for (render::PieceLook& look : looks) {
        look.shift.y() -= lowest;
    }
}

render::BodyLook ownLook(const Document& document) {
    return render::lookFor(document.session.model.name());
}

Bounds shifted(Bounds bounds, const Vec3& by) {
    if (!bounds.empty()) {
        bounds.low += by;
        bounds.high += by;
    }
    return bounds;
}

/// The bounds of the pieces as they are drawn [m].
Bounds shownBounds(const std::vector<Bounds>& bounds, const std::vector<render::PieceLook>& looks) {
    Bounds shown;
    for (std::size_t p = 0; p < looks.size(); ++p) {
        const Bounds piece = shifted(bounds[p], looks[p].shift);
        if (!piece.empty()) {
            shown.add(piece);
        }
    }
    return shown;
}

void addOverlays(const render::Overlays& overlays, const Simulation& simulation,
                 render::SceneView& view) {
    view.overlays = overlays;
    view.constraints = simulation.constraintView();
    if (simulation.hands().empty() && simulation.forces().empty()) {
        view.constraints.pullCount = 0;  // those of a step before it let go
    }
    view.pinned = simulation.pinnedVertices();
}

}  // namespace

void BodyDisplay::begin(const Document& document) {
    settings.colors = document.session.colors;
    settings.apart = 0;
    settings.section.reset();
    own_.clear();
    pieces = loads = {};
    selectedLoad_.reset();
}

void BodyDisplay::followRemoval(int piece, bool back) {
    own(piece);
    const auto place = own_.begin() + piece;
    back ? own_.insert(place, ShownPiece{}) : own_.erase(place);
    pieces = {};
}

ShownPiece& BodyDisplay::own(int piece) {
    own_.resize(std::max(own_.size(), static_cast<std::size_t>(piece) + 1));
    return own_[piece];
}

std::vector<ShownPiece> BodyDisplay::ownLooks() const {
    std::vector<ShownPiece> looks = own_;
    while (!looks.empty() && looks.back() == ShownPiece{}) {
        looks.pop_back();
    }
    return looks;
}

bool BodyDisplay::join() {
    return std::exchange(settings.apart, 0) > 0;
}

render::SceneView BodyDisplay::viewOf(const BusyScene& busy) const {
    EditorScene& scene = *busy.scene_;
    const std::vector<Bounds>& bounds = scene.simulation().pieceBounds();
    render::SceneView view = scene.readout().view();
    view.wireframe = settings.wireframe;
    view.cutLines = settings.cutLines;
    view.field.choice = settings.field;
    view.section = settings.section;
    view.hardEdges = settings.hardEdges;
    const std::vector<Blade> way = busy.stroke().wayAhead();
    if (!way.empty() && !view.bladeBody && !view.bladeForce) {
        view.blade = way.back();  // where the hand leads it
    }
    view.look = look(scene.document());
    if (!settings.colors.showOwn()) {
        view.paint.reset();
    }
    view.pieces = looksOf(bounds);
    if (settings.apart > 0) {
        view.focus = shownBounds(bounds, view.pieces);
    } else {
        addOverlays(settings.overlays, scene.simulation(), view);
        view.marks = scene.readout().marks(settings.overlays.faults, loads.shown());
        const auto piece = static_cast<std::size_t>(pieces.selected);
        if (settings.overlays.boxes) {
            view.pieceBoxes = bounds;
        } else if (piece < bounds.size()) {
            view.pieceBoxes = {bounds[piece]};
        }
    }
    return view;
}

Bounds BodyDisplay::boundsOf(const BusyScene& scene) const {
    const std::vector<Bounds>& bounds = scene.pieceBounds();
    return settings.apart > 0 ? shownBounds(bounds, looksOf(bounds)) : scene.bounds();
}

Bounds BodyDisplay::boundsOf(const BusyScene& scene, int piece) const {
    const std::vector<Bounds>& bounds = scene.pieceBounds();
    const auto index = static_cast<std::size_t>(piece);
    if (piece < 0 || index >= bounds.size()) {
        return {};
    }
    const std::vector<render::PieceLook> looks = looksOf(bounds);
    return looks.empty() ? bounds[index] : shifted(bounds[index], looks[index].shift);
}

render::BodyLook BodyDisplay::look(const Document& document) const {
    return render::colored(ownLook(document), settings.colors);
}

/// The look of each piece; empty where all look as always.
std::vector<render::PieceLook> BodyDisplay::looksOf(const std::vector<Bounds>& bounds) const {
    const bool plain = pieces.hovered < 0 && settings.apart == 0 &&
                       std::ranges::count(own_, ShownPiece{}) == std::ssize(own_);
    std::vector<render::PieceLook> looks(plain ? 0 : bounds.size());
    if (settings.apart > 0) {
        shiftApart(bounds, settings.apart, looks);
    }
    for (std::size_t p = 0; p < looks.size(); ++p) {
        const ShownPiece own = p < own_.size() ? own_[p] : ShownPiece{};
        looks[p].hidden = own.hidden;
        if (own.color) {
            looks[p].tint = render::toLinear(*own.color);
            looks[p].strength = 1;
        }
    }
    if (pieces.hovered >= 0 && pieces.hovered < static_cast<int>(looks.size())) {
        looks[pieces.hovered].tint = linearOf(ui::pieceColor(pieces.hovered));
        looks[pieces.hovered].strength = kHighlight;
    }
    return looks;
}

void BodyDisplay::select(const std::vector<Load>& rows, int row) {
    const bool any = row >= 0 && row < static_cast<int>(rows.size());
    loads.selected = any ? row : -1;
    selectedLoad_ = any ? std::optional(rows[row]) : std::nullopt;
}

void BodyDisplay::describe(const BusyScene& scene, ui::PanelModel& model) {
    model.display = settings;
    if (!scene) {
        return;
    }
    const render::BodyLook look = render::colored(
        ownLook(scene.document()), {.look = settings.colors.look, .skin = {}, .flesh = {}});
    model.looks.ownSkin = render::toDisplay(look.skin);
    model.looks.ownFlesh = render::toDisplay(look.inner);
    model.looks.hasOwnColors = scene.document().looks.colored();
    const std::vector<Load>& rows = scene.loads();
    loads.hovered = std::min(loads.hovered, static_cast<int>(rows.size()) - 1);
    select(rows, selectedLoad_ ? rowOf(*selectedLoad_, rows) : -1);  // others came or went
    model.body.loads.hovered = loads.hovered;
    model.body.loads.selected = loads.selected;
    model.pieces.hovered = pieces.hovered;
    model.pieces.selected = pieces.selected;
    for (std::size_t p = 0; p < model.pieces.rows.size(); ++p) {
        const ShownPiece own = p < own_.size() ? own_[p] : ShownPiece{};
        model.pieces.rows[p].hidden = own.hidden;
        model.pieces.rows[p].color = own.color;
    }
}

}  // namespace kerf::app
