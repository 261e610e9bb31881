#include "app/practice/cut_measure.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "app/practice/series.h"
#include "sim/mesh/cavities.h"
#include "sim/mesh/closest_point.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/piece_figures.h"
#include "sim/mesh/winding.h"

namespace kerf::app {

namespace {

constexpr int kParts = 400;     // of a line
constexpr double kAtEnd = 0.6;  // of the last part: so near to its middle is not beyond its end
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
    explicit TaskLines(const Task& task) : into(task.into.stableNormalized()), reach(task.reach) {
        for (const TaskLine& line : task.lines) {
            Curve curve;  // by its length
            for (std::size_t i = 0; i < line.points.size() + (line.closed ? 1 : 0); ++i) {
                const Vec3 x = flat(line.points[i % line.points.size()]);
                curve.add(i == 0 ? 0 : curve.at.back() + (x - curve.points.back()).norm(), x);
            }
            const double length = curve.span() / kParts;
            for (double at = length / 2; at < curve.span(); at += length) {
                parts.push_back({curve(at), curve(at + length / 2) - curve(at - length / 2),
                                 line.closed ? kInfinite : std::min(at, curve.span() - at)});
            }
            step = std::min(step, length / 2);
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

/// Compares an edge of a wall with the lines, in short steps. Returns what of a rim is elsewhere.
double addEdge(const SurfaceMesh& mesh, int h, TaskLines& lines) {
    const Vec3& from = mesh.restPosition(mesh.origin(h));
    const Vec3 way = mesh.restPosition(mesh.target(h)) - from;
    const bool inSkin = isRim(mesh, h);
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
        over += !deviation && inSkin ? way.norm() / steps : 0;
    }
    return over;
}

void measureLines(const TaskBody& body, CutScore& score) {
    const Task& task = body.task;
    TaskLines lines(task);
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
        if (task.depth && part.toEnd >= *task.depth) {  // nearer to an end a blade swings in
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

/// The distance from a region [m], negative inside.
double distanceTo(const Region& region, const Vec3& p) {
    if (const auto* ball = std::get_if<Ball>(&region)) {
        return (p - ball->center).norm() - ball->radius;
    }
    const Bounds& box = std::get<Bounds>(region);
    const Vec3 outside = (box.low - p).cwiseMax(p - box.high);
    return outside.cwiseMax(0).norm() + std::min(outside.maxCoeff(), 0.0);
}

/// From the corners of walls of what is not spared, and from their middles.
void measureMargins(const TaskBody& body, CutScore& score) {
    const auto& spare = body.task.spare;
    std::vector<Vec3> points;
    for (const int t : livingTriangles(body.mesh)) {
        if (isBladeWall(body.mesh, t) && std::ranges::count(spare, body.members[t]) == 0) {
            const auto [a, b, c] = restCornersOf(body.mesh, t);
            points.insert(points.end(), {a, b, c, (a + b + c) / 3});
        }
    }
    Statistics margin;
    score.sparedCut = 0;
    for (const int model : spare) {
        const auto corners = [&](int t) { return restCornersOf(body.uncut, t); };
        NearestTriangle surface(trianglesOf(model, body.uncut, body.uncutMembers), corners);
        for (const Vec3& p : points) {
            const auto [a, b, c] = corners(surface.find(p));
            const Vec3 weights = closestWeights(p, a, b, c);
            margin.add((weights[0] * a + weights[1] * b + weights[2] * c - p).norm());
        }
        if (isHarmed(body, model)) {
            margin.add(0);
            ++*score.sparedCut;
        }
    }
    for (const Region& region : body.task.spareRegions) {
        for (const Vec3& p : points) {
            margin.add(distanceTo(region, p));
        }
    }
    score.marginLeast = margin.least;
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
    TaskLines lines(body.task);
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
