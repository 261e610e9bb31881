#pragma once

#include <vector>

#include "sim/cut/blade.h"
#include "sim/cut/plan/strip.h"

namespace kerf::cut {

/// Finds where places of the layout plane lie in a strip.
class PlacesInStrip {
  public:
    /// The strip must outlive the object.
    PlacesInStrip(const Blade& blade, const Strip& strip);
    /// The point of the strip there [m]. Throws StepFailure outside.
    Vec3 at(const Vec2& layout) const;

  private:
    const Strip& strip_;
    double room_;
    /// The triangles follow each other along the blade: for each, how far they have come.
    std::vector<double> reachOfTriangle_;
};

}  // namespace kerf::cut
