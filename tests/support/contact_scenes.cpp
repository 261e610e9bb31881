#include "tests/support/contact_scenes.h"

#include <ctime>

#include "sim/base/stopwatch.h"
#include "sim/body/body_model.h"
#include "sim/body/piece_masses.h"
#include "sim/body/rest_geometry.h"
#include "sim/cut/exact/jitter.h"
#include "sim/mesh/triangle.h"
#include "sim/run/simulation.h"
#include "tests/support/formatted.h"
#include "tests/support/self_intersections.h"
#include "tests/support/shapes.h"

namespace kerf::test {

namespace {

int stepsOf(double seconds, const Params& params) {
    return static_cast<int>(std::lround(seconds / params.timeStep));
}

void run(Simulation& simulation, int steps) {
    for (int i = 0; i < steps; ++i) {
        simulation.step();
    }
}

SurfaceMesh placed(SurfaceMesh mesh, const Eigen::Matrix3d& turn, const Vec3& by) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, turn * mesh.position(v) + by);
        mesh.setRestPosition(v, mesh.position(v));
    }
    return mesh;
}

double meanSquareSpeed(const SurfaceMesh& mesh) {
    double sum = 0;
    int count = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.outgoing(v) >= 0) {
            sum += mesh.velocity(v).squaredNorm();
            ++count;
        }
    }
    return sum / count;
}

/// RMS speed over some steps, in diagonals of the body a second.
double jitter(Simulation& simulation, int steps, double diagonal) {
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        simulation.step();
        sum += meanSquareSpeed(simulation.mesh());
    }
    return std::sqrt(sum / steps) / diagonal;
}

struct Solid {
    double volume = 0;
    Vec3 moment = Vec3::Zero();
    Vec3 centroid() const { return moment / volume; }
};

std::vector<Solid> solids(const SurfaceMesh& mesh, const PieceMap& pieces,
                          const std::vector<Vec3>& at) {
    std::vector<Solid> out(pieces.pieces.size());
    for (const int t : livingTriangles(mesh)) {
        const Triangle& corners = mesh.triangle(t);
        const Vec3& a = at[corners[0]];
        const Vec3& b = at[corners[1]];
        const Vec3& c = at[corners[2]];
        const double volume = tetrahedronVolume(a, b, c);
        Solid& solid = out[pieces.ofVertex[corners[0]]];
        solid.volume += volume;
        solid.moment += volume * (a + b + c) / 4;
    }
    return out;
}

/// How deep p lies inside a piece: its distance from the surface where the winding number is over a
/// half, 0 elsewhere. [m]
double depthInsidePiece(const SurfaceMesh& mesh, const std::vector<int>& piece, const Vec3& p) {
    double angle = 0;
    double nearest = 1e300;
    for (const int t : piece) {
        const Triangle& corners = mesh.triangle(t);
        const Vec3 a = mesh.position(corners[0]) - p;
        const Vec3 b = mesh.position(corners[1]) - p;
        const Vec3 c = mesh.position(corners[2]) - p;
        const double la = a.norm();
        const double lb = b.norm();
        const double lc = c.norm();
        angle += 2 * std::atan2(a.dot(b.cross(c)),
                                la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
        const Vec3 w = closestWeights(Vec3::Zero(), a, b, c);
        nearest = std::min(nearest, (w.x() * a + w.y() * b + w.z() * c).norm());
    }
    return std::fabs(angle) > 2 * std::numbers::pi ? nearest : 0.0;
}

}  // namespace

double depthInside(const SurfaceMesh& mesh, const Vec3& p) {
    return depthInsidePiece(mesh, livingTriangles(mesh), p);
}

namespace {

/// Of all vertices inside other pieces than their own [m].
double deepestPenetration(const SurfaceMesh& mesh, const PieceMap& pieces) {
    std::vector<std::vector<int>> triangles(pieces.pieces.size());
    std::vector<Bounds> boxes(pieces.pieces.size());
    for (const int t : livingTriangles(mesh)) {
        const int piece = pieces.ofVertex[mesh.triangle(t)[0]];
        triangles[piece].push_back(t);
        for (const int v : mesh.triangle(t)) {
            boxes[piece].add(mesh.position(v));
        }
    }
    double deepest = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        Bounds point;
        point.add(mesh.position(v));
        for (std::size_t p = 0; pieces.ofVertex[v] >= 0 && p < triangles.size(); ++p) {
            if (pieces.ofVertex[v] != static_cast<int>(p) && boxes[p].overlaps(point)) {
                deepest = std::max(deepest, depthInsidePiece(mesh, triangles[p], mesh.position(v)));
            }
        }
    }
    return deepest;
}

double heightOf(const SurfaceMesh& mesh) {
    const Bounds box = meshBounds(mesh);
    return box.high.y() - box.low.y();
}

/// Cuts right through, level, at this height.
void cutLevel(Simulation& simulation, double height) {
    constexpr int kSteps = 40;
    for (int i = 0; i <= kSteps; ++i) {
        const double z = 0.8 * (1 - 2.0 * i / kSteps);
        simulation.execute(MoveBlade{{{-0.9, height, z}, {0.9, height + 0.01, z}}});
        simulation.step();
    }
    simulation.execute(LiftBlade{});
    simulation.step();
}

}  // namespace

SurfaceMesh slitSphere(int steps) {
    Params params;
    params.contact = 1;
    params.gravity.setZero();
    params.floor.reset();
    Simulation simulation(cubeSphere(8), params);
    for (int i = 0; i <= steps; ++i) {
        const double y = 0.6 - 0.04 * i;
        simulation.execute(MoveBlade{{{-0.9, y, 0.03}, {0.9, y + 0.02, 0.05}}});
        simulation.step();
    }
    simulation.execute(LiftBlade{});
    simulation.step();
    return simulation.mesh();
}

HalvesFigures restHalves(bool sphere, const Params& params, double seconds) {
    const SurfaceMesh body = placed(sphere ? cubeSphere(8) : box({0.9, 0.7, 0.8}, 6),
                                    Eigen::Matrix3d::Identity(), {0, sphere ? 0.5 : 0.35, 0});
    const double diagonal = meshBounds(body).diagonal();
    Simulation whole(body, params);
    run(whole, stepsOf(seconds - 0.5, params));
    HalvesFigures figures;
    figures.wholeJitter = jitter(whole, stepsOf(0.5, params), diagonal);

    Params weightless = params;
    weightless.gravity.setZero();
    Simulation halves(body, weightless);
    cutLevel(halves, sphere ? 0.5 : 0.36);
    halves.execute(SetParam{"gravity", params.gravity});
    run(halves, stepsOf(seconds - 0.5, params));
    figures.jitter = jitter(halves, stepsOf(0.5, params), diagonal);
    figures.contacts = halves.report().contacts;
    const SurfaceMesh& mesh = halves.mesh();
    const std::vector<Solid> now = solids(mesh, halves.pieces(), mesh.positions());
    const std::vector<Solid> rest = solids(mesh, halves.pieces(), mesh.restPositions());
    if (now.size() == 2) {
        const Vec3 apart = now[1].centroid() - now[0].centroid();
        figures.separation =
            std::fabs(apart.y()) / std::fabs((rest[1].centroid() - rest[0].centroid()).y());
        figures.shift = std::hypot(apart.x(), apart.z()) / diagonal;
    }
    figures.height = heightOf(mesh) / heightOf(whole.mesh());
    figures.penetration = deepestPenetration(mesh, halves.pieces()) / diagonal;
    return figures;
}

std::string text(const HalvesFigures& f) {
    return formatted(
        "separation %.4f  height %.4f  shift %.4f diag  penetration %.2e diag  jitter %.6f "
        "diag/s (whole %.6f)  contacts %d",
        f.separation, f.height, f.shift, f.penetration, f.jitter, f.wholeJitter, f.contacts);
}

namespace {

Vec3 restCenter(const SurfaceMesh& mesh, int t) {
    const Triangle& corners = mesh.triangle(t);
    return (mesh.restPosition(corners[0]) + mesh.restPosition(corners[1]) +
            mesh.restPosition(corners[2])) /
           3;
}

bool closeInRest(const SurfaceMesh& mesh, int a, int b) {
    constexpr double kClose = 3;  // mean edge lengths
    return (restCenter(mesh, a) - restCenter(mesh, b)).norm() < kClose * meanRestEdgeLength(mesh);
}

}  // namespace

OctopusFigures dropOctopus(const Params& params) {
    SurfaceMesh mesh = builtin("octopus");
    const Bounds box = meshBounds(mesh);
    mesh = placed(std::move(mesh), Eigen::Matrix3d::Identity(), {0, 0.5 - box.low.y(), 0});
    OctopusFigures figures;
    figures.intersectionsAtStart = static_cast<int>(selfIntersections(mesh).size());
    Simulation simulation(std::move(mesh), params);
    for (int i = 0; i < stepsOf(2.5, params); ++i) {
        figures.mostContacts = std::max(figures.mostContacts, simulation.step().contacts);
    }
    figures.jitter = jitter(simulation, stepsOf(0.5, params), box.diagonal());
    const SurfaceMesh& now = simulation.mesh();
    for (const auto& [a, b] : selfIntersections(now)) {
        ++figures.intersections;
        figures.folds += closeInRest(now, a, b);
    }
    return figures;
}

std::string text(const OctopusFigures& f) {
    return formatted(
        "intersections %d at the start, %d at the end (%d of close neighbours)  most "
        "contacts %d  jitter %.5f "
        "diag/s",
        f.intersectionsAtStart, f.intersections, f.folds, f.mostContacts, f.jitter);
}

namespace {

/// Milliseconds of each step.
std::vector<double> stepTimes(const SurfaceMesh& mesh, const Params& params, int steps) {
    Simulation simulation(mesh, params);
    std::vector<double> times;
    for (int i = 0; i < steps; ++i) {
        const Stopwatch watch;
        simulation.step();
        times.push_back(watch.milliseconds());
    }
    return times;
}

double median(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + values.size() / 2);
    return values[values.size() / 2];
}

}  // namespace

SpeedFigures timeDrop(const std::string& model, const Params& given, double seconds) {
    SurfaceMesh mesh = builtin(model);
    const double lift = 0.2 - meshBounds(mesh).low.y();
    mesh = placed(std::move(mesh), Eigen::Matrix3d::Identity(), {0, lift, 0});
    Params params = given;
    params.contact = 0;
    const std::vector<double> plain = stepTimes(mesh, params, stepsOf(seconds, params));
    params.contact = 1;
    const std::vector<double> touching = stepTimes(mesh, params, stepsOf(seconds, params));
    return {median(plain), median(touching), std::accumulate(plain.begin(), plain.end(), 0.0),
            std::accumulate(touching.begin(), touching.end(), 0.0),
            static_cast<long>(plain.size())};
}

std::string text(const SpeedFigures& f) {
    return formatted(
        "%ld steps, without contact %.2f ms, with %.2f ms (medians), ratio %.2f, of all "
        "steps together %.2f",
        f.steps, f.plain, f.touching, f.touching / f.plain, f.touchingSum / f.plainSum);
}

namespace {

constexpr int kCrowdSide = 8;
constexpr double kCrowdRadius = 0.1;

TriangleSoup crowdSoup() {
    const TriangleSoup one = icosphereSoup(2, kCrowdRadius);
    TriangleSoup all;
    for (int i = 0; i < kCrowdSide * kCrowdSide; ++i) {
        const int row = i / kCrowdSide;
        const Vec3 cell(i % kCrowdSide, 0, row);
        all = joined(all, one, 2.1 * kCrowdRadius * cell);
    }
    return all;
}

/// Each piece another way, upwards rather than down.
void throwApart(SurfaceMesh& mesh, double speed) {
    cut::Jitter random(1);
    const int each = mesh.vertexCount() / (kCrowdSide * kCrowdSide);
    Vec3 velocity = Vec3::Zero();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (v % each == 0) {
            velocity = speed * random.direction();
            velocity.y() = std::abs(velocity.y());
        }
        mesh.setVelocity(v, velocity);
    }
}

/// Of all threads, of which llvmpipe's are some.
double processorMilliseconds() {
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::vector<double> processorTimes(Simulation& simulation, int steps) {
    std::vector<double> times;
    for (int i = 0; i < steps; ++i) {
        const double start = processorMilliseconds();
        simulation.step();
        times.push_back(processorMilliseconds() - start);
    }
    return times;
}

}  // namespace

CrowdFigures throwCrowd(double speed, const Params& given, int steps) {
    Params params = given;
    params.contact = 1;
    SurfaceMesh mesh = meshOf(crowdSoup());
    params.floor = meshBounds(mesh).low.y();
    CrowdFigures figures;
    figures.vertices = mesh.vertexCount();
    {
        Simulation lying(mesh, params);
        for (int i = 0; i < stepsOf(0.5, params); ++i) {
            lying.step();
        }
        figures.lying = median(processorTimes(lying, steps));
    }
    throwApart(mesh, speed);
    Simulation thrown(std::move(mesh), params);
    const std::vector<double> times = processorTimes(thrown, steps);
    figures.thrown = median(times);
    figures.longest = std::ranges::max(times);
    figures.stateHash = thrown.stateHash();
    return figures;
}

std::string text(const CrowdFigures& f) {
    return formatted(
        "%d vertices, processor time of a step: lying %.1f ms, thrown %.1f ms (medians), "
        "ratio %.2f, longest %.1f ms; ends as %s",
        f.vertices, f.lying, f.thrown, f.thrown / f.lying, f.longest, f.stateHash.c_str());
}

namespace {

/// In layers of 16 that lie askew, each turned another way.
TriangleSoup pouredSoup() {
    constexpr int kSide = 4;
    constexpr int kBalls = 144;
    constexpr double kApart = 0.23;
    cut::Jitter random(1);
    TriangleSoup all;
    for (int i = 0; i < kBalls; ++i) {
        TriangleSoup ball = icosphereSoup(2, 0.1);
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(random.uniform(0, 6.28), random.direction()).toRotationMatrix();
        for (Vec3& p : ball.positions) {
            p = turn * p;
        }
        const int layer = i / (kSide * kSide);
        const int row = i / kSide % kSide;
        const Vec3 cell(i % kSide, layer, row);
        all = joined(all, ball, kApart * cell + 0.014 * random.direction());
    }
    return all;
}

CostFigures costOf(Simulation& simulation, int steps) {
    CostFigures figures;
    figures.steps = steps;
    double deform = 0;
    double collide = 0;
    for (int i = 0; i < steps; ++i) {
        const StepReport& report = simulation.step();
        deform += report.times.deform;
        collide += report.times.collide;
        figures.deform += report.times.deform;
        figures.collide += report.times.collide;
        figures.mostContacts = std::max(figures.mostContacts, report.contacts);
        if ((i + 1) % std::max(steps / 10, 1) == 0) {
            figures.worst = std::max(figures.worst, collide / deform);
            deform = collide = 0;
        }
    }
    figures.triangles = simulation.report().triangles;
    figures.stateHash = simulation.stateHash();
    return figures;
}

}  // namespace

CostFigures pourBalls(const Params& given, double seconds) {
    Params params = given;
    params.contact = 1;
    SurfaceMesh mesh = meshOf(pouredSoup());
    params.floor = meshBounds(mesh).low.y() - 0.05;
    Simulation simulation(std::move(mesh), params);
    return costOf(simulation, stepsOf(seconds, params));
}

CostFigures dropHalves(int triangles, const Params& given, double seconds) {
    Params params = given;
    params.contact = 0;
    params.gravity.setZero();
    const int fine = static_cast<int>(std::lround(std::sqrt(triangles / 12.0)));
    SurfaceMesh body = placed(cubeSphere(fine), Eigen::Matrix3d::Identity(), {0, 0.55, 0});
    Simulation simulation(std::move(body), params);
    cutLevel(simulation, 0.55);
    simulation.execute(SetParam{"gravity", given.gravity});
    simulation.execute(SetParam{"contact", 1.0});
    return costOf(simulation, stepsOf(seconds, params));
}

std::string text(const CostFigures& f) {
    return formatted(
        "%d triangles, %d steps: deform %.1f ms, collide %.1f ms a step, ratio %.2f, in "
        "the worst tenth %.2f; most contacts %d; ends as %s",
        f.triangles, f.steps, f.deform / f.steps, f.collide / f.steps, f.collide / f.deform,
        f.worst, f.mostContacts, f.stateHash.c_str());
}

CollisionFigures collideSpheres(const Params& given) {
    Params params = given;
    params.gravity.setZero();
    params.floor.reset();
    params.airDrag = 0;
    const TriangleSoup lower = cubeSphereSoup(4, 0.4);
    SurfaceMesh mesh = meshOf(joined(lower, icosphereSoup(2, 0.4), {0.2, 0.9, 0.1}));
    mesh = placed(std::move(mesh), Eigen::Matrix3d::Identity(), {-0.1, -0.45, -0.05});
    for (int v = static_cast<int>(lower.positions.size()); v < mesh.vertexCount(); ++v) {
        mesh.setVelocity(v, {0, -3, 0});
    }
    const std::vector<double> masses = unitMasses(buildBodyModel(mesh));
    Simulation simulation(std::move(mesh), params);
    const auto momentum = [&] {
        std::pair<Vec3, Vec3> sum{Vec3::Zero(), Vec3::Zero()};
        const SurfaceMesh& now = simulation.mesh();
        for (int v = 0; v < now.vertexCount(); ++v) {
            sum.first += masses[v] * now.velocity(v);
            sum.second += masses[v] * now.position(v).cross(now.velocity(v));
        }
        return sum;
    };
    const auto before = momentum();
    const double diagonal = meshBounds(simulation.mesh()).diagonal();
    const double energy = simulation.report().kineticEnergy;
    CollisionFigures figures;
    for (int i = 0; i < 120; ++i) {
        figures.stepsInContact += simulation.step().contacts > 0;
        if (i % 5 == 0) {
            const double depth = deepestPenetration(simulation.mesh(), simulation.pieces());
            figures.penetration = std::max(figures.penetration, depth / diagonal);
        }
    }
    figures.energyLeft = simulation.report().kineticEnergy / energy;
    const auto after = momentum();
    figures.parted = simulation.report().contacts == 0;
    figures.linearDrift = (after.first - before.first).norm() / before.first.norm();
    figures.angularDrift = (after.second - before.second).norm() / before.second.norm();
    return figures;
}

std::string text(const CollisionFigures& f) {
    return formatted(
        "%d steps in contact, parted %d  drift of momentum %.2e, of angular momentum %.2e  energy "
        "left %.3f  deepest %.2e diag",
        f.stepsInContact, f.parted, f.linearDrift, f.angularDrift, f.energyLeft, f.penetration);
}

namespace {

TriangleSoup drawnSoup(cut::Jitter& draw) {
    switch (static_cast<int>(draw.uniform(0, 5))) {
        case 0:
            return icosphereSoup(1, 0.4);
        case 1:
            return cubeSphereSoup(6, 0.4);
        case 2:
            return torusSoup(20, 10);
        case 3:
            return boxSoup({0.6, 0.3, 0.5}, 4);
        default:
            return bentTubeSoup();
    }
}

Eigen::Matrix3d drawnTurn(cut::Jitter& draw) {
    return Eigen::AngleAxisd(draw.uniform(0, 6.28), draw.direction()).toRotationMatrix();
}

TriangleSoup turned(TriangleSoup soup, const Eigen::Matrix3d& turn) {
    for (Vec3& p : soup.positions) {
        p = turn * p;
    }
    return soup;
}

/// Somewhere around the place where bodies land, above the floor or half in it.
StaticBox drawnBox(cut::Jitter& draw) {
    StaticBox box;
    box.center = {draw.uniform(-0.6, 0.6), draw.uniform(0, 0.15), draw.uniform(-0.6, 0.6)};
    box.size = {draw.uniform(0.02, 0.5), draw.uniform(0.02, 0.3), draw.uniform(0.02, 0.5)};
    box.rotate = {draw.uniform(0, 90), draw.uniform(0, 90), draw.uniform(0, 90)};
    return box;
}

double deepestInBox(const StaticBox& box, const SurfaceMesh& mesh) {
    double deepest = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 at = box.axes().transpose() * (mesh.position(v) - box.center);
        deepest = std::max(deepest, (0.5 * box.size - at.cwiseAbs()).minCoeff());
    }
    for (int corner = 0; corner < 8; ++corner) {
        deepest = std::max(deepest, depthInside(mesh, box.corner(corner)));
    }
    return deepest;
}

}  // namespace

RandomDropFigures dropAtRandom(const DropRun& drop, const Params& params) {
    cut::Jitter draw(drop.seed * 7919 + static_cast<std::uint64_t>(drop.index) * 104729);
    TriangleSoup soup = turned(drawnSoup(draw), drawnTurn(draw));
    const bool two = draw.uniform(0, 1) < 0.7;
    const int first = static_cast<int>(soup.positions.size());
    if (two) {
        const Vec3 above(draw.uniform(-0.2, 0.2), 1.25, draw.uniform(-0.2, 0.2));
        soup = joined(soup, turned(drawnSoup(draw), drawnTurn(draw)), above);
    }
    SurfaceMesh mesh = meshOf(soup);
    const double lift = draw.uniform(0.1, 1.5) - meshBounds(mesh).low.y();
    mesh = placed(std::move(mesh), Eigen::Matrix3d::Identity(), {0, lift, 0});
    const Vec3 lower = draw.uniform(0, 2) * draw.direction();
    const Vec3 upper = Vec3(0, -draw.uniform(0, 6), 0) + draw.uniform(0, 1) * draw.direction();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setVelocity(v, v < first ? lower : upper);
    }
    const double size = meshBounds(mesh).diagonal();
    std::vector<StaticBox> boxes(static_cast<std::size_t>(draw.uniform(0, 4)));
    std::ranges::generate(boxes, [&] { return drawnBox(draw); });
    Simulation simulation(std::move(mesh), params, boxes);
    RandomDropFigures figures;
    figures.runs = 1;
    for (int i = 0; i < stepsOf(1.5, params); ++i) {
        simulation.step();
        for (const std::string& message : simulation.takeMessages()) {
            figures.nonFinite += message.find("range of numbers") != std::string::npos;
        }
    }
    const SurfaceMesh& now = simulation.mesh();
    const Bounds box = meshBounds(now);
    figures.escaped = box.low.y() < -0.02 || box.diagonal() > 10 * size;
    double deepest = deepestPenetration(now, simulation.pieces());
    for (const StaticBox& stands : boxes) {
        deepest = std::max(deepest, deepestInBox(stands, now));
    }
    figures.tunnels = deepest > 0.03;
    const PieceMap& pieces = simulation.pieces();
    for (const auto& [a, b] : selfIntersections(now)) {
        const bool onePiece =
            pieces.ofVertex[now.triangle(a)[0]] == pieces.ofVertex[now.triangle(b)[0]];
        ++(onePiece && closeInRest(now, a, b) ? figures.crumpled : figures.intersections);
    }
    return figures;
}

void RandomDropFigures::add(const RandomDropFigures& other) {
    runs += other.runs;
    nonFinite += other.nonFinite;
    escaped += other.escaped;
    tunnels += other.tunnels;
    intersections += other.intersections;
    crumpled += other.crumpled;
}

std::string text(const RandomDropFigures& f) {
    return formatted(
        "%d runs, not finite %d, escaped %d, tunnels %d, intersecting pairs %d, of close "
        "neighbours %d more",
        f.runs, f.nonFinite, f.escaped, f.tunnels, f.intersections, f.crumpled);
}

}  // namespace kerf::test
