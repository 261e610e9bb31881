#include "tests/support/moving_scenes.h"

#include <chrono>
#include <stdexcept>

#include "sim/mesh/invariants.h"
#include "tests/support/formatted.h"
#include "tests/support/scene_player.h"
#include "tests/support/shapes.h"

namespace kerf::test {

namespace {

constexpr double kClearance = 0.001;    // between body and floor at the start [m]
constexpr double kAboveFloor = 0.6;     // the lowest point of the hanging banana [m]
constexpr double kPinned = 0.1;         // of its length, at each end
constexpr double kHandAside = 0.09;     // of a slit, the middle of a hand [m]
constexpr double kHand = 0.1;           // its reach [m]
constexpr double kPull = 0.08;          // its way [m]
constexpr int kSteps = 120;             // of a stroke
constexpr double kHalfArmBlade = 0.12;  // reaches across one arm and not into the next [m]

Blade bladeAround(const Vec3& middle, const Vec3& along, double halfLength) {
    return {middle - along * halfLength, middle + along * halfLength};
}

Eigen::Matrix3d turned(double aboutZ, double aboutX) {
    return (Eigen::AngleAxisd(aboutX, Vec3::UnitX()) * Eigen::AngleAxisd(aboutZ, Vec3::UnitZ()))
        .toRotationMatrix();
}

SurfaceMesh onFloor(SurfaceMesh mesh, const Eigen::Matrix3d& turn) {
    double lowest = 1e300;
    for (const Vec3& p : mesh.positions()) {
        lowest = std::min(lowest, (turn * p).y());
    }
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 p = turn * mesh.position(v) + Vec3(0, kClearance - lowest, 0);
        mesh.setPosition(v, p);
        mesh.setRestPosition(v, p);
    }
    return mesh;
}

/// Turned, so that no edge is parallel to the blade.
SurfaceMesh roundBody(SurfaceMesh mesh) {
    return onFloor(std::move(mesh), turned(0.37, 0.21));
}

/// The banana as an arch that stands on its two ends.
SurfaceMesh arch() {
    SurfaceMesh mesh = builtin("banana");
    double bend = 0;
    for (const Vec3& p : mesh.positions()) {
        bend += std::fabs(p.x()) < 0.2 ? p.y() : -p.y();
    }
    return onFloor(std::move(mesh), turned(0, bend > 0 ? 0.0 : std::numbers::pi));
}

/// The banana with its middle lowest, above the floor.
SurfaceMesh hanging() {
    SurfaceMesh mesh = arch();
    const double high = meshBounds(mesh).high.y();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3& p = mesh.position(v);
        const Vec3 turnedOver(p.x(), kAboveFloor + high - p.y(), -p.z());
        mesh.setPosition(v, turnedOver);
        mesh.setRestPosition(v, turnedOver);
    }
    return mesh;
}

/// What lies in the last tenth of the box in x, at its low or at its high end.
Bounds endInX(const Bounds& box, bool high) {
    const double length = box.high.x() - box.low.x();
    Bounds end = box;
    (high ? end.low : end.high).x() =
        high ? box.high.x() - kPinned * length : box.low.x() + kPinned * length;
    return end;
}

/// Down through all that is there now: the blade along x, turned and tilted a little.
void cutDown(ScenePlayer& schedule) {
    const Bounds box = schedule.bounds();
    const double z = schedule.middle().z() + schedule.draw(0.12);
    const double yaw = schedule.draw(0.3);
    const double tilt = schedule.draw(0.1);
    const double lean = schedule.draw(0.1);
    const Vec3 along = Vec3(std::cos(yaw), tilt, std::sin(yaw)).normalized();
    const double top = box.high.y() + 0.18;
    const double bottom = box.low.y() - 0.2;
    schedule.stroke(
        [&](double u) {
            const double y = top + (bottom - top) * u;
            return bladeAround({box.center().x(), y, z + lean * (y - 0.5)}, along, 1.4);
        },
        kSteps);
}

SceneFigures throughOnFloor(const SceneRun& run, SurfaceMesh mesh) {
    ScenePlayer schedule(run, roundBody(std::move(mesh)));
    schedule.settle(60);
    cutDown(schedule);
    schedule.watch(run.stepsAfter);
    return schedule.finish(2);
}

SceneFigures throughAtRest(const SceneRun& run) {
    ScenePlayer schedule(run, roundBody(cubeSphere(8)), true);
    cutDown(schedule);
    schedule.watch(run.stepsAfter);
    return schedule.finish(2);
}

SceneFigures twice(const SceneRun& run) {
    ScenePlayer schedule(run, roundBody(cubeSphere(8)));
    schedule.settle(60);
    cutDown(schedule);
    schedule.watch(20);
    const Bounds box = schedule.bounds();
    const double x = schedule.middle().x() + schedule.draw(0.05);
    const double tilt = schedule.draw(0.05);
    const Vec3 along = Vec3(tilt, schedule.draw(0.03), 1).normalized();
    const double top = box.high.y() + 0.1;
    const double bottom = box.low.y() - 0.15;
    schedule.stroke(
        [&](double u) {
            return bladeAround({x, top + (bottom - top) * u, 0}, along, 3.5);
        },
        kSteps);
    schedule.watch(run.stepsAfter);
    return schedule.finish(4);
}

/// Through the middle of the banana, upwards or downwards.
void cutMiddle(ScenePlayer& schedule, bool upwards) {
    Bounds middle;
    for (const Vec3& p : schedule.mesh().positions()) {
        if (std::fabs(p.x()) < 0.1) {
            middle.add(p);
        }
    }
    const double x = schedule.draw(0.06);
    const double tilt = schedule.draw(0.08);
    const Vec3 along = Vec3(schedule.draw(0.15), tilt, 1).normalized();
    const double below = middle.low.y() - 0.1;
    const double above = middle.high.y() + 0.1;
    schedule.stroke(
        [&](double u) {
            const double y = upwards ? below + (above - below) * u : above + (below - above) * u;
            return bladeAround({x, y, 0}, along, 0.7);
        },
        60);
}

SceneFigures throughArch(const SceneRun& run, bool upwards) {
    ScenePlayer schedule(run, arch());
    schedule.settle(20);
    cutMiddle(schedule, upwards);
    schedule.watch(run.stepsAfter);
    return schedule.finish(2);
}

/// The banana hangs between its two ends and sags: upwards the cut opens, downwards it closes on
/// the blade.
SceneFigures throughHanging(const SceneRun& run, bool upwards) {
    ScenePlayer schedule(run, hanging());
    schedule.execute(Pin{endInX(schedule.bounds(), false)});
    schedule.execute(Pin{endInX(schedule.bounds(), true)});
    schedule.settle(200);
    cutMiddle(schedule, upwards);
    schedule.watch(run.stepsAfter);
    return schedule.finish(2);
}

double fromAxis(const Vec3& p) {
    return std::hypot(p.x(), p.z());
}

/// The end of the arm that reaches farthest in direction `toward`.
int armTip(const SurfaceMesh& mesh, const Vec3& toward) {
    int tip = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.position(v).dot(toward) > mesh.position(tip).dot(toward)) {
            tip = v;
        }
    }
    return tip;
}

/// The middle of that arm at this distance from the body's axis, by the edges that lead across it:
/// arms bend, so it need not lie below the line to the tip.
Vec3 armMiddle(const SurfaceMesh& mesh, int tip, double distance) {
    std::set<int> beyond{tip};
    std::vector<int> open{tip};
    Bounds section;
    while (!open.empty()) {
        const int v = open.back();
        open.pop_back();
        mesh.forEachOutgoing(v, [&](int h) {
            const int w = mesh.target(h);
            if (fromAxis(mesh.position(w)) < distance) {
                section.add(0.5 * (mesh.position(v) + mesh.position(w)));
            } else if (beyond.insert(w).second) {
                open.push_back(w);
            }
        });
    }
    return section.center();
}

void cutArm(ScenePlayer& schedule, int arm) {
    const double angle = arm * std::numbers::pi / 4 + schedule.draw(0.2);
    const SurfaceMesh& mesh = schedule.mesh();
    const int tip = armTip(mesh, {std::cos(angle), 0, std::sin(angle)});
    const double at = (0.62 + schedule.draw(0.06)) * fromAxis(mesh.position(tip));
    Vec3 middle = armMiddle(mesh, tip, at);
    Vec3 out = armMiddle(mesh, tip, 1.1 * at) - middle;
    out.y() = 0;
    out.normalize();
    const Vec3 across = out.cross(Vec3::UnitY());
    double top = 0;
    for (const Vec3& p : mesh.positions()) {
        const Vec3 aside = p - middle;
        if (std::fabs(aside.dot(out)) < 0.06 && std::fabs(aside.dot(across)) < 0.12) {
            top = std::max(top, p.y());
        }
    }
    const double high = top + 0.04;
    const double low = -0.08;
    const Vec3 along = (across + Vec3(0, schedule.draw(0.05), 0)).normalized();
    schedule.stroke(
        [&](double u) {
            middle.y() = high + (low - high) * u;
            return bladeAround(middle, along, kHalfArmBlade);
        },
        50);
}

void cutHead(ScenePlayer& schedule) {
    const Bounds box = schedule.bounds();
    const double y = (0.66 + schedule.draw(0.05)) * box.high.y();
    const double tilt = schedule.draw(0.05);
    const Vec3 along = Vec3(1, tilt, schedule.draw(0.2)).normalized();
    schedule.stroke(
        [&](double u) {
            return bladeAround({box.center().x(), y, -0.5 + u + box.center().z()}, along, 0.8);
        },
        60);
}

SceneFigures armThenHead(const SceneRun& run) {
    ScenePlayer schedule(run, onFloor(builtin("octopus"), turned(0, 0)));
    schedule.settle(40);
    cutArm(schedule, run.index);
    schedule.watch(20);
    cutHead(schedule);
    schedule.watch(run.stepsAfter);
    return schedule.finish(3);
}

/// Two shallow strokes over the top, the second one across the first. The tip keeps its depth
/// below the skin as the body sags.
void incise(ScenePlayer& schedule, bool alongZ) {
    const Bounds box = schedule.bounds();
    const Vec3 middle = schedule.middle();
    const double depth = 0.13 + schedule.draw(0.04);
    const double aside = schedule.draw(0.08);
    const double lean = schedule.draw(0.05);
    const double radius = 0.5 * (box.high.y() - box.low.y());
    schedule.stroke(
        [&](double u) {
            const double way = 0.36 * (2 * u - 1);
            const double skin = box.high.y() - radius + std::sqrt(radius * radius - way * way);
            const Vec3 flat = alongZ ? Vec3(aside, 0, way) : Vec3(way, 0, aside);
            const Vec3 tip(middle.x() + flat.x(), skin - depth, middle.z() + flat.z());
            return Blade{{tip.x() + lean, box.high.y() + 0.5, tip.z() + lean}, tip};
        },
        60, false);
}

SceneFigures incisions(const SceneRun& run) {
    ScenePlayer schedule(run, roundBody(cubeSphere(8)));
    schedule.settle(60);
    incise(schedule, false);
    schedule.watch(30);
    incise(schedule, true);
    schedule.watch(run.stepsAfter);
    return schedule.finish(1);
}

/// Hands on both sides of a slit along x over the top.
std::array<Vec3, 2> takeSides(ScenePlayer& schedule) {
    const Bounds box = schedule.bounds();
    const double radius = 0.5 * (box.high.y() - box.low.y());
    std::array<Vec3, 2> held;
    for (int hand = 0; hand < 2; ++hand) {
        const double aside = (2 * hand - 1) * kHandAside;
        held[hand] = schedule.middle() + Vec3(0, 0, aside);
        held[hand].y() = box.high.y() - radius + std::sqrt(radius * radius - aside * aside);
        schedule.execute(Grab{hand, held[hand], kHand});
    }
    return held;
}

/// Pulls the hands apart by `way` each in `steps` steps.
void pullApart(ScenePlayer& schedule, const std::array<Vec3, 2>& held, double way, int steps) {
    for (int i = 1; i <= steps; ++i) {
        for (int hand = 0; hand < 2; ++hand) {
            schedule.execute(Drag{hand, held[hand] + Vec3(0, 0, (2 * hand - 1) * way * i / steps)});
        }
        schedule.watch(1);
    }
}

/// The first incision is pulled open before the second one crosses it.
SceneFigures incisionsPulledOpen(const SceneRun& run) {
    ScenePlayer schedule(run, roundBody(cubeSphere(8)));
    schedule.settle(60);
    incise(schedule, false);
    schedule.watch(50);
    pullApart(schedule, takeSides(schedule), kPull, 100);
    schedule.watch(20);
    incise(schedule, true);
    schedule.watch(20);
    schedule.execute(Release{0});
    schedule.execute(Release{1});
    schedule.watch(run.stepsAfter);
    return schedule.finish(1);
}

SceneFigures randomPlane(const SceneRun& run, SurfaceMesh mesh) {
    ScenePlayer schedule(run, roundBody(std::move(mesh)));
    schedule.settle(60);
    const Bounds box = schedule.bounds();
    const Vec3 along = schedule.drawDirection();
    const Vec3 travel = along.cross(schedule.drawDirection()).normalized();
    const Vec3 middle = schedule.middle() + 0.1 * schedule.drawDirection();
    const double reach = 0.7 * box.diagonal();
    schedule.stroke(
        [&](double u) {
            return bladeAround(middle + travel * (reach * (2 * u - 1)), along, reach);
        },
        kSteps);
    schedule.watch(run.stepsAfter);
    return schedule.finish(2);
}

using Scene = std::function<SceneFigures(const SceneRun&)>;

const std::map<std::string, Scene>& scenes() {
    static const std::map<std::string, Scene> table{
        {"i sphere768", [](const SceneRun& run) { return throughOnFloor(run, cubeSphere(8)); }},
        {"i icosphere1280", [](const SceneRun& run) { return throughOnFloor(run, icosphere(3)); }},
        {"ii banana upwards", [](const SceneRun& run) { return throughHanging(run, true); }},
        {"ii banana downwards", [](const SceneRun& run) { return throughHanging(run, false); }},
        {"arch upwards", [](const SceneRun& run) { return throughArch(run, true); }},
        {"arch downwards", [](const SceneRun& run) { return throughArch(run, false); }},
        {"iii octopus", armThenHead},
        {"iv incisions pulled", incisionsPulledOpen},
        {"incisions", incisions},
        {"v at rest", throughAtRest},
        {"vi twice", twice},
        {"plane sphere768", [](const SceneRun& run) { return randomPlane(run, cubeSphere(8)); }},
        {"plane sphere80", [](const SceneRun& run) { return randomPlane(run, icosphere(1)); }},
        {"plane sphere20", [](const SceneRun& run) { return randomPlane(run, icosphere(0)); }},
        {"plane banana", [](const SceneRun& run) { return randomPlane(run, builtin("banana")); }},
    };
    return table;
}

}  // namespace

void SceneFigures::add(const SceneFigures& other) {
    runs += other.runs;
    attempted += other.attempted;
    refused += other.refused;
    longestRefusal = std::max(longestRefusal, other.longestRefusal);
    retried += other.retried;
    unseparated += other.unseparated;
    slitEdges += other.slitEdges;
    nonFinite += other.nonFinite;
    open += other.open;
    folded += other.folded;
    foldedSoon += other.foldedSoon;
    foldedAtPins += other.foldedAtPins;
    foldsInView += other.foldsInView;
    chips += other.chips;
    speedCutting = std::max(speedCutting, other.speedCutting);
    speedAfter = std::max(speedAfter, other.speedAfter);
    seconds += other.seconds;
}

const std::vector<std::string>& movingScenes() {
    static const std::vector<std::string> names{
        "i sphere768", "i icosphere1280",     "ii banana upwards", "ii banana downwards",
        "iii octopus", "iv incisions pulled", "v at rest",         "vi twice"};
    return names;
}

const std::vector<std::string>& furtherScenes() {
    static const std::vector<std::string> names{
        "arch upwards",   "arch downwards", "incisions",   "plane sphere768",
        "plane sphere80", "plane sphere20", "plane banana"};
    return names;
}

SceneFigures playScene(const SceneRun& run) {
    using Clock = std::chrono::steady_clock;
    const auto scene = scenes().find(run.scene);
    if (scene == scenes().end()) {
        throw std::invalid_argument("there is no scene " + run.scene);
    }
    const Clock::time_point start = Clock::now();
    SceneFigures figures = scene->second(run);
    figures.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return figures;
}

std::string sceneTableHead() {
    return "scene              E    runs  refused/steps  row retried whole slit-ends NaN open "
           " soon folds  mean at-pins chips  v cut/fall  v after d/s   s\n";
}

std::string sceneTableRow(const SceneRun& run, const SceneFigures& f) {
    return formatted(
        "%-18s %.0e %3d %8d/%-6d %4d %6d %5d %8d %4d %4d %5d %5d %5.2f %7d %5d %9.2f %13.5f "
        "%5.0f\n",
        run.scene.c_str(), run.youngsModulus, f.runs, f.refused, f.attempted, f.longestRefusal,
        f.retried, f.unseparated, f.slitEdges, f.nonFinite, f.open, f.foldedSoon, f.folded,
        f.foldsInView / static_cast<double>(kInView), f.foldedAtPins, f.chips, f.speedCutting,
        f.speedAfter, f.seconds);
}

}  // namespace kerf::test
