#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/contact/blade_body.h"
#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/run/parts/command.h"

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
    const std::vector<BladeAction>& actions() const { return coming_; }
    bool isTold() const { return !coming_.empty(); }

    /// The pose of the blade, as it is led; none while lifted.
    std::optional<Blade> pose() const;
    /// Where it will be after what it was told; none where it is lifted then.
    std::optional<Blade> comingPose() const;
    /// The pose after the coming step, or where it is lifted in that. It must be placed.
    Blade nextPose() const;
    /// From the edge to the back, unit; zero while it has no direction. It must be placed.
    const Vec3& back() const { return course_->back; }
    /// Where its edge cuts: the pose, but where the material holds the edge back. It must be
    /// placed.
    const Blade& edge() const { return *edge_; }
    bool isPlaced() const { return course_.has_value(); }
    bool isAt(const Blade& pose) const;
    /// Where its edge cuts once it is led or placed there and stays behind by `lag` [m]: it goes on
    /// as if on a string of that length, and back before the blade. Its body trails at its whole
    /// `width` [m].
    Blade edgeAt(const Blade& to, double width, double lag) const;
    /// Moves the blade to where it is led or placed, and its edge to where it cuts.
    void moveTo(const Blade& to, double width, const Blade& edge);
    /// Returns whether it was placed.
    bool lift() { return std::exchange(course_, std::nullopt).has_value(); }

    /// The poses through which the blade goes in the coming step, from where its edge cuts.
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

    BladeCourse courseTo(const Blade& to, double width) const;

    std::optional<BladeCourse> course_;  ///< since it was placed
    std::optional<Blade> edge_;          ///< where it cuts
    std::vector<BladeAction> coming_;
};

/// Tells whether a rung has a node in the material, and not all in the air.
bool standsInMaterial(const std::vector<RungNode>& rung);

}  // namespace kerf
