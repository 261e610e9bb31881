#pragma once

#include <array>
#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The edge length wanted about each place of the body at rest: the one answer to how fine the cut
/// is there. Made from the skin when a cutter is made, and never changed: a coarse grid of lengths
/// over the body at rest, filled from the triangles of the skin and smoothly between and inside.
/// (A background grid as of mesh generators, filled by pull and push.)
///
/// Shares of the local edge length are: the gate, the spacing of walls along the front and in
/// depth, the reach of looks around the blade, gaps, and the short edges of the clean-up. The
/// blade's offset and the noise of rounded positions are not, since floats are as coarse as the
/// body is large.
class EdgeLengthField {
  public:
    /// The field of one length everywhere [m].
    explicit EdgeLengthField(double length = 1) : mean_(length) {}
    /// The field of the skin's edge lengths, at most a twelfth of the body's diagonal
    /// (wallEdgeFor). Where a length is nearly the mean, it is the mean: walls of an even mesh are
    /// even. O(triangles).
    static EdgeLengthField ofSkin(const SurfaceMesh& mesh);

    /// The edge length of the whole body [m]: the mean over the skin's edges, at most a twelfth of
    /// the body's diagonal.
    double mean() const { return mean_; }
    /// Whether the length is the mean everywhere.
    bool isEven() const { return lengths_.empty(); }
    /// The edge length at a place of the body at rest [m].
    double localEdgeLength(const Vec3& rest) const;

  private:
    double mean_;
    Bounds box_{};
    double cell_ = 0;
    std::array<int, 3> nodes_{};   ///< nodes of the grid along each axis
    std::vector<double> lengths_;  ///< x first; none where the field is even
};

/// The shares of the way at which a line of `length` [m] between two places is divided, so that
/// each part is about as long as edges are there: ascending, the last is 1. `from`, `to`: the
/// places at rest.
std::vector<double> divideByEdgeLength(const EdgeLengthField& field, const Vec3& from,
                                       const Vec3& to, double length);

}  // namespace kerf::cut
