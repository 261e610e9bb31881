#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The target edge length at each place of the body at rest, which defines how fine the cut is
/// there. Made from the skin with the cutter, and constant: a coarse grid of lengths over the body
/// at rest, filled from the triangles of the skin and smoothly between and inside. (A background
/// grid as in mesh generators, filled by pull and push.)
///
/// Relative to it are: the gate, the spacing of walls along the front and in depth, the reach of
/// searches around the blade, gaps, and the short edges of the clean-up. The blade's offset and
/// rounding noise are not, since the spacing of floats depends on the size of the body.
class EdgeLengthField {
  public:
    /// The field of one length everywhere [m].
    explicit EdgeLengthField(double length = 1) : mean_(length) {}
    /// The field of the skin's edge lengths, at most a twelfth of the body's diagonal
    /// (wallEdgeFor). Lengths close to the mean are the mean, so walls of an even mesh are even.
    /// O(triangles).
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

/// How edges of new walls grow from the rim inwards.
struct WallGrading {
    double most = 1;  ///< largest ratio to the local edge length; 1: they do not grow

    /// Whether they grow.
    bool isOn() const { return most > 1; }
    /// The length of an edge `distance` [m] inside from one of length `edge` [m].
    double grown(double edge, double distance) const { return edge + kGrowth * distance; }
    /// How far inside an edge of length `edge` [m] has grown to `longer` [m].
    double wayFrom(double edge, double longer) const { return (longer - edge) / kGrowth; }
    /// The length at `distance` [m] from the rim, where the local edge length is `edge` [m].
    double lengthAt(double edge, double distance) const {
        return std::min(most * edge, grown(edge, distance));
    }

  private:
    static constexpr double kGrowth = 0.25;
};

/// The parameters at which a line of `length` [m] is divided, so that each part has about the
/// length wanted at its parameters, nowhere less than about `least` [m]: ascending, the last is 1.
std::vector<double> divideByLength(double length, double least,
                                   const std::function<double(double)>& wantedLengthAt);

/// The parameters at which a line of `length` [m] between two places is divided, so that each part
/// has about the local edge length: ascending, the last is 1. `from`, `to`: the places at rest.
std::vector<double> divideByEdgeLength(const EdgeLengthField& field, const Vec3& from,
                                       const Vec3& to, double length);

}  // namespace kerf::cut
