#include "app/import/mesh_cells.h"

#include "app/files/io/errors.h"

namespace kerf::app {
namespace {

using Sides = std::vector<std::vector<int>>;

/// The sides of a cell, seen from outside; of a flat one itself.
struct CellKind {
    std::size_t corners;
    Sides sides;
};

const CellKind& kindOf(CellShape shape) {
    static const std::map<CellShape, CellKind> kinds{
        {CellShape::triangle, {3, {{0, 1, 2}}}},
        {CellShape::quad, {4, {{0, 1, 2, 3}}}},
        {CellShape::pixel, {4, {{0, 1, 3, 2}}}},
        {CellShape::tetrahedron, {4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}}},
        {CellShape::voxel,
         {8, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}}},
        {CellShape::hexahedron,
         {8, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 4, 7, 3}, {1, 2, 6, 5}}}},
        {CellShape::wedge, {6, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}}},
        {CellShape::pyramid, {5, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}}}};
    return kinds.at(shape);
}

}  // namespace

void MeshCells::add(CellShape shape, std::span<const double> nodes) {
    requireVertices(nodes);
    if (shape == CellShape::leftOut) {
        return;
    }
    if (shape == CellShape::strip) {
        faces_.addStrips({nodes.begin(), nodes.end()});
    } else if (shape == CellShape::polygon) {
        for (const double node : nodes) {
            faces_.addCorner(static_cast<int>(node));
        }
        faces_.endFace();
    } else {
        const auto& [corners, sides] = kindOf(shape);
        if (nodes.size() < corners) {
            throw InputError("a cell has " + std::to_string(nodes.size()) +
                             " corners, and its kind needs " + std::to_string(corners));
        }
        curved_ |= nodes.size() > corners;
        const bool ofVolume = sides.size() > 1;
        const bool inverted = ofVolume && isInverted(nodes, sides);
        for (const std::vector<int>& side : sides) {
            addSide(nodes, side, inverted, ofVolume);
        }
    }
}

void MeshCells::requireVertices(std::span<const double> nodes) const {
    for (const double node : nodes) {
        if (cornerOf(node) < 0 || node >= static_cast<double>(faces_.positions.size())) {
            throw InputError("a cell names vertex " + std::to_string(cornerOf(node)) +
                             ", counted from 0, and there are " +
                             std::to_string(faces_.positions.size()));
        }
    }
}

/// Programs differ in the order of corners.
bool MeshCells::isInverted(std::span<const double> nodes, const Sides& sides) const {
    const auto at = [&](int corner) -> const Vec3& {
        return faces_.positions[static_cast<std::size_t>(nodes[corner])];
    };
    const Vec3& from = at(0);
    double volume = 0;
    for (const std::vector<int>& side : sides) {
        for (std::size_t i = 2; i < side.size(); ++i) {
            volume += (at(side[0]) - from).dot((at(side[i - 1]) - from).cross(at(side[i]) - from));
        }
    }
    return volume < 0;
}

/// A cell whose corners coincide, such as a wedge among hexahedra, has sides that do.
void MeshCells::addSide(std::span<const double> nodes, const std::vector<int>& side, bool inverted,
                        bool ofVolume) {
    std::vector<int> corners;
    for (const int corner : side) {
        const int vertex = static_cast<int>(nodes[corner]);
        if (std::ranges::find(corners, vertex) == corners.end()) {
            corners.push_back(vertex);
        }
    }
    if (corners.size() < 3) {
        return;
    }
    if (inverted) {
        std::ranges::reverse(corners);
    }
    Side added{{}, {0, 0, 0, FaceSoup::kNone}, ofVolume};
    std::ranges::copy(corners, added.corners.begin());
    added.key = added.corners;
    std::ranges::sort(added.key);
    sides_.push_back(added);
}

/// Surfaces on those of volumes only mark them, as in files of Gmsh.
void MeshCells::keepSkin() {
    std::ranges::sort(sides_, [](const Side& a, const Side& b) {
        return std::tie(a.key, b.ofVolume) < std::tie(b.key, a.ofVolume);
    });
    std::vector<Side> kept;
    for (auto first = sides_.begin(); first != sides_.end();) {
        const auto end = std::find_if(first, sides_.end(),
                                      [&](const Side& side) { return side.key != first->key; });
        const auto volumes = std::count_if(first, end, [](const Side& s) { return s.ofVolume; });
        if (volumes > 2) {
            throw InputError(std::to_string(volumes) +
                             " of its volume cells share a face, so they overlap");
        }
        if (volumes < 2) {
            kept.insert(kept.end(), first, volumes == 1 ? std::next(first) : end);
        }
        first = end;
    }
    sides_ = std::move(kept);
}

void MeshCells::finish(std::vector<std::string>& remarks) {
    if (curved_) {
        remarks.emplace_back("Its curved cells are flat here: only their corners were read.");
    }
    if (std::ranges::any_of(sides_, [](const Side& side) { return side.ofVolume; })) {
        keepSkin();
    }
    for (const Side& side : sides_) {
        for (const int corner : side.corners) {
            if (corner != FaceSoup::kNone) {
                faces_.addCorner(corner);
            }
        }
        faces_.endFace();
    }
}

}  // namespace kerf::app
