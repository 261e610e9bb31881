#include "sim/run/blade/felt_edge.h"

#include "sim/mesh/box_tree.h"
#include "sim/mesh/triangle.h"
#include "sim/run/parts/led_blade.h"

namespace kerf {

namespace {

constexpr int kSamples = 128;  // along the edge
// Of the give: how far the answer of the material reaches.
constexpr double kReach = 1.5;
// Cosine: triangles that lie along the way, as the walls behind the edge, do not stop it.
constexpr double kAlong = 0.05;

/// A stretch of the front, by parameters of the edge.
struct FrontEdge {
    double from = 0;
    double to = 0;
    Vec3 start = Vec3::Zero();
    Vec3 end = Vec3::Zero();
};

std::vector<FrontEdge> frontOf(const EdgeSurroundings& place) {
    const Vec3 along = place.edge.b - place.edge.a;
    const auto parameterOf = [&](const RungNode& node) {
        return (node.position - place.edge.a).dot(along) / along.squaredNorm();
    };
    std::vector<FrontEdge> front;
    for (std::size_t i = 0; i + 1 < place.rung.size(); ++i) {
        const RungNode& from = place.rung[i];
        const RungNode& to = place.rung[i + 1];
        if (from.attached) {
            front.push_back({parameterOf(from), parameterOf(to), from.position, to.position});
        }
    }
    return front;
}

/// How deep a point lies behind the surface that it went in through, against `back` [m]; 0
/// outside, or where that is farther than `most` away.
double depthOf(const EdgeSurroundings& place, const Vec3& point, double most) {
    double depth = most;
    bool inside = false;
    for (const int t : place.triangles) {
        const Corners corners = cornersOf(place.mesh, t);
        const std::optional<LineHit> hit = hitOf(corners, point, place.back, kAlong);
        if (hit && hit->distance >= 0 && hit->distance < depth) {
            depth = hit->distance;
            inside = areaNormal(corners).dot(place.back) > 0;
        }
    }
    return inside ? depth : 0;
}

/// None where there is no front.
std::optional<double> lagBehindFront(const EdgeSurroundings& place,
                                     const std::vector<FrontEdge>& front, double s,
                                     const Vec3& point) {
    for (const FrontEdge& edge : front) {
        if (edge.from <= s && s < edge.to) {
            const double t = (s - edge.from) / (edge.to - edge.from);
            return place.back.dot(edge.start + t * (edge.end - edge.start) - point);
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<FeltEdge> feltEdge(const EdgeSurroundings& place, const EdgeSpring& spring) {
    const std::vector<FrontEdge> front = frontOf(place);
    const double most = spring.mostLag(standsInMaterial(place.rung));
    const Vec3 along = place.edge.b - place.edge.a;
    const double part = along.norm() / kSamples;
    FeltEdge felt;
    PressingEdge& edge = felt.pressing;
    double width = 0;
    double area = 0;
    for (int i = 0; i < kSamples; ++i) {
        const double s = (i + 0.5) / kSamples;
        const Vec3 point = place.edge.a + s * along;
        const std::optional<double> behind = lagBehindFront(place, front, s, point);
        const double lag = std::min(behind ? *behind : depthOf(place, point, 2 * most), most);
        if (lag <= 0) {
            continue;
        }
        edge.to = point + lag * place.back;
        edge.from = width == 0 ? edge.to : edge.from;
        width += part;
        area += part * lag;
        felt.energy += 0.5 * part * spring.stiffness() * lag * lag;
    }
    if (width == 0) {
        return std::nullopt;
    }
    edge.ahead = -place.back;
    edge.reach = kReach * spring.give;
    edge.lag = area / width;
    edge.stiffness = spring.stiffness() * width;
    edge.mostForce = edge.stiffness * most;
    return felt;
}

}  // namespace kerf
