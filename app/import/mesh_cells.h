#pragma once

#include "app/import/face_soup.h"

namespace kerf::app {

/// What a cell of a mesh of elements is by its corners, which stand in VTK's order.
enum class CellShape {
    leftOut,  ///< points and lines
    polygon,
    strip,
    triangle,
    quad,
    pixel,
    tetrahedron,
    voxel,
    hexahedron,
    wedge,
    pyramid
};

/// The cells of a mesh of elements. Faces of volumes that two of them share are inside; the others
/// are the skin.
class MeshCells {
  public:
    /// The vertices must be in `faces` before the cells that name them.
    explicit MeshCells(FaceSoup& faces) : faces_(faces) {}

    /// Nodes behind the corners, as curved cells have, are left out. Throws InputError if there are
    /// too few, or if there is no such vertex.
    void add(CellShape shape, std::span<const double> nodes);
    /// Moves what is on the surface to the faces. Throws InputError if three volumes share a face.
    void finish(std::vector<std::string>& remarks);

  private:
    struct Side {
        std::array<int, 4> key;      ///< the corners, sorted
        std::array<int, 4> corners;  ///< the last is FaceSoup::kNone in a triangle
        bool ofVolume;
    };

    void requireVertices(std::span<const double> nodes) const;
    bool isInverted(std::span<const double> nodes,
                    const std::vector<std::vector<int>>& sides) const;
    void addSide(std::span<const double> nodes, const std::vector<int>& side, bool inverted,
                 bool ofVolume);
    void keepSkin();

    FaceSoup& faces_;
    std::vector<Side> sides_;
    bool curved_ = false;  ///< whether a cell has more nodes than corners
};

}  // namespace kerf::app
