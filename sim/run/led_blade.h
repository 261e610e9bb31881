#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/contact/blade_body.h"
#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/run/command.h"

namespace kerf {

/// An action that a person may tell the blade to take in a step.
using BladeAction = std::variant<MoveBlade, LiftBlade>;

/// Checks where a blade is to lie. Returns "" or one sentence about why it can't.
std::string checkBlade(const Blade& blade);

/// The body with which a blade pushes, and how finely it moves.
struct BladePush {
    BladeSize size;
    double wallEdge = 0;  ///< edge length of walls [m]
    int substeps = 1;     ///< of the coming time step
};

/// The blade as a person leads it: where it is, how it came there, and what it is to do in the
/// coming step.
class LedBlade {
  public:
    /// After what it was told before.
    void tell(BladeAction action) { coming_.push_back(std::move(action)); }
    /// Takes the actions that the blade was told, from first to last.
    std::vector<BladeAction> takeActions() { return std::exchange(coming_, {}); }
    void forgetActions() { coming_.clear(); }
    bool isTold() const { return !coming_.empty(); }

    /// The pose of the blade; none while lifted.
    std::optional<Blade> pose() const;
    bool isPlaced() const { return course_.has_value(); }
    bool isAt(const Blade& pose) const;
    /// Moves the blade to where it is led or placed. Its body trails at its whole `width` [m].
    void moveTo(const Blade& to, double width);
    /// Returns whether it was placed.
    bool lift() { return std::exchange(course_, std::nullopt).has_value(); }

    /// The poses through which the blade goes in the coming step, from where it stands.
    std::vector<Blade> path() const;
    /// Its body where it stands; none where it has not come out.
    std::optional<BladeMotion> body(const BladePush& push) const;
    /// Its body in the coming step, up to where it is lifted; none where it has not come out. It
    /// must be placed. Its body begins behind `front`, the rung where it last cut as that lies now.
    std::optional<BladeMotion> motion(const BladePush& push,
                                      const std::vector<RungNode>& front) const;

  private:
    double lagOfBody(const BladeCourse& end, const std::vector<RungNode>& front,
                     double wallEdge) const;

    std::optional<BladeCourse> course_;  ///< since it was placed
    std::vector<BladeAction> coming_;
};

/// Tells whether a rung has a node in the material, and not all in the air.
bool standsInMaterial(const std::vector<RungNode>& rung);

}  // namespace kerf
