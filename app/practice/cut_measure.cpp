#include "app/practice/cut_measure.h"

#include "app/practice/hand_path.h"
#include "sim/base/math.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/piece_figures.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/winding.h"

namespace kerf::app {

namespace {

constexpr double kParts = 400;    // of a line
constexpr double kAtEnd = 0.6;    // of the last part: so near to its middle is not beyond its end
constexpr double kFinest = 1e-4;  // part of a line, of the body's diagonal
constexpr double kBelow = 0.5;    // cosine: skin that faces `into` by more is on the far side
constexpr int kGrid = 8;          // points along an edge of a wall, for margins
constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::vector<int> trianglesOf(int model, const SurfaceMesh& mesh, std::span<const int> members) {
    std::vector<int> triangles = livingTriangles(mesh);
    std::erase_if(triangles, [&](int t) { return members[t] != model; });
    return triangles;
}

bool isBladeWall(const SurfaceMesh& mesh, int t) {
    return mesh.kind(t) == SurfaceKind::wall &&
           std::ranges::none_of(mesh.triangle(t), [&](int v) { return mesh.isTorn(v); });
}

/// Whether a half-edge of a wall lies in the skin.
bool isRim(const SurfaceMesh& mesh, int h) {
    return mesh.kind(SurfaceMesh::triangleOf(mesh.twin(h))) == SurfaceKind::skin;
}

/// Whether a blade or a tear left a wall on a model.
bool isHarmed(const TaskBody& body, int model) {
    return std::ranges::any_of(trianglesOf(model, body.mesh, body.members),
                               [&](int t) { return body.mesh.kind(t) == SurfaceKind::wall; });
}

/// A short part of a line as it is seen along `into`, and what was cut there.
struct LinePart {
    Vec3 middle;
    Vec3 way;
    double toEnd;               ///< of the line, the nearer one; infinite where it is closed [m]
    Statistics deviation = {};  ///< of rims [m]
    Statistics height = {};     ///< of walls, along `into` [m]
};

/// The lines of a task as they are seen along `into`.
struct TaskLines {
    explicit TaskLines(const TaskBody& body)
        : into(body.task.into.stableNormalized()), reach(body.task.reach) {
        const double finest = kFinest * boxOf(body.uncut.restPositions()).diagonal();
        for (const TaskLine& line : body.task.lines) {
            Curve curve;  // by its length
            for (std::size_t i = 0; i < line.points.size() + (line.closed ? 1 : 0); ++i) {
                const Vec3 x = flat(line.points[i % line.points.size()]);
                curve.add(i == 0 ? 0 : curve.at.back() + (x - curve.points.back()).norm(), x);
            }
            const double length =
                curve.span() / std::clamp(std::floor(curve.span() / finest), 1.0, kParts);
            for (double at = length / 2; at < curve.span(); at += length) {
                parts.push_back({curve(at), curve(at + length / 2) - curve(at - length / 2),
                                 line.closed ? kInfinite : std::min(at, curve.span() - at)});
            }
            step = std::min(step, std::max(length, finest) / 2);
        }
    }

    Vec3 flat(const Vec3& x) const { return x - x.dot(into) * into; }
    /// The distance from the nearest part [m]; none beyond an end of a line, or out of reach.
    std::optional<double> deviation(const Vec3& point, const LinePart& part) const {
        const Vec3 x = flat(point) - part.middle;
        const double beyond = std::abs(x.dot(part.way)) - kAtEnd * part.way.squaredNorm();
        const double distance = distanceToSegment(x, -part.way / 2, part.way / 2);
        const bool isOf = distance <= reach && (beyond <= 0 || part.toEnd > part.way.norm());
        return isOf ? std::optional(distance) : std::nullopt;
    }
    LinePart& nearest(const Vec3& point) {
        return *std::ranges::min_element(parts, {}, [x = flat(point)](const LinePart& part) {
            return (x - part.middle).squaredNorm();
        });
    }

    Vec3 into;  ///< unit
    double reach;
    double step = kInfinite;  ///< shorter than any part [m]
    std::vector<LinePart> parts;
};

/// Compares an edge of a wall with the lines, in short steps. Returns how much of a
/// rim on the side that is cut into is elsewhere [m].
double addEdge(const SurfaceMesh& mesh, int h, TaskLines& lines) {
    const Vec3& from = mesh.restPosition(mesh.origin(h));
    const Vec3 way = mesh.restPosition(mesh.target(h)) - from;
    const bool inSkin = isRim(mesh, h);
    const Corners skin = restCornersOf(mesh, SurfaceMesh::triangleOf(mesh.twin(h)));
    const bool isAbove = inSkin && areaNormal(skin).stableNormalized().dot(lines.into) < kBelow;
    const double steps = std::ceil(way.norm() / lines.step);
    double over = 0;
    for (double k = 0.5; k < steps; ++k) {
        const Vec3 x = from + k / steps * way;
        LinePart& part = lines.nearest(x);
        const std::optional<double> deviation = lines.deviation(x, part);
        if (deviation) {
            part.height.add(x.dot(lines.into));
        }
        if (deviation && inSkin) {
            part.deviation.add(*deviation);
        }
        over += !deviation && isAbove ? way.norm() / steps : 0;
    }
    return over;
}

void measureLines(const TaskBody& body, CutScore& score) {
    const Task& task = body.task;
    TaskLines lines(body);
    score.lengthOver = score.lengthUnder = 0;
    for (const int t : trianglesOf(task.model, body.mesh, body.members)) {
        const bool isMeant = isBladeWall(body.mesh, t) && body.mesh.wallLabel(t) % 2 == 0;
        for (int h = 3 * t; isMeant && h < 3 * t + 3; ++h) {  // of W+: W- has the same edges
            *score.lengthOver += addEdge(body.mesh, h, lines);
        }
    }
    Statistics deviation;
    Statistics depth;
    Statistics inBand;
    for (const LinePart& part : lines.parts) {
        const double length = part.way.norm();
        if (!part.deviation.most) {
            *score.lengthUnder += length;
            continue;
        }
        deviation.add(*part.deviation.most, length);
        if (task.depth && part.toEnd >= *task.depth) {  // nearer to an end a blade goes in
            const double below = *part.height.most - *part.height.least;
            depth.add(below, length);
            inBand.add(std::abs(below - *task.depth) <= task.band ? 1 : 0, length);
        }
    }
    score.deviationMean = deviation.mean;
    score.deviationMax = deviation.most;
    score.depthMean = depth.mean;
    score.depthInBand = inBand.mean;
}

/// What margins are measured from: walls of blades on what is not spared.
struct SparingWalls {
    explicit SparingWalls(const TaskBody& body) {
        for (const int t : livingTriangles(body.mesh)) {
            if (isBladeWall(body.mesh, t) &&
                std::ranges::count(body.task.spare, body.members[t]) == 0) {
                walls.push_back(restCornersOf(body.mesh, t));
                addPoints(walls.back());
            }
        }
    }

    /// The distance from a model at rest [m].
    Statistics marginTo(const std::vector<int>& model, const SurfaceMesh& uncut) const {
        const auto corners = [&](int t) { return restCornersOf(uncut, t); };
        NearestTriangle surface(model, corners);
        Statistics margin;
        for (const Vec3& p : points) {
            margin.add((surface.closestPoint(p) - p).norm());
        }
        return margin;
    }
    /// The distance from a region [m], negative inside.
    Statistics marginTo(const Ball& ball) const {
        Statistics margin;
        for (const Corners& wall : walls) {
            margin.add((closestOn(wall, ball.center) - ball.center).norm() - ball.radius);
        }
        return margin;
    }
    Statistics marginTo(const Bounds& box) const {
        Statistics margin;
        for (const Vec3& p : points) {
            const Vec3 outside = (box.low - p).cwiseMax(p - box.high);
            margin.add(outside.cwiseMax(0).norm() + std::min(outside.maxCoeff(), 0.0));
        }
        return margin;
    }

    std::vector<Corners> walls;
    std::vector<Vec3> points;  ///< all over them

  private:
    void addPoints(const Corners& at) {
        for (int i = 0; i <= kGrid; ++i) {
            for (int j = 0; i + j <= kGrid; ++j) {
                points.push_back((i * at[0] + j * at[1] + (kGrid - i - j) * at[2]) / kGrid);
            }
        }
    }
};

void measureMargins(const TaskBody& body, CutScore& score) {
    const SparingWalls walls(body);
    Statistics least;
    score.sparedCut = 0;
    const auto add = [&](const Statistics& margin, bool isCut) {
        *score.sparedCut += isCut ? 1 : 0;
        if (isCut || margin.least) {
            least.add(std::min(margin.least.value_or(0), isCut ? 0 : kInfinite));
        }
    };
    for (const int model : body.task.spare) {
        add(walls.marginTo(trianglesOf(model, body.uncut, body.uncutMembers), body.uncut),
            isHarmed(body, model));
    }
    for (const Region& region : body.task.spareRegions) {
        const Statistics margin =
            std::visit([&](const auto& shape) { return walls.marginTo(shape); }, region);
        add(margin, margin.least.value_or(0) < 0);
    }
    score.marginLeast = least.least;
}

/// A model is taken if it is whole, and inside a shell of another piece than the largest of the
/// body to cut. An open cavity encloses nothing.
void measureTaking(const TaskBody& body, int model, CutScore& score) {
    const int inside = trianglesOf(model, body.uncut, body.uncutMembers).front();
    const Vec3 middle = figuresOfPiece(body.uncut, PieceShells(body.uncut), inside).centroid;
    const PieceMap pieces = findPieces(body.mesh);
    UnionFind shells = shellsOf(body.mesh);
    std::map<int, int> windings;  // about the middle, by a vertex of each shell
    for (const int t : trianglesOf(body.task.model, body.mesh, body.members)) {
        windings[shells.root(body.mesh.triangle(t)[0])] +=
            rayCrossing(restCornersOf(body.mesh, t), middle);
    }
    double around = kInfinite;  // its volume [m^3]
    double largest = 0;
    for (const auto& [vertex, winding] : windings) {
        const double volume = pieces.pieces[pieces.ofVertex[vertex]].restVolume;
        largest = std::max(largest, volume);
        around = winding > 0 ? volume : around;
    }
    score.taken = around < largest && !isHarmed(body, model) ? 1 : 0;
    if (*score.taken > 0) {
        score.excisedVolume = around;
    }
}

}  // namespace

CutScore measureCut(const TaskBody& body) {
    CutScore score;
    if (!body.task.lines.empty()) {
        measureLines(body, score);
    }
    measureMargins(body, score);
    if (body.task.take) {
        measureTaking(body, *body.task.take, score);
    }
    return score;
}

std::vector<RimDeviation> rimDeviations(const TaskBody& body) {
    const SurfaceMesh& mesh = body.mesh;
    TaskLines lines(body);
    std::vector<RimDeviation> rim;
    for (const int t : trianglesOf(body.task.model, mesh, body.members)) {
        for (int h = 3 * t; isBladeWall(mesh, t) && h < 3 * t + 3; ++h) {
            if (!isRim(mesh, h)) continue;
            const Vec3 middle =
                0.5 * (mesh.restPosition(mesh.origin(h)) + mesh.restPosition(mesh.target(h)));
            rim.push_back({h, lines.parts.empty()
                                  ? std::nullopt
                                  : lines.deviation(middle, lines.nearest(middle))});
        }
    }
    return rim;
}

}  // namespace kerf::app
