#pragma once

#include <array>
#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// How long edges are about a place of the body at rest: the one answer to how fine the cut is
/// there. Made from the skin when a cutter is made, and never changed: a coarse grid of lengths
/// over the body at rest, filled from the triangles of the skin and smoothly between and inside.
/// (A background grid as of mesh generators, filled by pull and push.)
///
/// What is a share of the local edge length: the gate, the spacing of walls along the front and in
/// depth, what lies near the blade, gaps, and what the clean-up calls short. What is not: the
/// blade's offset and the noise of positions that are rounded, since floats are as coarse as the
/// body is large.
class EdgeLengthField {
  public:
    /// The same everywhere [m].
    explicit EdgeLengthField(double length = 1) : mean_(length) {}
    /// That of the skin, at most a twelfth of the body's diagonal (wallEdgeFor). Where it is nearly
    /// the mean, it is the mean: walls of an even mesh are even. O(triangles).
    static EdgeLengthField ofSkin(const SurfaceMesh& mesh);

    /// Of the whole body [m]: the mean over the skin's edges, at most a twelfth of its diagonal.
    double mean() const { return mean_; }
    /// Everywhere the mean.
    bool isEven() const { return lengths_.empty(); }
    /// At a place of the body at rest [m].
    double localEdgeLength(const Vec3& rest) const;

  private:
    double mean_;
    Bounds box_{};
    double cell_ = 0;
    std::array<int, 3> nodes_{};   ///< of the grid along each axis
    std::vector<double> lengths_;  ///< x first; none where the field is even
};

/// Shares of the way along which a piece of `length` [m] between two places is divided, so that
/// each part is about as long as edges are there: ascending, the last is 1. `from`, `to`: at rest.
std::vector<double> divideByEdgeLength(const EdgeLengthField& field, const Vec3& from,
                                       const Vec3& to, double length);

}  // namespace kerf::cut
