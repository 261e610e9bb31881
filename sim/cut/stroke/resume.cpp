#include "sim/cut/stroke/resume.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <span>

namespace kerf::cut {

namespace {

// Shares of h: how far behind the front the new strip starts, and how far aside of the blade it
// ends. The steepest first: walls beside a crumpled front stray by half an edge themselves, and
// where a flatter strip misses them a bridge is left.
struct Detour {
    double behind;
    double aside;
};
constexpr Detour kDetours[] = {{1.5, 0.6}, {1.0, 0.4}, {1.0, 0.2}, {0.5, 0.1}, {0.5, 0.03}};
// Shares of h for strips that end a little ahead of the front: so short, they cross the
// old walls as steeply without going far aside.
struct ShortDetour {
    double behind;
    double aside;
    double ahead;
};
constexpr ShortDetour kShortDetours[] = {
    {1.0, 0.25, 0.3}, {1.0, 0.25, 0.15}, {1.5, 0.25, 0.6}, {0.7, 0.15, 0.3}};
constexpr double kCrossing = 0.35;  // share of h behind the front where they cross the old walls
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

/// From `behind` [m] behind the front, moved by `start`, to `blade`, moved by `end`.
Resumption resumptionAt(const std::vector<RungNode>& rung, const std::vector<Vec3>& motions,
                        double behind, const Vec3& start, const Blade& blade, const Vec3& end,
                        double h) {
    const double way = longest(motions).norm();
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

Resumption detourAt(const std::vector<RungNode>& rung, const std::vector<Vec3>& motions,
                    const Blade& blade, const Vec3& normal, const Detour& detour, double h) {
    const double behind = detour.behind * h;
    const Vec3 start = normal * (kStartShare * detour.aside * h * behind / longest(motions).norm());
    return resumptionAt(rung, motions, behind, start, blade, normal * (-detour.aside * h), h);
}

Resumption crossingAt(const std::vector<RungNode>& rung, const std::vector<Vec3>& motions,
                      const Blade& blade, const Vec3& normal, const ShortDetour& detour, double h) {
    const double way = longest(motions).norm();
    const double ahead = std::min(detour.ahead * h, way);
    const double rest = 1 - ahead / way;
    const Blade end{blade.a - motions.front() * rest, blade.b - motions.back() * rest};
    const double steepness = detour.aside * h / (kCrossing * h + ahead);
    const double behind = detour.behind * h;
    return resumptionAt(rung, motions, behind, normal * (steepness * (behind - kCrossing * h)), end,
                        normal * (-detour.aside * h), h);
}

template <class DetourKind, class Lead>
std::vector<Resumption> waysOn(const std::vector<RungNode>& rung, const Blade& blade, double h,
                               std::span<const DetourKind> detours, const Lead& lead) {
    const std::vector<Vec3> ways = motions(rung, blade);
    const Vec3 way = longest(ways);
    const Vec3 normal = (blade.b - blade.a).cross(way).stableNormalized();
    std::vector<Resumption> result;
    if (way.norm() < kLeastMotion * h) {
        return result;
    }
    for (const DetourKind& detour : detours) {
        for (const double side : {1.0, -1.0}) {
            result.push_back(lead(rung, ways, blade, side * normal, detour, h));
        }
    }
    return result;
}

}  // namespace

std::vector<Resumption> crossings(const std::vector<RungNode>& rung, const Blade& blade, double h) {
    return waysOn<ShortDetour>(rung, blade, h, kShortDetours, crossingAt);
}

std::vector<Resumption> resumptions(const std::vector<RungNode>& rung, const Blade& blade,
                                    double h) {
    return waysOn<Detour>(rung, blade, h, kDetours, detourAt);
}

}  // namespace kerf::cut
