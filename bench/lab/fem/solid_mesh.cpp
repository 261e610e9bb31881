#include "bench/lab/fem/solid_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace kerf {

namespace {

using Corners4 = std::array<int, 4>;
using Edge = std::array<int, 2>;

constexpr auto kEdges = SolidMesh::kEdges;

/// The faces of a tetrahedron, outward: three corners, then the middles of 01, 12, 20 of these.
constexpr std::array<std::array<int, 6>, 4> kFaces{
    {{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {2, 0, 3, 6, 7, 9}}};

constexpr double kSamePlane = 1e-9;  // a plane of the grid is one of the slit's borders [m]

/// Tetrahedra of four corners.
struct LinearMesh {
    std::vector<Vec3> nodes;
    std::vector<Corners4> tetrahedra;

    void add(Corners4 corners) {
        const Vec3& apex = nodes[corners[3]];
        const Vec3 a = nodes[corners[0]] - apex;
        const Vec3 b = nodes[corners[1]] - apex;
        const Vec3 c = nodes[corners[2]] - apex;
        if (a.dot(b.cross(c)) > 0) {  // mirrored
            std::swap(corners[2], corners[3]);
        }
        tetrahedra.push_back(corners);
    }
};

/// Gives each edge a node in its middle, one for all tetrahedra around it.
SolidMesh withMiddles(LinearMesh linear) {
    SolidMesh mesh;
    mesh.nodes = std::move(linear.nodes);
    std::map<Edge, int> middles;
    for (const Corners4& corners : linear.tetrahedra) {
        std::array<int, 10>& own = mesh.tetrahedra.emplace_back();
        std::ranges::copy(corners, own.begin());
        for (std::size_t e = 0; e < kEdges.size(); ++e) {
            const int a = corners[kEdges[e][0]];
            const int b = corners[kEdges[e][1]];
            const auto [place, isNew] = middles.try_emplace(Edge{std::min(a, b), std::max(a, b)},
                                                            static_cast<int>(mesh.nodes.size()));
            if (isNew) {
                mesh.nodes.emplace_back(0.5 * (mesh.nodes[a] + mesh.nodes[b]));
            }
            own[4 + e] = place->second;
        }
    }
    return mesh;
}

/// Faces that belong to one tetrahedron alone.
std::vector<std::array<int, 6>> outerFaces(const SolidMesh& mesh) {
    std::map<std::array<int, 3>, std::vector<std::array<int, 6>>> found;
    for (const std::array<int, 10>& nodes : mesh.tetrahedra) {
        for (const std::array<int, 6>& face : kFaces) {
            std::array<int, 6> own{};
            std::ranges::transform(face, own.begin(), [&](int n) { return nodes[n]; });
            std::array<int, 3> key{own[0], own[1], own[2]};
            std::ranges::sort(key);
            found[key].push_back(own);
        }
    }
    std::vector<std::array<int, 6>> outer;
    for (const auto& [key, faces] : found) {
        if (faces.size() == 1) {
            outer.push_back(faces.front());
        }
    }
    return outer;
}

void addSkin(SolidMesh& mesh) {
    for (const auto& [a, b, c, ab, bc, ca] : outerFaces(mesh)) {
        mesh.skin.insert(mesh.skin.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
}

/// The corners of a grid, with two nodes each along a slit.
class GridNodes {
  public:
    /// Puts them into `nodes`, which must outlive this as lines and slit.
    GridNodes(const std::array<GridLines, 3>& lines, const std::optional<Slit>& slit,
              std::vector<Vec3>& nodes)
        : lines_(lines), slit_(slit), nodes_(nodes) {
        for (std::size_t i = 0; i < lines[0].size(); ++i) {
            for (std::size_t j = 0; j < lines[1].size(); ++j) {
                for (std::size_t k = 0; k < lines[2].size(); ++k) {
                    const Vec3 p(lines[0][i], lines[1][j], lines[2][k]);
                    numbers_.push_back(static_cast<int>(nodes_.size()));
                    nodes_.push_back(p);
                    if (isOpen(p)) {
                        nodes_.push_back(p);  // of the side of higher x
                    }
                }
            }
        }
    }

    /// The node at this corner of the grid, as a cell of column `cell` along x has it.
    int at(const std::array<int, 3>& corner, int cell) const {
        const auto& [i, j, k] = corner;
        const std::size_t rows = lines_[1].size();
        const int number = numbers_[(i * rows + j) * lines_[2].size() + k];
        return number + (isOpen(nodes_[number]) && cell >= i ? 1 : 0);
    }

  private:
    bool isOpen(const Vec3& p) const {
        return slit_ && p.x() == slit_->x && p.y() > slit_->bottom + kSamePlane &&
               std::abs(p.z()) < slit_->halfWidth - kSamePlane;
    }

    const std::array<GridLines, 3>& lines_;
    const std::optional<Slit>& slit_;
    std::vector<Vec3>& nodes_;
    std::vector<int> numbers_;  ///< the first node at each corner of the grid
};

/// Kuhn's: from the low corner to the high one, one axis after the other.
void addCell(LinearMesh& mesh, const GridNodes& nodes, const std::array<int, 3>& low) {
    constexpr std::array<std::array<int, 3>, 6> kOrders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (const std::array<int, 3>& order : kOrders) {
        std::array<int, 3> at = low;
        Corners4 corners{nodes.at(at, low[0])};
        for (int n = 0; n < 3; ++n) {
            ++at[order[n]];
            corners[n + 1] = nodes.at(at, low[0]);
        }
        mesh.add(corners);
    }
}

/// Nodes that lie on the slit, one on either side, at one place.
std::vector<std::array<int, 2>> findLips(const SolidMesh& mesh, double x) {
    std::vector<std::array<int, 2>> sides(mesh.nodes.size(), {0, 0});  // tetrahedra on each side
    for (const std::array<int, 10>& nodes : mesh.tetrahedra) {
        double middle = 0;
        for (int corner = 0; corner < 4; ++corner) {
            middle += mesh.nodes[nodes[corner]].x() / 4;
        }
        for (const int n : nodes) {
            ++sides[n][middle > x ? 1 : 0];
        }
    }
    std::map<std::array<double, 2>, std::array<int, 2>> at;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const Vec3& p = mesh.nodes[n];
        const bool isLip = p.x() == x && (sides[n][0] == 0 || sides[n][1] == 0);
        if (isLip) {
            auto& pair = at.try_emplace({p.y(), p.z()}, std::array{-1, -1}).first->second;
            pair[sides[n][0] == 0 ? 1 : 0] = static_cast<int>(n);
        }
    }
    std::vector<std::array<int, 2>> lips;
    lips.reserve(at.size());
    for (const auto& [place, pair] : at) {
        lips.push_back(pair);
    }
    return lips;
}

/// A corner of the triangles of an octahedron's face: steps along the three axes, which add up to
/// `rows`.
using OctahedronCorner = std::array<int, 3>;

/// The nodes of a ball by layer, from the middle outwards.
class BallNodes {
  public:
    /// Puts those that are asked for into `nodes`, which must outlive this.
    BallNodes(double radius, int layers, std::vector<Vec3>& nodes)
        : radius_(radius), layers_(layers), nodes_(nodes) {}

    int at(const OctahedronCorner& corner, int layer) {
        const OctahedronCorner key = layer == 0 ? OctahedronCorner{} : corner;
        const auto [place, isNew] =
            numbers_.try_emplace(std::pair(key, layer), static_cast<int>(nodes_.size()));
        if (isNew) {
            const Vec3 p(key[0], key[1], key[2]);
            nodes_.emplace_back(p.stableNormalized() * (radius_ * layer / layers_));
        }
        return place->second;
    }

  private:
    double radius_;
    int layers_;
    std::vector<Vec3>& nodes_;
    std::map<std::pair<OctahedronCorner, int>, int> numbers_;
};

/// The signs of the axes of a face of an octahedron.
using OctahedronFace = std::array<int, 3>;

std::vector<OctahedronFace> octahedronFaces(bool half) {
    std::vector<OctahedronFace> faces;
    for (const int x : {1, -1}) {
        for (const int y : {1, -1}) {
            for (const int z : {1, -1}) {
                if (x > 0 || !half) {
                    faces.push_back({x, y, z});
                }
            }
        }
    }
    return faces;
}

/// The triangles that a face is divided into.
std::vector<std::array<OctahedronCorner, 3>> trianglesOf(const OctahedronFace& face, int rows) {
    std::vector<std::array<OctahedronCorner, 3>> triangles;
    const auto add = [&](const OctahedronCorner& base, int step) {
        auto& triangle = triangles.emplace_back();
        for (int corner = 0; corner < 3; ++corner) {
            OctahedronCorner at = base;
            at[corner] += step;
            for (int axis = 0; axis < 3; ++axis) {
                triangle[corner][axis] = face[axis] * at[axis];
            }
        }
    };
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; i + j < rows; ++j) {
            const int k = rows - 1 - i - j;
            add({i, j, k}, 1);
            if (k > 0) {  // beside it, upside down
                add({i + 1, j + 1, k}, -1);
            }
        }
    }
    return triangles;
}

/// A wedge under a triangle between two layers as three tetrahedra. Diagonals of its sides start at
/// the lowest corner, so that neighbours fit.
void addWedge(LinearMesh& mesh, BallNodes& nodes, std::array<OctahedronCorner, 3> triangle,
              int layer) {
    std::ranges::sort(triangle);
    const int parts = layer == 0 ? 1 : 3;  // the innermost triangle is the middle of the ball
    for (int turn = 0; turn < parts; ++turn) {
        Corners4 corners{};
        for (int n = 0; n < 4; ++n) {
            corners[n] =
                n <= turn ? nodes.at(triangle[n], layer) : nodes.at(triangle[n - 1], layer + 1);
        }
        mesh.add(corners);
    }
}

}  // namespace

GridLines evenGridLines(double low, double high, int cells) {
    GridLines lines;
    lines.reserve(cells + 1);
    for (int i = 0; i <= cells; ++i) {
        lines.push_back(i == cells ? high : low + (high - low) * i / cells);
    }
    return lines;
}

GridLines gridLinesThrough(double low, double middle, double high, int cells) {
    if (!(low < middle && middle < high)) {
        throw std::invalid_argument("the middle plane of a grid lies outside");
    }
    GridLines lines = evenGridLines(low, middle, cells);
    const int more =
        std::max(1, static_cast<int>(std::lround(cells * (high - middle) / (middle - low))));
    const GridLines rest = evenGridLines(middle, high, more);
    lines.insert(lines.end(), rest.begin() + 1, rest.end());
    return lines;
}

SolidMesh solidBox(const std::array<GridLines, 3>& lines, const std::optional<Slit>& slit) {
    LinearMesh linear;
    const GridNodes nodes(lines, slit, linear.nodes);
    const auto count = [&](int axis) { return static_cast<int>(lines[axis].size()) - 1; };
    for (int i = 0; i < count(0); ++i) {
        for (int j = 0; j < count(1); ++j) {
            for (int k = 0; k < count(2); ++k) {
                addCell(linear, nodes, {i, j, k});
            }
        }
    }
    SolidMesh mesh = withMiddles(std::move(linear));
    addSkin(mesh);
    if (slit) {
        mesh.lips = findLips(mesh, slit->x);
    }
    return mesh;
}

SolidMesh solidBall(double radius, int rows, int layers, bool half) {
    LinearMesh linear;
    BallNodes nodes(radius, layers, linear.nodes);
    for (const OctahedronFace& face : octahedronFaces(half)) {
        for (const auto& triangle : trianglesOf(face, rows)) {
            for (int layer = 0; layer < layers; ++layer) {
                addWedge(linear, nodes, triangle, layer);
            }
        }
    }
    SolidMesh mesh = withMiddles(std::move(linear));
    addSkin(mesh);
    return mesh;
}

}  // namespace kerf
