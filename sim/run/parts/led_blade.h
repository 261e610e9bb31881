#pragma once

#include "sim/contact/blade_body.h"
#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/run/parts/command.h"

namespace kerf {

/// A command to the blade in a step.
using BladeAction = std::variant<MoveBlade, LiftBlade>;

/// Checks a pose. Returns "" or one sentence about what is wrong.
std::string checkBlade(const Blade& blade);

/// The body of a pushing blade, and the resolution of its motion.
struct BladePush {
    BladeSize size;
    double wallEdge = 0;  ///< edge length of walls [m]
    double frontLag = 0;  ///< by how much the front of a cut may lag behind the edge [m]
    int substeps = 1;     ///< of the coming time step
};

/// The commanded blade: its pose, its trail, and its commands for the coming step.
class LedBlade {
  public:
    /// Appends a command.
    void tell(BladeAction action) { coming_.push_back(std::move(action)); }
    /// Takes the commands, from first to last.
    std::vector<BladeAction> takeActions() { return std::exchange(coming_, {}); }
    void forgetActions() { coming_.clear(); }
    const std::vector<BladeAction>& actions() const { return coming_; }
    bool isTold() const { return !coming_.empty(); }

    /// The commanded pose of the blade; none while lifted.
    std::optional<Blade> pose() const;
    /// Its pose after its commands; none if lifted then.
    std::optional<Blade> comingPose() const;
    /// The pose after the coming step, or where it is lifted in it. It must be placed.
    Blade nextPose() const;
    /// How far its ends go in the coming step, at most [m]. It must be placed.
    double comingWay() const;
    /// From the edge to the back, unit; zero while it has no direction. It must be placed.
    const Vec3& back() const { return trail_->back; }
    /// The cutting edge: the pose, unless the material resists the edge. It must be placed.
    const Blade& edge() const { return *edge_; }
    bool isPlaced() const { return trail_.has_value(); }
    bool isAt(const Blade& pose) const;
    /// The cutting edge once the blade is commanded to `to`: its ends follow as if on strings of
    /// the length `lag` [m].
    Blade edgeAt(const Blade& to, double lag) const;
    /// Moves the blade to its commanded pose, and its edge to where it cuts. Its body trails at its
    /// whole `width` [m].
    void moveTo(const Blade& to, double width, const Blade& edge);
    /// Returns whether it was placed.
    bool lift() { return std::exchange(trail_, std::nullopt).has_value(); }

    /// The poses of the blade in the coming step, from its cutting edge on.
    std::vector<Blade> path() const;
    /// Its body at its present pose; none if it has no width yet.
    std::optional<BladeMotion> body(const BladePush& push) const;
    /// Its body in the coming step, up to where it is lifted; none if it has no width yet. It must
    /// be placed. Its body begins behind `front`, the present position of the last cut.
    std::optional<BladeMotion> motion(const BladePush& push,
                                      const std::vector<RungNode>& front) const;

  private:
    double lagOfBody(const BladeTrail& end, const std::vector<RungNode>& front,
                     double frontLag) const;

    BladeTrail trailTo(const Blade& to, double width) const;

    std::optional<BladeTrail> trail_;  ///< since it was placed
    std::optional<Blade> edge_;        ///< where it cuts
    std::vector<BladeAction> coming_;
};

/// Whether a rung has a node in the material.
bool standsInMaterial(const std::vector<RungNode>& rung);

}  // namespace kerf
