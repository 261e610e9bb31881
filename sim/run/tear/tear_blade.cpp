#include "sim/run/tear/tear_blade.h"

#include "sim/mesh/box_tree.h"
#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

constexpr double kOverhang = 0.7;  // edges by which the blade stands out of the skin
// Of the heading by slip alone, over 1 less half its share of the displacements [rad]: 140 degrees.
constexpr double kTurn = 2.44;
constexpr double kTwist = 0.5;    // of mode III against mode I, at Poisson's ratio 0.5
constexpr double kFollows = 0.5;  // of an opening that advances, where one end follows the other

/// The angle by which the end of a slit turns towards W+ in an edge, whose walls opened and slid by
/// `way`: Richard, Fulland and Sander (2005), with stress intensities in proportion to the
/// displacements. It takes the length of the cohesive zone, within which no kink is resolved.
double turnOf(const EndFrame& frame, const Vec3& way) {
    const double slid = way.dot(frame.heading);
    const double twisted = kTwist * std::abs(way.dot(frame.along));
    const double sum = std::max(way.dot(frame.side), 0.0) + std::abs(slid) + twisted;
    const double share = sum > 0 ? std::abs(slid) / sum : 0;
    const double turn = (kTurn - 0.5 * kTurn * share) * share;
    return (slid > 0 ? -turn : turn) / kEdgesInZone;
}

/// How far an end of the blade goes, in edges.
double advanceBy(double opening, double other) {
    return opening < (other > 1 ? kFollows : 1) ? 0 : std::min(opening, 1.0);
}

/// How far an end reaches ahead of the line between its first and last vertex [m].
double depthOf(const SurfaceMesh& mesh, const SlitEnd& end, const EndFrame& frame) {
    double most = 0;
    for (const int v : end.vertices) {
        const Vec3 off = mesh.position(v) - mesh.position(end.vertices.front());
        most = std::max(most, off.dot(frame.heading));
    }
    return most;
}

/// How far it is out of the body; none from outside of it [m].
std::optional<double> wayOut(RunningBody& body, const Vec3& from, const Vec3& direction) {
    const SurfaceMesh& mesh = body.mesh();
    const std::array<Vec3, 2> line{from, from + body.memory.measure.bounds.diagonal() * direction};
    double nearest = 1e300;
    bool leaves = false;
    for (const int t : body.trianglesNear(line)) {
        const Corners corners = cornersOf(mesh, t);
        const std::optional<LineHit> hit = hitOf(corners, from, direction, 0);
        if (hit && hit->distance > 0 && hit->distance < nearest) {
            nearest = hit->distance;
            leaves = areaNormal(corners).dot(direction) > 0;
        }
    }
    return leaves ? std::optional(nearest) : std::nullopt;
}

}  // namespace

Blade bladeThrough(RunningBody& body, const Vec3& a, const Vec3& b) {
    const Vec3 middle = 0.5 * (a + b);
    const Vec3 axis = (b - a).stableNormalized();
    const auto out = [&](const Vec3& direction) -> Vec3 {
        const double way = wayOut(body, middle, direction).value_or(0.5 * (b - a).norm());
        return middle + (way + kOverhang * body.wallEdge) * direction;
    };
    return {out(-axis), out(axis)};
}

std::optional<TearBlade> bladeOf(RunningBody& body, const SlitEnd& end, const EndOpening& opening) {
    const SurfaceMesh& mesh = body.mesh();
    const std::optional<EndFrame> frame = frameOf(mesh, end, VertexPositions::current(mesh));
    const std::optional<EndFrame> rest = restFrameOf(mesh, end, kEdgesInZone * body.wallEdge);
    if (!frame || !rest) {
        return std::nullopt;
    }
    const double turn = turnOf(*frame, opening.way);
    const Vec3 way = body.wallEdge * (std::cos(turn) * rest->heading + std::sin(turn) * rest->side);
    // Where the end is a bay of the uncut material, the blade goes straight below all of it.
    const Vec3 deepest = depthOf(mesh, end, *frame) * frame->heading;
    const auto goal = [&](int v, double own, double other) -> Vec3 {
        return mesh.position(v) + deepest + presentWay(mesh, end, v, advanceBy(own, other) * way);
    };
    const int first = end.vertices.front();
    const int last = end.vertices.back();
    const Vec3 out = kOverhang * body.wallEdge * frame->along;
    return TearBlade{frame->heading,
                     {mesh.position(first) - out, mesh.position(last) + out},
                     bladeThrough(body, goal(first, opening.atFirst, opening.atLast),
                                  goal(last, opening.atLast, opening.atFirst))};
}

}  // namespace kerf
