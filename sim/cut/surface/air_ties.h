#pragma once

#include "sim/cut/cut_types.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// A point of the rung in the air that moves with the skin beside it.
struct CarriedPoint {
    Vec3 position = Vec3::Zero();  ///< [m]
    Vec3 outward = Vec3::Zero();   ///< normal of that skin; zero where there is none near
};

/// The shape of the body in which a rung is tied.
enum class SkinShape { current, rest };

/// Ties the rung's edges in the air to the skin beside them. The skin moves between two steps of
/// the blade, and material behind the rung is never cut: where skin crossed an edge fixed in space,
/// a bridge would stay.
class AirTies {
  public:
    /// Holds nothing.
    AirTies() = default;
    /// Stores points on the edges of `rung` in the air relative to the skin. Edges between two mesh
    /// vertices are omitted: there the front crosses an older slit. `isSkin` selects triangles: the
    /// piece's, without the walls of the stroke. `finder` finds them in the shape `shape`. `h`:
    /// edge length about the rung [m].
    AirTies(const SurfaceMesh& mesh, TriangleFinder& finder, const std::function<bool(int)>& isSkin,
            double h, const std::vector<RungNode>& rung, SkinShape shape);

    /// Moves the ends of the same rung that are in the air with the skin. No triangle may have been
    /// removed since.
    void follow(const SurfaceMesh& mesh, std::vector<RungNode>& rung) const;
    /// Appends the vertices of the skin to which the rung is tied.
    void addVertices(std::vector<int>& vertices) const;
    /// The present tied points between rung node `index` and the next.
    std::vector<CarriedPoint> between(const SurfaceMesh& mesh, int index) const;
    /// The ties between the rung's nodes `first` and `last`, for a rung in which `first` is node
    /// `at`.
    AirTies part(int first, int last, int at) const;

  private:
    struct Tie {
        int edge;     ///< edge of the rung, by its first node
        double part;  ///< parameter along that edge; 0 and 1 are nodes
        Triangle corners;
        Vec3 weights;
        Vec3 point;
        Vec3 onSkin;
        double share;  ///< share of the skin's movement that the point follows
    };
    static CarriedPoint carried(const SurfaceMesh& mesh, const Tie& tie);

    std::vector<Tie> ties_;
};

}  // namespace kerf::cut
