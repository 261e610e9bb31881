#include "sim/cut/stroke/resume.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "sim/base/mapped.h"
#include "sim/cut/blade_line.h"

namespace kerf::cut {

namespace {

// Shares of h: how far behind the front the new strip starts, how far aside of the blade it ends,
// and how far ahead of the front. So short, strips cross the old walls steeply without going far
// aside.
struct Detour {
    double behind;
    double aside;
    double ahead;
};
constexpr Detour kDetours[] = {
    {1.0, 0.25, 0.3}, {1.0, 0.25, 0.15}, {1.5, 0.25, 0.6}, {0.7, 0.15, 0.3}};
constexpr double kCrossing = 0.35;  // share of h behind the front where they cross the old walls
constexpr double kLeastMotion = 1e-3;
// Of the new rung's nodes: where the front is crumpled, it is led straight.
constexpr double kLeastSpacing = 0.5;

/// From the rung to the blade, by node.
std::vector<Vec3> motions(const std::vector<RungNode>& rung, const Blade& blade) {
    return mapped(rung, [&](const RungNode& node) -> Vec3 {
        return pointOn(blade, std::clamp(node.s, 0.0, 1.0)) - node.position;
    });
}

Vec3 longest(const std::vector<Vec3>& vectors) {
    return *std::ranges::max_element(vectors, {}, [](const Vec3& v) { return v.norm(); });
}

/// `motions`: of the rung to the blade. `normal`: to the side on which the strip starts.
Resumption resumptionBy(const Detour& detour, const std::vector<RungNode>& rung,
                        const std::vector<Vec3>& motions, const Blade& blade, const Vec3& normal,
                        double h) {
    const double way = longest(motions).norm();
    const double ahead = std::min(detour.ahead * h, way);
    const double rest = 1 - ahead / way;
    const double behind = detour.behind * h;
    const double steepness = detour.aside * h / (kCrossing * h + ahead);
    const Vec3 start = normal * (steepness * (behind - kCrossing * h));
    const Vec3 end = normal * (-detour.aside * h);
    Resumption result{
        {}, {blade.a - motions.front() * rest + end, blade.b - motions.back() * rest + end}};
    const double room = kLeastSpacing * h / lengthOf(result.blade);
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
            result.push_back(resumptionBy(detour, rung, ways, blade, side * normal, h));
        }
    }
    return result;
}

}  // namespace kerf::cut
