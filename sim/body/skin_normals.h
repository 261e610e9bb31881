#pragma once

#include <unordered_map>

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The default angle at rest above which faces of the skin have a hard edge between them [degrees].
inline constexpr double kHardEdgeAngle = 40;

/// The normals of smooth shading of the skin at rest, preserved through cuts: the remaining
/// triangles around a vertex at the border of a wound, or flat triangles around a vertex that a cut
/// put into the middle of one, would give another normal, and the closed cut would show. Where
/// faces meet at more than kHardEdgeAngle, each side of the edge has its own.
class SkinNormals {
  public:
    SkinNormals() = default;
    /// The normals of an uncut body, weighted by the angles of the triangles around each vertex.
    explicit SkinNormals(const SurfaceMesh& uncut);

    /// Follows a step of the cutter: vertices of the skin from `firstNew` on get the shading
    /// normals at their positions on the skin triangles `old`, which the step removed or changed.
    void follow(const SurfaceMesh& mesh, int firstNew, std::span<const Triangle> old);

    /// The normal at a cut, of length 1 + the height of round skin above it [m]; zero for vertices
    /// whose triangles give it: those that no cut made or separated, and those at hard edges.
    Vec3 ofCut(const SurfaceMesh& mesh, int vertex) const;

    /// Writes or reads what cuts have added to those of the uncut body (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(later_, hardLater_);
    }

  private:
    /// A triangle at a hard edge, and the normal of the smooth skin on its side.
    struct Side {
        Vec3 face = Vec3::Zero();
        Vec3 normal = Vec3::Zero();
    };
    using HardVertices = std::unordered_map<int, std::vector<Side>>;
    static std::vector<Side> sidesAround(const SurfaceMesh& mesh, int vertex);

    int uncutVertices() const { return uncut_ ? static_cast<int>(uncut_->size()) : 0; }
    const Vec3& normal(int vertex) const;
    /// The normal of a vertex as a corner of a triangle with this unit normal.
    const Vec3& normal(int vertex, const Vec3& face) const;
    const std::vector<Side>* sidesOf(int vertex) const;

    std::shared_ptr<const std::vector<Vec3>> uncut_;  ///< shared by all copies
    std::shared_ptr<const HardVertices> hardUncut_;   ///< those of them at hard edges
    std::vector<Vec3> later_;                         ///< of the vertices that cuts made
    HardVertices hardLater_;
};

}  // namespace kerf
