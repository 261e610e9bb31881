#include "tests/support/step_bench.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "sim/cut/stroke/group_stroke.h"
#include "sim/cut/stroke/ladder.h"
#include "sim/mesh/invariants.h"
#include "tests/support/shapes.h"

namespace kerf::test {

namespace {

constexpr double kTolerance = 1e-9;    // of exact positions, share of h
constexpr double kReach = 3;           // of searches, share of h
constexpr double kOpening = 0.1;       // of slits, share of h
constexpr double kInTriangle = -1e-9;  // least weight of a point in a triangle
constexpr double kMostRefused = 0.01;  // of random steps
constexpr std::uint64_t kSeed = 1;

bool isInAir(const std::vector<RungNode>& rung) {
    return std::ranges::all_of(rung, [](const RungNode& node) { return node.vertex < 0; });
}

bool liesAtRest(const SurfaceMesh& mesh) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.position(v) != mesh.restPosition(v) || !mesh.velocity(v).isZero(0)) {
            return false;
        }
    }
    return true;
}

/// Numbers that are the same on every platform.
class Dice {
  public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_()) * 0x1p-32);
    }
    int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
    Vec3 inBox(double size) {
        const double x = uniform(-size, size);
        const double y = uniform(-size, size);
        return {x, y, uniform(-size, size)};
    }

  private:
    std::mt19937 engine_;
};

SurfaceMesh randomBody(Dice& dice) {
    switch (dice.below(5)) {
        case 0:
            return icosphere(1);
        case 1:
            return icosphere(2);
        case 2:
            return box(Vec3(0.9, 0.7, 1.1), 2);
        case 3:
            return torus(12, 6);
        default:
            return bentTube(12, 8);
    }
}

/// Bends the body where it is, and lets it move.
void deform(SurfaceMesh& mesh, Dice& dice) {
    const Vec3 bend = dice.inBox(0.15);
    const Vec3 shift = dice.inBox(0.1);
    const Vec3 spin = dice.inBox(2);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 rest = mesh.restPosition(v);
        const Vec3 wave(std::sin(3 * rest.y()), std::sin(3 * rest.z()), std::sin(3 * rest.x()));
        mesh.setPosition(v, rest + shift + bend.cwiseProduct(wave));
        mesh.setVelocity(v, spin.cross(rest) + 10 * shift);
    }
}

/// Right through the body, or with the end B inside.
std::vector<Blade> randomStroke(Dice& dice) {
    const Vec3 along = dice.inBox(1).normalized();
    const Vec3 travel = along.cross(dice.inBox(1)).normalized();
    const Vec3 turn = dice.inBox(0.1);
    const Vec3 middle = dice.inBox(0.2);
    const double beyond = dice.below(3) == 0 ? dice.uniform(-0.1, 0.1) : 1.4;
    const int steps = 3 + dice.below(4);
    const double depth = dice.uniform(-0.2, 0.9);
    std::vector<Blade> stroke;
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const Vec3 at = middle + travel * (-0.9 + (0.9 + depth) * share);
        const Vec3 way = (along + share * turn).normalized();
        stroke.push_back({at - 1.4 * way, at + beyond * way});
    }
    return stroke;
}

}  // namespace

StepBench::StepBench(const SurfaceMesh& body, double h) : mesh(body), h_(h) {}

void StepBench::startTransit() {
    ++transit_;
    firstVertexOfTransit_ = mesh.vertexCount();
    onSeams_.clear();
    sides_.clear();
    flushSides_.clear();
}

void StepBench::begin(const Blade& at) {
    ++stroke_;
    surface_.emplace(mesh);
    startTransit();
    rung_ = {{at.a, 0, -1, false}, {at.b, 1, -1, false}};
}

cut::StepInput StepBench::stepTo(const Blade& to) {
    stepRung_ = rung_;
    cut::followMesh(mesh, stepRung_);
    cut::reparametrize(to, h_, stepRung_);
    pieceOfVertex_ = findPieces(mesh).ofVertex;
    std::vector<Vec3> points{to.a, to.b};
    for (const RungNode& node : stepRung_) {
        points.push_back(node.position);
    }
    tree_.emplace(mesh);
    broadPhase_.emplace(mesh, *tree_, to, points, kReach * h_, h_, [](int) { return true; });
    opening_ = seesSlitsOpen ? cut::SlitOpening(mesh, *broadPhase_,
                                                {stepRung_, to, h_, stroke_, firstVertexOfTransit_,
                                                 onSeams_, sides_, kOpening, false})
                             : cut::SlitOpening();
    Bounds around = meshBounds(mesh);
    around.widen(kReach * h_);
    return {.mesh = mesh,
            .broadPhase = *broadPhase_,
            .pieceOfVertex = pieceOfVertex_,
            .surface = *surface_,
            .opening = opening_,
            .rung = stepRung_,
            .blade = to,
            .span = {},
            .h = h_,
            .offset = offset,
            .edgeLengths = edgeLengths_,
            .seed = kSeed,
            .stroke = stroke_,
            .transit = transit_,
            .firstVertexOfTransit = firstVertexOfTransit_,
            .attempt = cut::attemptAt(cut::Level::asIs, kTolerance),
            .body = around,
            .atRest = liesAtRest(mesh),
            .flushSides = flushSides_};
}

cut::CommitResult StepBench::carryOut(const cut::PlannedStep& step) {
    if (step.air) {
        rung_ = {step.plan.endA, step.plan.endB};
        return {};
    }
    cut::CommitResult result = cut::commit(mesh, step.plan, h_, stroke_, {});
    onSeams_.insert(result.onSeams.begin(), result.onSeams.end());
    rung_ = result.rung;
    if (isInAir(rung_)) {
        startTransit();
    }
    return result;
}

cut::CommitResult StepBench::cutTo(const Blade& to) {
    return carryOut(cut::planStep(stepTo(to)));
}

std::optional<cut::PlannedStep> planned(const cut::StepInput& in) {
    try {
        return cut::planStep(in);
    } catch (const cut::StepFailure&) {
        return std::nullopt;
    }
}

Stages stagesOf(const cut::StepInput& in) {
    Stages stages;
    cut::PredicatePositions positions(in);
    stages.strip = cut::buildStrip(in, positions);
    cut::CutCurves curves = cut::intersect(in, stages.strip, positions);
    stages.met = curves;
    stages.outline =
        cut::traceOutline(in, stages.strip, cut::RestGuess(in, stages.strip, curves), curves);
    curves.append(stages.outline.nodes);
    stages.outlined = curves;
    stages.seamed = curves = cut::withSeams(in, curves);
    cut::Wall wall = cut::triangulateWall(in, stages.strip, stages.outline, curves);
    stages.sheets = std::move(wall.sheets);
    curves.append(wall.nodes);
    stages.walled = std::move(curves);
    return stages;
}

std::string reasonOf(const std::function<void()>& act) {
    try {
        act();
    } catch (const cut::StepFailure& failure) {
        return failure.reason;
    }
    return "";
}

int forRandomSteps(
    std::uint32_t seed, int strokes,
    const std::function<void(const cut::StepInput& in, const cut::PlannedStep& step)>& visit) {
    Dice dice(seed);
    std::optional<StepBench> bench;
    int shown = 0;
    int refused = 0;
    for (int i = 0; i < strokes && !::testing::Test::HasFailure(); ++i) {
        if (i % 2 == 0) {  // the second one meets the walls of the first
            bench.emplace(randomBody(dice), dice.uniform(0.15, 0.4));
            if (dice.below(2) == 0) {
                deform(bench->mesh, dice);
            }
        }
        const std::vector<Blade> stroke = randomStroke(dice);
        bench->begin(stroke.front());
        for (std::size_t k = 1; k < stroke.size() && !::testing::Test::HasFailure(); ++k) {
            const cut::StepInput in = bench->stepTo(stroke[k]);
            const std::optional<cut::PlannedStep> step = planned(in);
            if (step && !step->air) {
                visit(in, *step);
                ++shown;
            }
            refused += step ? 0 : 1;
            if (step && !::testing::Test::HasFailure()) {  // otherwise the next one reaches farther
                bench->carryOut(*step);
            }
        }
    }
    EXPECT_LE(refused, kMostRefused * shown);
    return shown;
}

SurfaceMesh unitTetrahedron() {
    return SurfaceMesh::fromTriangles({Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()},
                                      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

Blade bladeAt(double y, double z) {
    return {{-2, y, z}, {2, y, z}};
}

double doubleLayoutArea(const std::vector<cut::CutNode>& nodes, const Triangle& t) {
    const Vec2 u = nodes[t[1]].layout - nodes[t[0]].layout;
    const Vec2 v = nodes[t[2]].layout - nodes[t[0]].layout;
    return u.x() * v.y() - u.y() * v.x();
}

double layoutArea(const std::vector<cut::CutNode>& nodes,
                  const std::vector<cut::OutlineEdge>& edges) {
    double area = 0;
    for (const cut::OutlineEdge& edge : edges) {
        const Vec2& p = nodes[edge.from].layout;
        const Vec2& q = nodes[edge.to].layout;
        area += 0.5 * (p.x() * q.y() - p.y() * q.x());
    }
    return area;
}

std::optional<Vec3> placeInStrip(const cut::Strip& strip, const Vec2& layout) {
    for (const Triangle& t : strip.triangles) {
        const Vec2& a = strip.nodes[t[0]].layout;
        const Vec2 u = strip.nodes[t[1]].layout - a;
        const Vec2 v = strip.nodes[t[2]].layout - a;
        const Vec2 p = layout - a;
        const double area = u.x() * v.y() - u.y() * v.x();
        const double b = (p.x() * v.y() - p.y() * v.x()) / area;
        const double c = (u.x() * p.y() - u.y() * p.x()) / area;
        if (b > kInTriangle && c > kInTriangle && 1 - b - c > kInTriangle) {
            return (1 - b - c) * strip.nodes[t[0]].position + b * strip.nodes[t[1]].position +
                   c * strip.nodes[t[2]].position;
        }
    }
    return std::nullopt;
}

// By the solid angles of its triangles (van Oosterom and Strackee 1983).
double windingNumber(const SurfaceMesh& mesh, const Vec3& p) {
    double angle = 0;
    for (const int t : livingTriangles(mesh)) {
        const Triangle& corners = mesh.triangle(t);
        const Vec3 a = mesh.position(corners[0]) - p;
        const Vec3 b = mesh.position(corners[1]) - p;
        const Vec3 c = mesh.position(corners[2]) - p;
        const double x = a.norm(), y = b.norm(), z = c.norm();
        angle += 2 * std::atan2(a.dot(b.cross(c)),
                                x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
    }
    return angle / (4 * std::numbers::pi);
}

}  // namespace kerf::test
