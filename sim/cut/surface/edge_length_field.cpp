#include "sim/cut/surface/edge_length_field.h"

#include "sim/cut/wall_copies.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

constexpr double kEdgeSquareOfArea = 2.309401076758503;  // of an equilateral triangle
constexpr double kCellsPerDiagonal = 32;
// Lengths up to the first factor from the mean count as the mean, beyond the second as they are.
constexpr double kEven = 1.5;
constexpr double kUneven = 2;
// A piece is looked at in so many places for each edge of its start, at most so many in all.
constexpr double kLooksPerEdge = 2;
constexpr int kMostLooks = 256;

using Counts = std::array<int, 3>;

std::size_t placeOf(const Counts& counts, int i, int j, int k) {
    return (static_cast<std::size_t>(k) * counts[1] + j) * counts[0] + i;
}

struct Weighted {
    double sum = 0;  ///< of logarithms
    double weight = 0;
};

struct Grid {
    Counts counts;
    std::vector<Weighted> nodes;
    explicit Grid(const Counts& c)
        : counts(c), nodes(static_cast<std::size_t>(c[0]) * c[1] * c[2]) {}
    Weighted& at(int i, int j, int k) { return nodes[placeOf(counts, i, j, k)]; }
    const Weighted& at(int i, int j, int k) const { return nodes[placeOf(counts, i, j, k)]; }
};

/// Where a place lies in a grid: the lowest node of its cell, and shares of the way to the next.
struct CellPosition {
    Counts node;
    Vec3 part;
};

CellPosition cellPosition(const Vec3& p, const Vec3& low, double cell, const Counts& counts) {
    CellPosition place{};
    for (int axis = 0; axis < 3; ++axis) {
        const double x = std::clamp((p[axis] - low[axis]) / cell, 0.0, counts[axis] - 1.0);
        place.node[axis] = std::clamp(static_cast<int>(x), 0, std::max(0, counts[axis] - 2));
        place.part[axis] = x - place.node[axis];
    }
    return place;
}

template <class Visit>
void forEachNode(const Counts& counts, Visit&& visit) {
    for (int k = 0; k < counts[2]; ++k) {
        for (int j = 0; j < counts[1]; ++j) {
            for (int i = 0; i < counts[0]; ++i) {
                visit(i, j, k);
            }
        }
    }
}

Grid halved(const Grid& fine) {
    Grid coarse({(fine.counts[0] + 1) / 2, (fine.counts[1] + 1) / 2, (fine.counts[2] + 1) / 2});
    forEachNode(fine.counts, [&](int i, int j, int k) {
        Weighted& to = coarse.at(i / 2, j / 2, k / 2);
        to.sum += fine.at(i, j, k).sum;
        to.weight += fine.at(i, j, k).weight;
    });
    return coarse;
}

/// Of a node of a grid twice as fine: between the nodes of the coarse one that lie around it.
double between(const Grid& coarse, int i, int j, int k) {
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const auto aside = [&](int n, int bit, int axis) {
            const int other = n % 2 == 0 ? n / 2 - 1 : n / 2 + 1;
            const bool away = (corner >> bit & 1) != 0;
            return std::clamp(away ? other : n / 2, 0, coarse.counts[axis] - 1);
        };
        const auto share = [&](int bit) { return (corner >> bit & 1) != 0 ? 0.25 : 0.75; };
        const Weighted& node = coarse.at(aside(i, 0, 0), aside(j, 1, 1), aside(k, 2, 2));
        sum += share(0) * share(1) * share(2) * node.sum;
    }
    return sum;
}

/// Turns sums into means; where there is little weight, what lies around decides (pull and push,
/// Gortler et al. 1996). `full`: the weight of a node that knows for itself.
void fill(Grid& grid, double full) {
    if (grid.nodes.size() == 1) {
        grid.nodes[0].sum /= grid.nodes[0].weight;
        return;
    }
    Grid coarse = halved(grid);
    fill(coarse, full);
    forEachNode(grid.counts, [&](int i, int j, int k) {
        Weighted& node = grid.at(i, j, k);
        const double own = node.weight > 0 ? node.sum / node.weight : 0;
        const double share = std::min(1.0, node.weight / full);
        node.sum = share * own + (1 - share) * between(coarse, i, j, k);
    });
}

/// `length` as the walls see it: the mean where it is near.
double evened(double length, double mean) {
    const double away = std::fabs(std::log(length / mean));
    const double x = (away - std::log(kEven)) / (std::log(kUneven) - std::log(kEven));
    const double t = std::clamp(x, 0.0, 1.0);
    return t == 0 ? mean : mean * std::pow(length / mean, t * t * (3 - 2 * t));
}

struct SkinTriangle {
    Vec3 middle;
    double edge;  ///< of the equilateral triangle of this area: thin ones make no long walls
    double area;
};

struct Skin {
    std::vector<SkinTriangle> triangles;
    Bounds box{};
    double mean = 0;
    double area = 0;
};

Skin skinOf(const SurfaceMesh& mesh) {
    Skin skin;
    double sum = 0;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (!mesh.alive(t) || mesh.kind(t) != SurfaceKind::skin) {
            continue;
        }
        const Vec3& a = mesh.restPosition(mesh.triangle(t)[0]);
        const Vec3& b = mesh.restPosition(mesh.triangle(t)[1]);
        const Vec3& c = mesh.restPosition(mesh.triangle(t)[2]);
        for (const double edge : {(b - a).norm(), (c - b).norm(), (a - c).norm()}) {
            sum += edge;
        }
        const double area = triangleArea(a, b, c);
        skin.triangles.push_back({(a + b + c) / 3, std::sqrt(area * kEdgeSquareOfArea), area});
        skin.area += area;
        for (const Vec3& p : {a, b, c}) {
            skin.box.add(p);
        }
    }
    skin.mean =
        skin.triangles.empty() ? 0 : sum / (3.0 * static_cast<double>(skin.triangles.size()));
    return skin;
}

}  // namespace

EdgeLengthField EdgeLengthField::ofSkin(const SurfaceMesh& mesh) {
    const Skin skin = skinOf(mesh);
    if (skin.triangles.empty()) {
        return EdgeLengthField(1);
    }
    const double diagonal = skin.box.diagonal();
    EdgeLengthField field(wallEdgeFor(skin.mean, diagonal));
    field.box_ = skin.box;
    field.cell_ = diagonal / kCellsPerDiagonal;
    const Vec3 extent = skin.box.high - skin.box.low;
    for (int axis = 0; axis < 3; ++axis) {
        field.nodes_[axis] = static_cast<int>(std::ceil(extent[axis] / field.cell_)) + 1;
    }
    Grid grid(field.nodes_);
    for (const SkinTriangle& t : skin.triangles) {
        if (!(t.area > 0)) {
            continue;
        }
        const CellPosition place =
            cellPosition(t.middle, field.box_.low, field.cell_, field.nodes_);
        const auto nearest = [&](int axis) {
            const int n = place.node[axis] + (place.part[axis] > 0.5 ? 1 : 0);
            return std::min(n, field.nodes_[axis] - 1);
        };
        Weighted& node = grid.at(nearest(0), nearest(1), nearest(2));
        node.sum += t.area * std::log(t.edge);
        node.weight += t.area;
    }
    fill(grid, field.cell_ * field.cell_);
    bool even = true;
    for (const Weighted& node : grid.nodes) {
        const double length = wallEdgeFor(std::exp(node.sum), diagonal);
        field.lengths_.push_back(evened(length, field.mean_));
        even = even && field.lengths_.back() == field.mean_;
    }
    if (even) {
        field.lengths_.clear();
    }
    return field;
}

double EdgeLengthField::localEdgeLength(const Vec3& rest) const {
    if (isEven()) {
        return mean_;
    }
    const CellPosition place = cellPosition(rest, box_.low, cell_, nodes_);
    const auto at = [&](int i, int j, int k) {
        return lengths_[placeOf(nodes_, std::min(place.node[0] + i, nodes_[0] - 1),
                                std::min(place.node[1] + j, nodes_[1] - 1),
                                std::min(place.node[2] + k, nodes_[2] - 1))];
    };
    // std::lerp is exact between equal ends.
    const auto alongX = [&](int j, int k) {
        return std::lerp(at(0, j, k), at(1, j, k), place.part[0]);
    };
    const auto alongY = [&](int k) { return std::lerp(alongX(0, k), alongX(1, k), place.part[1]); };
    return std::lerp(alongY(0), alongY(1), place.part[2]);
}

namespace {

std::vector<double> divide(double length, int looks,
                           const std::function<double(double)>& wantedLengthAt) {
    // How many edges fit into the piece up to each place.
    std::array<double, kMostLooks + 1> edges;
    edges[0] = 0;
    double before = wantedLengthAt(0);
    for (int i = 1; i <= looks; ++i) {
        const double here = wantedLengthAt(i / static_cast<double>(looks));
        edges[i] = edges[i - 1] + 0.5 * (1 / before + 1 / here) * length / looks;
        before = here;
    }
    const double all = edges[looks];
    const int parts = std::max(1, static_cast<int>(std::lround(all)));
    std::vector<double> shares;
    shares.reserve(parts);
    int next = 1;
    for (int k = 1; k < parts; ++k) {
        const double wanted = all * k / parts;
        while (edges[next] < wanted && next < looks) {
            ++next;
        }
        const double within = (wanted - edges[next - 1]) / (edges[next] - edges[next - 1]);
        shares.push_back((next - 1 + within) / looks);
    }
    shares.push_back(1);
    return shares;
}

int looksFor(double length, double first) {
    return std::clamp(static_cast<int>(std::ceil(kLooksPerEdge * length / first)), 2, kMostLooks);
}

}  // namespace

std::vector<double> divideByLength(double length, double least,
                                   const std::function<double(double)>& wantedLengthAt) {
    return divide(length, looksFor(length, least), wantedLengthAt);
}

std::vector<double> divideByEdgeLength(const EdgeLengthField& field, const Vec3& from,
                                       const Vec3& to, double length) {
    const int looks = field.isEven() ? 1 : looksFor(length, field.localEdgeLength(from));
    return divide(length, looks,
                  [&](double share) { return field.localEdgeLength(from + (to - from) * share); });
}

}  // namespace kerf::cut
