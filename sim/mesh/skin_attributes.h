#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/base/math.h"
#include "sim/mesh/nearest_triangle.h"

namespace kerf {

class SurfaceMesh;

/// Where the three corners of a triangle lie on a texture; v runs upwards.
using CornerUvs = std::array<Eigen::Vector2f, 3>;
/// Colours of the three corners of a triangle: red, green, blue in linear light, and opacity.
using CornerColors = std::array<Eigen::Vector4f, 3>;

/// What a skin has besides its shape, by triangle. Each list may be empty: there is none of it.
struct SkinAttributes {
    std::vector<CornerUvs> uvs;
    std::vector<CornerColors> colors;
    std::vector<int> materials;  ///< an index into a list of materials; -1 for none

    bool empty() const { return uvs.empty() && colors.empty() && materials.empty(); }
    bool operator==(const SkinAttributes&) const = default;
};

/// Attributes of one triangle; zero, white or -1 where the mesh has none.
struct TriangleAttributes {
    CornerUvs uvs;
    CornerColors colors;
    int material = -1;
};
/// Attributes of triangle t.
TriangleAttributes attributesOf(const SkinAttributes& skin, int t);
/// Gives a triangle its attributes, as far as there are lists, which must be long enough.
void setAttributes(SkinAttributes& skin, int t, const TriangleAttributes& attributes);
/// Gives each list there is so many triangles; new ones have no attributes.
void resizeAttributes(SkinAttributes& skin, std::size_t triangles);

/// Carries the attributes of an uncut skin along to meshes that are cut out of it.
class SkinCarrier {
  public:
    /// The attributes `skin` are by triangle slot of `uncut`; both must stay.
    SkinCarrier(const SurfaceMesh& uncut, const SkinAttributes& skin);

    /// The attributes of a triangle of skin by its slot and where its corners rest. A triangle that
    /// a cut made gets the material of the place where its middle lies in the uncut rest shape, and
    /// what its corners have at their places, on the side of a seam where its middle lies.
    TriangleAttributes of(int slot, const std::array<Vec3, 3>& corners);

  private:
    /// A place on a triangle of the uncut skin.
    struct Place {
        int triangle;
        Eigen::Vector3f weights;
    };
    bool isOriginal(int slot, const std::array<Vec3, 3>& corners) const;
    int find(const Vec3& p);
    Place placeOf(int t, const Vec3& p) const;
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
