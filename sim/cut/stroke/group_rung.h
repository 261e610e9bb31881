#pragma once

#include "sim/cut/blade.h"
#include "sim/cut/stroke/cut_body.h"
#include "sim/cut/stroke/stroke.h"

namespace kerf::cut {

/// Whether no node of a rung is in the material.
bool isInAir(const std::vector<RungNode>& rung);

/// Places the rung of one group of pieces and ties it to the skin beside it.
class GroupRung {
  public:
    /// All must outlive the object; `group` is one of the stroke.
    GroupRung(CutBody& body, Stroke& stroke, GroupStroke& group)
        : body_(body), stroke_(stroke), group_(group) {}

    /// Begins a transit, from the air.
    void startTransit();
    /// The initial displacement [m] of a rung at parameter s: otherwise one placed exactly on a
    /// vertex or a face would stay there in every retry.
    Vec3 leastOffsetAt(double s) const;
    /// The node of a rung in the air at parameter s, at the blade.
    RungNode nodeInAir(const Blade& at, double s) const;
    /// Places the rung at a blade as a new transit.
    void place(const Blade& at);
    /// Makes the end of a slit the rung, as a new transit.
    void takeUp(const SlitFront& front, const Blade& at);
    /// Moves a rung in the air with a blade that slides along itself. `from`: the rung, measured
    /// along `to`.
    void slide(const Blade& to, const std::vector<RungNode>& from);
    /// Sets the rung and ties it.
    void set(std::vector<RungNode> next);
    /// Makes the rung of those `nodes` that are not in other groups.
    void keepOwn(std::vector<RungNode> nodes);
    /// Ties the rung to the skin, or postpones it.
    void tie();
    /// Makes the postponed ties, in the rest shape.
    void makeWaitingTies();

  private:
    AirTies tiesIn(SkinShape shape);
    std::function<bool(int)> isOuter() const;

    CutBody& body_;
    Stroke& stroke_;
    GroupStroke& group_;
};

}  // namespace kerf::cut
