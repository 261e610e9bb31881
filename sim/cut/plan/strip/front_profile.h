#pragma once

#include "sim/cut/blade.h"
#include "sim/cut/plan/strip/strip.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

/// The old rung as a height profile over the blade, in the plane of the strip. Triangles under it
/// meet the strip, which is above, only in its nodes and front edges: so walls behind the front are
/// excluded once, not for each triangle of the strip.
class FrontProfile {
  public:
    /// Takes the profile of the strip's old rung. Nothing counts as behind if that rung is not
    /// monotonic along the blade, or if the strip goes back under it.
    FrontProfile(const Blade& blade, const Strip& strip);

    /// Whether a triangle of the mesh with these corners, as the predicates see it, is under the
    /// rung, apart from corners on it.
    bool isBehind(const Triangle& ids, const Corners& at) const;

  private:
    Vec2 flat(const Vec3& p) const { return {along_.dot(p), ahead_.dot(p)}; }
    int firstFrom(double x) const;
    bool runsOn() const;
    bool isUnder(const StripEdge& edge) const;
    bool isUnderLine(int node, const Vec2& end) const;
    bool isSeenAt(int node, int vertex, const Vec3& at) const;
    double heightAt(double x, int next) const;

    const Strip& strip_;
    Vec3 along_;
    Vec3 ahead_;
    double room_ = 0;          ///< far more than the rounding of a height
    std::vector<Vec2> front_;  ///< the nodes of the old rung; empty where nothing is behind
    double nodesPerLength_ = 0;
    double highest_ = -1e300;  ///< height of the highest node
};

}  // namespace kerf::cut
