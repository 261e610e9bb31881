#include "app/import/repair/thickening.h"

#include <spdlog/fmt/fmt.h>

#include <Eigen/Eigenvalues>

#include "app/import/repair/edge_pairing.h"
#include "sim/base/math.h"
#include "sim/base/text.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/union_find.h"
#include "sim/repair/crossings.h"
#include "sim/repair/soup_editing.h"
#include "sim/repair/soup_inspection.h"

namespace kerf::app {

namespace {

using repair::Side;

constexpr double kProposed = 1.0 / 50;  // of the diagonal
constexpr double kThinnest = 2e-5;      // of the diagonal: floats hold it well
// Of the diagonal: parts that cross with so little are not kept apart by less.
constexpr double kTouching = 1.0 / 400;
constexpr double kFarthest = 2;  // a vertex moves so many halves of the thickness at most
// Directions in which the normals around a vertex vary less than this, squared, count as flat.
constexpr double kBend = 1e-3;
constexpr double kDrawBack = 1e-3;  // fans that meet in a vertex draw back so much of an edge
constexpr std::size_t kMostCrossings = 1'000'000;
constexpr double kSheet = 6;  // squared borders over the area; a square has 16, a hemisphere 6.3

/// What the triangles around a vertex say, each weighed by its angle there.
struct NormalsAround {
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();  ///< of the normals
    Vec3 normals = Vec3::Zero();
    Vec3 ahead = Vec3::Zero();  ///< into the fan
    double weight = 0;
    double shortest = std::numeric_limits<double>::infinity();  ///< edge [m]

    void add(const Corners& at, int corner) {
        const Vec3 first = (at[(corner + 1) % 3] - at[corner]).stableNormalized();
        const Vec3 second = (at[(corner + 2) % 3] - at[corner]).stableNormalized();
        const double angle = std::atan2(first.cross(second).norm(), first.dot(second));
        const Vec3 normal = areaNormal(at).stableNormalized();
        squares += angle * normal * normal.transpose();
        normals += angle * normal;
        ahead += angle * (first + second).stableNormalized();
        weight += angle;
        shortest = std::min(shortest, (at[(corner + 1) % 3] - at[corner]).norm());
    }

    /// Adds those of another fan, turned over where it faces the other way. Returns -1 then,
    /// else 1.
    double add(const NormalsAround& fan) {
        const double sign = normals.dot(fan.normals) < 0 ? -1 : 1;
        squares += fan.squares;
        normals += sign * fan.normals;
        weight += fan.weight;
        shortest = std::min(shortest, fan.shortest);
        return sign;
    }

    /// The way by which all faces move by 1 along their normals, as far as there is one: the least
    /// squares, but along the mean normal where they are nearly flat.
    Vec3 offset() const {
        Vec3 way = normals.stableNormalized();
        const Vec3 missing = (normals - squares * way) / weight;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(squares / weight);
        for (int i = 0; i < 3; ++i) {
            const Vec3 axis = axes.eigenvectors().col(i);
            const double bend = axes.eigenvalues()[i];
            way += bend > kBend ? Vec3(axis.dot(missing) / bend * axis) : Vec3(Vec3::Zero());
        }
        return way.norm() > kFarthest ? Vec3(kFarthest * way.normalized()) : way;
    }
};

/// Adds a triangle with what these corners have.
void add(TriangleSoup& soup, const Triangle& corners, const TriangleAttributes& own,
         const std::array<int, 3>& like) {
    repair::addTriangle(soup, corners,
                        {{own.uvs[like[0]], own.uvs[like[1]], own.uvs[like[2]]},
                         {own.colors[like[0]], own.colors[like[1]], own.colors[like[2]]},
                         own.material});
}

/// With the image half way from the corners of triangle t to its middle: at the border of a sheet
/// it may repeat.
TriangleAttributes insideOf(const TriangleSoup& soup, int t) {
    TriangleAttributes own = attributesOf(soup.skin, t);
    const Eigen::Vector2f middle = (own.uvs[0] + own.uvs[1] + own.uvs[2]) / 3;
    for (Eigen::Vector2f& uv : own.uvs) {
        uv = 0.5F * (uv + middle);
    }
    return own;
}

/// Two digits of it, as people are told it.
double rounded(double thickness) {
    return std::stod(fmt::format("{:.2g}", thickness));
}

/// The sheets of a soup, ready to be given a thickness.
class Sheets {
  public:
    explicit Sheets(const TriangleSoup& welded)
        : soup_(welded), diagonal_(boxOf(welded.positions).diagonal()), problem_(prepare()) {}

    Thickening thicken(TriangleSoup& soup, double wanted) {
        if (!problem_.empty() || sheets_.empty()) {
            return {.problem = problem_};
        }
        const double thinnest = rounded(kThinnest * diagonal_);
        if (wanted != 0 && !(wanted >= thinnest)) {
            return {.problem = fmt::format("a thickness of {:g} is too little for sheets of that "
                                           "size; ask for {:g} or more",
                                           wanted, thinnest)};
        }
        double thickness = wanted != 0 ? wanted : rounded(kProposed * diagonal_);
        std::optional<TriangleSoup> bodies = withThickness(thickness);
        while (!bodies && thickness > thinnest) {
            thickness = rounded(std::min(thickness, diagonal_) / 2);
            bodies = withThickness(thickness);
        }
        if (!bodies) {
            return {.problem =
                        "no thickness does: a sheet passes through itself, or is folded "
                        "onto itself; part it there in a modelling tool"};
        }
        if (wanted != 0 && thickness != wanted) {
            return {.problem = fmt::format("a thickness of {:g} is too much: a sheet would pass "
                                           "through itself or another, or turn over where it is "
                                           "bent; {:g} does",
                                           wanted, thickness)};
        }
        soup = std::move(*bodies);
        return {static_cast<int>(sheets_.size()), thickness, ""};
    }

  private:
    using PartPairs = std::set<std::pair<int, int>>;

    /// The soup with these bodies, or nothing where a triangle turns over or parts cross.
    std::optional<TriangleSoup> withThickness(double thickness) {
        TriangleSoup soup = offset(thickness);
        const auto isBearable = [&](const auto& pair) {
            return pair.first != pair.second && crossAnyway().contains(pair);
        };
        const bool fits = keepsFacing(soup) && std::ranges::all_of(crossingParts(soup), isBearable);
        return fits ? std::optional(std::move(soup)) : std::nullopt;
    }

    std::string prepare() {
        const MeshReport found = inspectTriangles(soup_);
        if (found.openEdges == 0) {
            return "";
        }
        if (found.nonFiniteVertices + found.outOfRangeIndices > 0) {
            return found.problem;
        }
        if (found.nonManifoldEdges > 0) {
            return counted(found.nonManifoldEdges, "edge", "edges") +
                   " with more than two triangles: a sheet that branches there has no two sides to "
                   "be thickened to; remove the extra faces in a modelling tool";
        }
        if (found.degenerateTriangles > 0) {
            return counted(found.degenerateTriangles, "triangle", "triangles") +
                   " without area: such have no side to be thickened to; repair the model too";
        }
        orientAlike(soup_);
        if (inspectTriangles(soup_).misorientedEdges > 0) {
            return "a sheet has one side alone, as a Moebius strip has, so it can't be thickened; "
                   "cut it open across in a modelling tool";
        }
        const std::vector<Triangle> before = soup_.triangles;
        partBranches(soup_);
        findSheets(before);
        return haveOffsets() ? ""
                             : "a triangle is nearly without area: such has no side to be "
                               "thickened to; repair the model too";
    }

    /// Not so where the angles at a vertex are too small for doubles.
    bool haveOffsets() const {
        return std::ranges::all_of(open_, [&](int t) {
            return std::ranges::all_of(soup_.triangles[t],
                                       [&](int v) { return offsets_[v].has_value(); });
        });
    }

    /// `before`: the triangles with the vertices that were parted.
    void findSheets(const std::vector<Triangle>& before) {
        const std::vector<int> parts = repair::partsOf(soup_);
        borders_ = repair::openSides(soup_);
        for (const Side& side : borders_) {
            sheets_.insert(parts[side.triangle()]);
        }
        std::vector<NormalsAround> around(soup_.positions.size());
        std::vector<int> whole(soup_.positions.size());
        for (int t = 0; t < static_cast<int>(parts.size()); ++t) {
            if (sheets_.contains(parts[t])) {
                open_.push_back(t);
                for (int i = 0; i < 3; ++i) {
                    const int v = soup_.triangles[t][i];
                    around[v].add(repair::cornersOf(soup_, t), i);
                    whole[v] = before[t][i];
                }
            }
        }
        findOffsets(around, whole);
    }

    /// Fans that meet in a vertex draw back a little, and get one offset there, so that they don't
    /// cross.
    void findOffsets(const std::vector<NormalsAround>& around, const std::vector<int>& whole) {
        std::vector<NormalsAround> together(around.size());
        std::vector<double> signs;
        for (std::size_t v = 0; v < around.size(); ++v) {
            signs.push_back(together[whole[v]].add(around[v]));
        }
        offsets_.resize(around.size());
        for (std::size_t v = 0; v < around.size(); ++v) {
            const NormalsAround& all = together[whole[v]];
            if (around[v].weight > 0) {
                offsets_[v] = signs[v] * all.offset();
                const bool meets = all.weight > around[v].weight;
                const double back = meets ? kDrawBack * all.shortest : 0;
                soup_.positions[v] += back * around[v].ahead.stableNormalized();
            }
        }
    }

    /// Upper sides in the place of the sheets, then the lower ones, then strips.
    TriangleSoup offset(double thickness) const {
        TriangleSoup soup = soup_;
        std::vector<int> below(soup.positions.size(), -1);
        for (std::size_t v = 0; v < below.size(); ++v) {
            if (offsets_[v]) {
                const Vec3 half = thickness / 2 * *offsets_[v];
                below[v] = static_cast<int>(soup.positions.size());
                soup.positions.emplace_back(soup.positions[v] - half);
                soup.positions[v] += half;
            }
        }
        for (const int t : open_) {
            const auto& [a, b, c] = soup_.triangles[t];
            add(soup, {below[a], below[c], below[b]}, attributesOf(soup_.skin, t), {0, 2, 1});
        }
        for (const Side& side : borders_) {
            const int from = side.halfEdge % 3;
            const int to = (from + 1) % 3;
            const int a = repair::originOf(soup_, side.halfEdge);
            const int b = soup_.triangles[side.triangle()][to];
            const TriangleAttributes own = insideOf(soup_, side.triangle());
            add(soup, {below[a], below[b], b}, own, {from, to, to});
            add(soup, {below[a], b, a}, own, {from, to, from});
        }
        return soup;
    }

    /// Whether the triangles on both sides face as the sheets do.
    bool keepsFacing(const TriangleSoup& soup) const {
        auto below = static_cast<int>(soup_.triangles.size());
        return std::ranges::all_of(open_, [&](int t) {
            const Vec3 normal = areaNormal(repair::cornersOf(soup_, t));
            return normal.dot(areaNormal(repair::cornersOf(soup, t))) > 0 &&
                   normal.dot(areaNormal(repair::cornersOf(soup, below++))) < 0;
        });
    }

    /// Parts of which one is a sheet that pass through each other, or through themselves. Their
    /// numbers are the same whatever the thickness.
    PartPairs crossingParts(const TriangleSoup& soup) const {
        const std::vector<int> parts = repair::partsOf(soup);
        PartPairs pairs;
        for (const auto& [a, b] : repair::findCrossings(soup, kMostCrossings)) {
            if (sheets_.contains(parts[a]) || sheets_.contains(parts[b])) {
                pairs.insert(std::minmax(parts[a], parts[b]));
            }
        }
        return pairs;
    }

    /// Those that nearly touch, which no thickness is to keep apart.
    const PartPairs& crossAnyway() {
        if (!crossAnyway_) {
            crossAnyway_ = crossingParts(offset(kTouching * diagonal_));
        }
        return *crossAnyway_;
    }

    TriangleSoup soup_;  ///< oriented, its fans parted
    double diagonal_;
    std::vector<Side> borders_;
    std::set<int> sheets_;                      ///< the parts that have borders
    std::vector<int> open_;                     ///< their triangles
    std::vector<std::optional<Vec3>> offsets_;  ///< by vertex of a sheet: for half a thickness of 1
    std::optional<PartPairs> crossAnyway_;
    std::string problem_;  ///< why no thickness does; set last
};

}  // namespace

Thickening thicken(TriangleSoup& soup, double thickness) {
    return Sheets(soup).thicken(soup, thickness);
}

bool isSheet(const TriangleSoup& soup) {
    const std::vector<Side> borders = repair::openSides(soup);
    UnionFind loops(soup.positions.size());
    for (const Side& side : borders) {
        loops.join(side.low, side.high);
    }
    std::vector<double> lengths(soup.positions.size(), 0);
    for (const Side& side : borders) {
        lengths[loops.root(side.low)] +=
            (soup.positions[side.high] - soup.positions[side.low]).norm();
    }
    double squares = 0;
    for (const double length : lengths) {
        squares += length * length;
    }
    double area = 0;
    for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        area += triangleArea(repair::cornersOf(soup, t));
    }
    return squares > kSheet * area;
}

}  // namespace kerf::app
