#include "sim/cut/resume.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace kerf::cut {

namespace {

// Shares of h: how far behind the front the new sweep starts, and how far aside of the blade it
// ends. The steepest first: walls beside a crumpled front stray by half an edge themselves, and
// where a flatter sweep misses them a bridge is left.
struct Detour {
    double behind;
    double aside;
};
constexpr Detour kDetours[] = {{1.5, 0.6}, {1.0, 0.4}, {1.0, 0.2}, {0.5, 0.1}, {0.5, 0.03}};
// Of the height that leads just to the old front: the walls cross well behind it.
constexpr double kStartShare = 0.5;
constexpr double kLeastMotion = 1e-3;
// Of the new rung's nodes: where the front is crumpled, it is led straight.
constexpr double kLeastSpacing = 0.5;

/// From the rung to the blade, by node.
std::vector<Vec3> motions(const std::vector<RungNode>& rung, const Blade& blade) {
    std::vector<Vec3> result;
    for (const RungNode& node : rung) {
        const double s = std::clamp(node.s, 0.0, 1.0);
        result.push_back(blade.a + (blade.b - blade.a) * s - node.position);
    }
    return result;
}

Vec3 longest(const std::vector<Vec3>& vectors) {
    return *std::ranges::max_element(vectors, {}, [](const Vec3& v) { return v.norm(); });
}

Resumption resumptionAt(const std::vector<RungNode>& rung, const std::vector<Vec3>& motions,
                        const Blade& blade, const Vec3& normal, const Detour& detour, double h) {
    const double way = longest(motions).norm();
    const double behind = detour.behind * h;
    const Vec3 start = normal * (kStartShare * detour.aside * h * behind / way);
    const Vec3 end = normal * (-detour.aside * h);
    Resumption result{{}, {blade.a + end, blade.b + end}};
    const double room = kLeastSpacing * h / (blade.b - blade.a).norm();
    for (std::size_t i = 0; i < rung.size(); ++i) {
        const bool isEnd = i == 0 || i + 1 == rung.size();
        if (isEnd ||
            (rung[i].s - result.rung.back().s > room && rung.back().s - rung[i].s > room)) {
            const Vec3 position = rung[i].position - motions[i] * (behind / way) + start;
            result.rung.push_back({position, rung[i].s, -1, false});
        }
    }
    return result;
}

}  // namespace

std::vector<Resumption> resumptions(const std::vector<RungNode>& rung, const Blade& blade,
                                    double h) {
    const std::vector<Vec3> ways = motions(rung, blade);
    const Vec3 way = longest(ways);
    const Vec3 normal = (blade.b - blade.a).cross(way).stableNormalized();
    std::vector<Resumption> result;
    if (way.norm() < kLeastMotion * h) {
        return result;
    }
    for (const Detour& detour : kDetours) {
        for (const double side : {1.0, -1.0}) {
            result.push_back(resumptionAt(rung, ways, blade, side * normal, detour, h));
        }
    }
    return result;
}

}  // namespace kerf::cut
