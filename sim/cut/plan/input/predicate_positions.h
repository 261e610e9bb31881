#pragma once

#include "sim/cut/plan/input/step.h"

namespace kerf::cut {

/// The positions at which the predicates see the mesh vertices: the real ones, except that copies
/// may close, retraced slits open, and pinned vertices are seen where they are pinned, such as
/// those of a front node exactly there.
class PredicatePositions {
  public:
    /// The mesh as seen by the step's attempt and opening, without pins.
    explicit PredicatePositions(const StepInput& in);

    /// The position of v, with the pins [m].
    Vec3 at(int v) const;
    /// The position of v, without the pins [m].
    Vec3 withoutPins(int v) const;
    /// From now on v is seen at p.
    void pin(int v, const Vec3& p) { pins_[v] = p; }
    /// From now on v, which lies in the strip, is seen displaced by `way` [m].
    void pinAside(int v, const Vec3& way);
    /// Whether v is seen beside the strip in which it lies.
    bool isAside(int v) const { return asideFrom_.count(v) > 0; }
    /// The position of v, with the pins except those aside [m].
    Vec3 inStrip(int v) const;
    /// The farthest that any vertex was pinned aside [m].
    double asideReach() const { return asideReach_; }

  private:
    const SurfaceMesh& mesh_;
    const SlitOpening* opening_;  ///< null where there is none to see
    double closeDistance_;
    std::map<int, Vec3> pins_;
    std::map<int, Vec3> asideFrom_;  ///< where vertices lie that are pinned aside
    double asideReach_ = 0;
};

}  // namespace kerf::cut
