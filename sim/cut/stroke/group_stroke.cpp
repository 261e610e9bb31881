#include "sim/cut/stroke/group_stroke.h"

#include <Eigen/Geometry>

#include "sim/base/containers.h"
#include "sim/cut/surface/edge_length_field.h"

namespace kerf::cut {

namespace {

constexpr double kPast = 3;  // edge lengths behind the front: farther than what it may crumple

// Of the gate, where edges grow: the cut may lag so many times as far behind the blade.
constexpr double kHighestRow = 2;

constexpr double kLeastPassing = 1e-7;  // share of h
constexpr double kTurningBack = 1e-3;   // share of h
constexpr double kBackwards = -0.5;     // cosine
constexpr double kBackwardShare = 0.5;

Vec3 withoutComponent(const Vec3& p, const Vec3& direction) {
    return p - direction * (p.dot(direction) / direction.squaredNorm());
}

/// One front edge: its length, and whether the blade leaves it towards its own walls.
struct FrontMotion {
    double length = 0;
    bool backwards = false;
};

FrontMotion frontMotion(const SurfaceMesh& mesh, const Blade& blade, double h,
                        const Vec3& lastAdvance, const RungNode& from, const RungNode& to) {
    const int edge = mesh.findHalfEdge(from.vertex, to.vertex);
    const Vec3 along = to.position - from.position;
    if (edge < 0 || along.squaredNorm() == 0) {
        return {};
    }
    const Vec3 apexes =
        0.5 * (mesh.position(mesh.apex(edge)) + mesh.position(mesh.apex(mesh.twin(edge))));
    const Vec3 back = withoutComponent(apexes - from.position, along);
    const double s = std::clamp(0.5 * (from.s + to.s), 0.0, 1.0);
    const Vec3 target = pointOn(blade, s);
    const Vec3 move = withoutComponent(target - 0.5 * (from.position + to.position), along);
    if (back.norm() < 1e-300) {
        return {};
    }
    const bool moves = move.norm() >= kTurningBack * h && move.dot(lastAdvance) <= 0;
    const double forward = -move.dot(back);
    return {along.norm(), moves && forward < kBackwards * move.norm() * back.norm()};
}

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

void OwnPast::start(int firstVertex) {
    *this = {};
    past_ = {firstVertex, firstVertex};
}

void OwnPast::closeUp(int endVertex) {
    past_.end = endVertex;
    recent_.clear();
}

void OwnPast::goOn(double way, int nextVertex) {
    recent_.push_back({way_, nextVertex});
    way_ += way;
    auto present = recent_.begin();
    while (present != recent_.end() && present->way + kPast <= way_) {
        past_.end = present->nextVertex;
        ++present;
    }
    recent_.erase(recent_.begin(), present);
}

void followMesh(const SurfaceMesh& mesh, std::vector<RungNode>& rung) {
    for (RungNode& node : rung) {
        if (node.vertex >= 0) {
            node.position = mesh.position(node.vertex);
        }
    }
}

double rowGrowth(const CutSettings& settings, const GroupStroke& group) {
    const WallGrading grading{settings.wallCoarsening};
    if (!grading.isOn()) {
        return 1;
    }
    double front = 0;
    for (std::size_t i = 0; i + 1 < group.rung.size(); ++i) {
        front += group.rung[i].attached
                     ? (group.rung[i + 1].position - group.rung[i].position).norm()
                     : 0.0;
    }
    return std::min(kHighestRow, grading.lengthAt(group.edgeLength, front / 4) / group.edgeLength);
}

BladeAdvance reparametrize(const Blade& blade, double h, std::vector<RungNode>& rung) {
    const Vec3 along = blade.b - blade.a;
    const double least = kLeastPassing * h / along.norm();
    BladeAdvance motion;
    double previous = -1e300;
    for (RungNode& node : rung) {
        node.s = (node.position - blade.a).dot(along) / along.squaredNorm();
        if (node.s <= previous) {
            node.s = previous + least;
        }
        previous = node.s;
        const Vec3 onLine = blade.a + along * node.s;
        motion.advance = std::max(motion.advance, (node.position - onLine).norm());
        motion.anyAttached = motion.anyAttached || node.attached;
    }
    motion.axial =
        std::max((rung.front().position - blade.a).norm(), (rung.back().position - blade.b).norm());
    return motion;
}

bool isWithdrawing(const SurfaceMesh& mesh, const Blade& blade, double h, const Vec3& lastAdvance,
                   const std::vector<RungNode>& rung) {
    double total = 0;
    double backwards = 0;
    for (std::size_t i = 0; i + 1 < rung.size(); ++i) {
        if (!rung[i].attached) {
            continue;
        }
        const FrontMotion motion = frontMotion(mesh, blade, h, lastAdvance, rung[i], rung[i + 1]);
        total += motion.length;
        backwards += motion.backwards ? motion.length : 0;
    }
    return total > 0 && backwards > kBackwardShare * total;
}

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
