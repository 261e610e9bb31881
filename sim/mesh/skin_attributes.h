#pragma once

#include "sim/base/math.h"
#include "sim/mesh/nearest_triangle.h"

namespace kerf {

class SurfaceMesh;

/// The texture coordinates of the three corners of a triangle; v runs upwards.
using CornerUvs = std::array<Eigen::Vector2f, 3>;
/// Colours of the three corners of a triangle: red, green, blue in linear light, and opacity.
using CornerColors = std::array<Eigen::Vector4f, 3>;

/// The attributes of a skin by triangle. Each list may be empty if there are none.
struct SkinAttributes {
    std::vector<CornerUvs> uvs;
    std::vector<CornerColors> colors;
    std::vector<int> materials;  ///< an index into a list of materials; -1 for none

    bool empty() const { return uvs.empty() && colors.empty() && materials.empty(); }
    bool operator==(const SkinAttributes&) const = default;

    template <class Io>
    void archive(Io& io) {
        io(uvs, colors, materials);
    }
};

/// Attributes of one triangle; zero, white or -1 where the mesh has none.
struct TriangleAttributes {
    CornerUvs uvs;
    CornerColors colors;
    int material = -1;
};
/// Attributes of triangle t.
TriangleAttributes attributesOf(const SkinAttributes& skin, int t);
/// Sets the attributes of a triangle in all lists that are not empty; these must be long enough.
void setAttributes(SkinAttributes& skin, int t, const TriangleAttributes& attributes);
/// Resizes all lists that are not empty; new triangles have no attributes.
void resizeAttributes(SkinAttributes& skin, std::size_t triangles);

/// Transfers the attributes of an uncut skin to meshes that are cut out of it.
class SkinCarrier {
  public:
    /// The attributes `skin` are by triangle slot of `uncut`; both must outlive it.
    SkinCarrier(const SurfaceMesh& uncut, const SkinAttributes& skin);

    /// The attributes of a triangle of skin by its slot and the rest positions of its corners. A
    /// triangle that a cut made gets the material at its centre in the uncut rest shape, and its
    /// corners' attributes at their places, on the centre's side of a seam.
    TriangleAttributes of(int slot, const std::array<Vec3, 3>& corners);

  private:
    /// A place on a triangle of the uncut skin.
    struct SkinPoint {
        int triangle;
        Eigen::Vector3f weights;
    };
    bool isOriginal(int slot, const std::array<Vec3, 3>& corners) const;
    int find(const Vec3& p);
    SkinPoint pointOf(int t, const Vec3& p) const;
    Vec3 planeWeights(int t, const Vec3& p) const;
    int neighbour(int t, int corner) const;

    const SurfaceMesh& mesh_;
    const SkinAttributes& skin_;
    std::optional<NearestTriangle> triangles_;  ///< from the first search on
};

/// The attributes of a body that was cut, by slot of `cut`, from those of the uncut mesh, by slot
/// of `uncut`; see SkinCarrier. Walls and dead slots have none. An empty list stays empty.
SkinAttributes carrySkin(const SurfaceMesh& uncut, const SkinAttributes& skin,
                         const SurfaceMesh& cut);

}  // namespace kerf
