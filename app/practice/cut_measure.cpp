#include "app/practice/cut_measure.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <variant>

#include "app/practice/mean.h"
#include "app/practice/task_line.h"
#include "sim/mesh/cavities.h"
#include "sim/mesh/closest_point.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/piece_figures.h"
#include "sim/mesh/winding.h"

namespace kerf::app {

namespace {

constexpr int kParts = 16;       // of an edge, each of which belongs to a line or not
constexpr double kCrumb = 1e-3;  // of the largest piece: less is no slice

/// The living walls that a blade made, on both sides.
std::vector<int> bladeWalls(const SurfaceMesh& mesh) {
    const auto isTorn = [&](int v) { return mesh.isTorn(v); };
    std::vector<int> walls = livingTriangles(mesh);
    std::erase_if(walls, [&](int t) {
        return mesh.kind(t) != SurfaceKind::wall || std::ranges::any_of(mesh.triangle(t), isTorn);
    });
    return walls;
}

Vec3 middleOf(const Corners& corners) {
    return (corners[0] + corners[1] + corners[2]) / 3;
}

using DistanceTo = std::function<double(const Vec3& p)>;
using WallsByStroke = std::map<int, std::vector<int>>;

/// The distance from the nearest of some triangles at rest [m].
DistanceTo distanceToSome(const SurfaceMesh& mesh, const std::vector<int>& triangles) {
    const auto corners = [&mesh](int t) { return restCornersOf(mesh, t); };
    return [corners, tree = std::make_shared<NearestTriangle>(triangles, corners)](const Vec3& p) {
        const auto [a, b, c] = corners(tree->find(p));
        const Vec3 w = closestWeights(p, a, b, c);
        return (w[0] * a + w[1] * b + w[2] * c - p).norm();
    };
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

/// An edge of a wall at rest.
struct WallEdge {
    Vec3 from;
    Vec3 to;
    int model;
    bool isRim;  ///< skin lies across
};

/// The edges of walls, of the side W+: the other has the same.
std::vector<WallEdge> edgesOf(const TaskBody& body, const std::vector<int>& walls) {
    const SurfaceMesh& mesh = body.mesh;
    std::vector<WallEdge> edges;
    for (const int t : walls) {
        for (int h = 3 * t; mesh.wallLabel(t) % 2 == 0 && h < 3 * t + 3; ++h) {
            const int across = SurfaceMesh::triangleOf(mesh.twin(h));
            edges.push_back({mesh.restPosition(mesh.origin(h)), mesh.restPosition(mesh.target(h)),
                             body.members[t], mesh.kind(across) == SurfaceKind::skin});
        }
    }
    return edges;
}

std::vector<LineCurve> curvesOf(const Task& task) {
    return {task.lines.begin(), task.lines.end()};
}

/// The line on a model that is nearest to a point; null where it has none.
const LineCurve* nearestCurve(const std::vector<LineCurve>& curves, const Vec3& x, int model) {
    const LineCurve* found = nullptr;
    for (const LineCurve& curve : curves) {
        if (curve.line().model == model &&
            (found == nullptr || curve.nearest(x).distance < found->nearest(x).distance)) {
            found = &curve;
        }
    }
    return found;
}

/// The distance of a point from the line that it belongs to [m]; none if it belongs to none.
std::optional<double> deviationOf(const std::vector<LineCurve>& curves, const Vec3& x, int model) {
    const LineCurve* curve = nearestCurve(curves, x, model);
    const PlaceAtLine place = curve != nullptr ? curve->nearest(x) : PlaceAtLine{0, true};
    return !place.isBeyond && place.distance <= curve->line().reach ? std::optional(place.distance)
                                                                    : std::nullopt;
}

/// The cut in a section of a line: none where there is none.
struct SectionCut {
    std::optional<double> deviation;  ///< the largest of rims [m]
    std::optional<double> depth;      ///< the largest [m]
};

/// Compares the edges of walls with the lines.
class LineMeasure {
  public:
    LineMeasure(const TaskBody& body, const std::vector<int>& walls)
        : body_(body), edges_(edgesOf(body, walls)), curves_(curvesOf(body.task)) {}

    void addTo(CutScore& score) {
        for (const LineCurve& curve : curves_) {
            largest_ = std::nullopt;
            for (const LineSection& section : curve.sections(body_.uncut, body_.uncutMembers)) {
                add(curve, section);
            }
            score.lineDeviations.push_back(largest_);
            raise(score.deviationMax, largest_);
        }
        score.deviationMean = deviation_.value();
        score.depthMean = depth_.value();
        score.depthInBand = inBand_.value();
        if (!curves_.empty()) {
            score.lengthUnder = under_;
            score.lengthOver = lengthOver();
        }
    }

  private:
    void add(const LineCurve& curve, const LineSection& section) {
        const double step = curve.sectionStep();
        const SectionCut cut = cutIn(curve, section);
        if (!cut.deviation) {
            under_ += step;
            return;
        }
        deviation_.add(*cut.deviation, step);
        raise(largest_, cut.deviation);
        const TaskLine& line = curve.line();
        if (line.depth && section.toEnd >= *line.depth) {
            depth_.add(*cut.depth, step);
            inBand_.add(std::abs(*cut.depth - *line.depth) <= line.band.value_or(0) ? 1 : 0, step);
        }
    }

    SectionCut cutIn(const LineCurve& curve, const LineSection& section) const {
        SectionCut cut;
        for (const WallEdge& edge : edges_) {
            const double from = (edge.from - section.top).dot(section.along);
            const double to = (edge.to - section.top).dot(section.along);
            if (edge.model != curve.line().model || (from < 0) == (to < 0)) {
                continue;
            }
            const Vec3 x = edge.from + from / (from - to) * (edge.to - edge.from);
            const double aside = std::abs((x - section.top).dot(section.aside));
            if (aside <= curve.line().reach && nearestCurve(curves_, x, edge.model) == &curve) {
                raise(cut.deviation, edge.isRim ? std::optional(aside) : std::nullopt);
                raise(cut.depth, curve.depthOf(x, section.top));
            }
        }
        return cut;
    }

    double lengthOver() const {
        double over = 0;
        for (const WallEdge& edge : edges_) {
            for (int part = 0; edge.isRim && part < kParts; ++part) {
                const Vec3 x = edge.from + (part + 0.5) / kParts * (edge.to - edge.from);
                if (nearestCurve(curves_, x, edge.model) != nullptr &&
                    !deviationOf(curves_, x, edge.model)) {
                    over += (edge.to - edge.from).norm() / kParts;
                }
            }
        }
        return over;
    }

    const TaskBody& body_;
    std::vector<WallEdge> edges_;
    std::vector<LineCurve> curves_;
    Mean deviation_;
    Mean depth_;
    Mean inBand_;
    double under_ = 0;
    std::optional<double> largest_;  ///< deviation from the line in question
};

bool isSpared(const Task& task, int model) {
    return std::ranges::find(task.spare, model, &SparedModel::model) != task.spare.end();
}

/// Whether a blade or a tear left a wall on a model.
bool isHarmed(const TaskBody& body, int model) {
    return std::ranges::any_of(livingTriangles(body.mesh), [&](int t) {
        return body.members[t] == model && body.mesh.kind(t) == SurfaceKind::wall;
    });
}

std::vector<DistanceTo> distancesToSpared(const TaskBody& body) {
    std::vector<DistanceTo> distances;
    for (const SparedModel& spared : body.task.spare) {
        distances.push_back(distanceToSome(
            body.uncut, trianglesOfModel(spared.model, body.uncut, body.uncutMembers)));
    }
    for (const SparedRegion& spared : body.task.spareRegions) {
        distances.emplace_back([&](const Vec3& p) { return distanceTo(spared.region, p); });
    }
    return distances;
}

void measureMargins(const TaskBody& body, const std::vector<int>& walls, CutScore& score) {
    const std::vector<DistanceTo> distances = distancesToSpared(body);
    score.partMargins.resize(distances.size());
    Mean mean;
    for (const int t : walls) {
        const Corners at = restCornersOf(body.mesh, t);
        std::optional<double> ofMiddle;
        const std::size_t parts = isSpared(body.task, body.members[t]) ? 0 : distances.size();
        for (std::size_t i = 0; i < parts; ++i) {
            lower(ofMiddle, distances[i](middleOf(at)));
            for (const Vec3& point : {at[0], at[1], at[2], middleOf(at)}) {
                lower(score.partMargins[i], distances[i](point));
            }
        }
        mean.add(ofMiddle.value_or(0), ofMiddle ? triangleArea(at) : 0);
    }
    for (std::size_t i = 0; i < body.task.spare.size(); ++i) {
        if (isHarmed(body, body.task.spare[i].model)) {
            score.harmed.push_back(body.task.spare[i].model);
            lower(score.partMargins[i], 0);
        }
    }
    for (const std::optional<double>& margin : score.partMargins) {
        lower(score.marginLeast, margin);
    }
    score.marginMean = mean.value();
}

/// The pieces of a body.
class ModelPieces {
  public:
    explicit ModelPieces(const TaskBody& body)
        : body_(body), map_(findPieces(body.mesh)), models_(map_.pieces.size(), -1) {
        for (const int t : livingTriangles(body.mesh)) {
            models_[pieceOf(t)] = body.members[t];
        }
    }

    int count() const { return static_cast<int>(models_.size()); }
    int ofVertex(int v) const { return map_.ofVertex[v]; }
    int pieceOf(int t) const { return ofVertex(body_.mesh.triangle(t)[0]); }
    double volume(int piece) const { return map_.pieces[piece].restVolume; }
    /// The volume of a piece as a share of that of the largest of its model, which has 1.
    double share(int piece) const {
        double largest = 0;
        for (int other = 0; other < count(); ++other) {
            largest = models_[other] == models_[piece] ? std::max(largest, volume(other)) : largest;
        }
        return volume(piece) / largest;
    }

  private:
    const TaskBody& body_;
    PieceMap map_;
    std::vector<int> models_;
};

/// The piece of `host` with a shell around a point, -1 for none. An open cavity encloses nothing.
int pieceAround(const TaskBody& body, const ModelPieces& pieces, int host, const Vec3& point) {
    UnionFind shells = shellsOf(body.mesh);
    std::map<int, int> windings;  // by the lowest vertex of a shell
    for (const int t : trianglesOfModel(host, body.mesh, body.members)) {
        windings[shells.root(body.mesh.triangle(t)[0])] +=
            rayCrossing(restCornersOf(body.mesh, t), point);
    }
    const auto around =
        std::ranges::find_if(windings, [](const auto& of) { return of.second > 0; });
    return around == windings.end() ? -1 : pieces.ofVertex(around->first);
}

void measureTaking(const TaskBody& body, const ModelPieces& pieces, CutScore& score) {
    const Task& task = body.task;
    const int host = task.lines.empty() ? 0 : task.lines.front().model;
    const int lump = trianglesOfModel(*task.take, body.uncut, body.uncutMembers).front();
    const Vec3 middle = figuresOfPiece(body.uncut, PieceShells(body.uncut), lump).centroid;
    const int around = pieceAround(body, pieces, host, middle);
    score.taken = around >= 0 && pieces.share(around) < 1 && !isHarmed(body, *task.take);
    if (*score.taken) {
        score.excisedVolume = pieces.volume(around);
    }
}

/// The walls of the slice, by stroke: of the smallest piece apart that has walls of two.
WallsByStroke wallsOfSlice(const SurfaceMesh& mesh, const ModelPieces& pieces,
                           const std::vector<int>& walls) {
    std::vector<WallsByStroke> all(pieces.count());
    for (const int t : walls) {
        all[pieces.pieceOf(t)][mesh.wallLabel(t) / 2].push_back(t);
    }
    int slice = -1;
    for (int piece = 0; piece < pieces.count(); ++piece) {
        const double share = pieces.share(piece);
        const bool isSlice = all[piece].size() >= 2 && share > kCrumb && share < 1;
        if (isSlice && (slice < 0 || pieces.volume(piece) < pieces.volume(slice))) {
            slice = piece;
        }
    }
    return slice < 0 ? WallsByStroke() : all[slice];
}

void measureSlice(const TaskBody& body, const WallsByStroke& slice, CutScore& score) {
    const TaskSlice& asked = *body.task.slice;
    Mean thickness;
    Mean inBand;
    for (const auto& [stroke, own] : slice) {
        std::vector<int> others;
        for (const auto& [other, theirs] : slice) {
            others.insert(others.end(), theirs.begin(),
                          other == stroke ? theirs.begin() : theirs.end());
        }
        const DistanceTo distance = distanceToSome(body.mesh, others);
        for (const int t : own) {
            const Corners at = restCornersOf(body.mesh, t);
            const double across = distance(middleOf(at));
            thickness.add(across, triangleArea(at));
            inBand.add(std::abs(across - asked.thickness) <= asked.band ? 1 : 0, triangleArea(at));
        }
    }
    score.thicknessMean = thickness.value();
    score.thicknessInBand = inBand.value();
}

}  // namespace

CutScore measureCut(const TaskBody& body) {
    const std::vector<int> walls = bladeWalls(body.mesh);
    const ModelPieces pieces(body);
    CutScore score;
    LineMeasure(body, walls).addTo(score);
    measureMargins(body, walls, score);
    if (body.task.take) {
        measureTaking(body, pieces, score);
    }
    if (body.task.slice) {
        measureSlice(body, wallsOfSlice(body.mesh, pieces, walls), score);
    }
    return score;
}

std::vector<float> deviationAtWalls(const TaskBody& body) {
    std::vector<float> values(2 * static_cast<std::size_t>(body.mesh.vertexCount()), -1);
    const std::vector<LineCurve> curves = curvesOf(body.task);
    for (const int t : bladeWalls(body.mesh)) {
        for (const int v : body.mesh.triangle(t)) {
            const auto deviation = deviationOf(curves, body.mesh.restPosition(v), body.members[t]);
            values[2 * v + 1] = static_cast<float>(deviation.value_or(-1));
        }
    }
    return values;
}

}  // namespace kerf::app
