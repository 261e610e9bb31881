#include "sim/cut/exact/jitter.h"

namespace kerf {
namespace {

using cut::Jitter;

// A blade that lies in the rays of an eye, as one drawn in the window does, goes round an axis and
// over its own start.

struct Model {
    const char* name;
    SurfaceMesh mesh;
    Vec3 middle;      ///< of what the loop goes round
    double room = 0;  ///< a loop of this radius lies within the body, seen from anywhere [m]
};

Model modelOf(int kind) {
    switch (kind) {
        case 0:
            return {"sphere of 80", icosphere(1), Vec3::Zero(), 0.36};
        case 1:
            return {"sphere of 768", cubeSphere(8), Vec3::Zero(), 0.4};
        case 2:
            return {"sphere of 1280", icosphere(3), Vec3::Zero(), 0.4};
        case 3:
            return {"graded sphere", gradedSphere(), Vec3::Zero(), 0.4};
        case 4:
            return {"ring", torus(), Vec3(0.35, 0, 0), 0.12};
        default:
            return {"box", test::box(Vec3(0.8, 0.7, 0.9), 4), Vec3::Zero(), 0.3};
    }
}
constexpr int kModels = 6;

struct Loop {
    int model = 0;
    Vec3 eye;
    Vec3 axis;    ///< from the eye to the middle
    Vec3 across;  ///< at angle 0
    double radius = 0;
    double wave = 0;    ///< by which the radius changes on the way round, as a share
    double start = 0;   ///< angle
    double turn = 1;    ///< the direction
    double step = 0;    ///< way of the blade in a step, edge lengths
    double over = 0;    ///< how far it goes on over its start, edge lengths
    double aside = 0;   ///< how far it misses its start, edge lengths
    double length = 0;  ///< of the blade [m]
};

double edgeLengthOf(const SurfaceMesh& mesh, const Vec3& middle, double radius) {
    SurfaceMesh copy = mesh;
    Cutter cutter(copy, CutSettings{});
    cutter.begin({middle + Vec3(radius, 2, 0), middle + Vec3(radius, -2, 0)});
    return cutter.edgeLengthAtFront();
}

Loop randomLoop(std::uint64_t seed) {
    Jitter jitter(seed);
    Loop loop;
    loop.model = static_cast<int>(jitter.uniform() * kModels);
    const Model model = modelOf(loop.model);
    loop.axis = jitter.direction();
    if (loop.model == 4) {
        loop.axis = Vec3(jitter.uniform(-0.2, 0.2), 1, jitter.uniform(-0.2, 0.2)).normalized();
    }
    loop.eye = model.middle - loop.axis * jitter.uniform(2, 5);
    loop.across = loop.axis.unitOrthogonal();
    loop.radius = model.room * jitter.uniform(0.6, 0.85);
    loop.wave = jitter.uniform(0, 0.12);
    loop.start = jitter.uniform(0, 2 * M_PI);
    loop.turn = jitter.uniform() < 0.5 ? 1 : -1;
    loop.step = jitter.uniform(0.15, 1.1);
    loop.over = jitter.uniform(0.2, 3);
    loop.aside = jitter.uniform() < 0.3 ? 0 : jitter.uniform(-0.1, 0.1);
    loop.length = jitter.uniform(1.6, 3);
    return loop;
}

double radiusAt(const Loop& loop, double angle) {
    return loop.radius * (1 + loop.wave * std::sin(3 * angle));
}

/// The blade at `turned` [rad] from the start, its middle `aside` [m] off.
Blade bladeAt(const Loop& loop, const Vec3& middle, double turned, double aside) {
    const double angle = loop.start + loop.turn * turned;
    const Vec3 out = std::cos(angle) * loop.across + std::sin(angle) * loop.axis.cross(loop.across);
    const Vec3 through = middle + out * (radiusAt(loop, angle) + aside);
    const Vec3 ray = (through - loop.eye).normalized();
    return {through - 0.5 * loop.length * ray, through + 0.5 * loop.length * ray};
}

Stroke strokeOf(const Loop& loop, const Model& model, double h) {
    const double whole = 2 * M_PI + loop.over * h / loop.radius;
    const int steps = static_cast<int>(std::ceil(whole * loop.radius / (loop.step * h)));
    Stroke stroke;
    for (int i = 0; i <= steps; ++i) {
        const double turned = whole * i / steps;
        const double aside = loop.aside * h * std::min(1.0, turned / (2 * M_PI));
        stroke.push_back(bladeAt(loop, model.middle, turned, aside));
    }
    return stroke;
}

/// Pieces that lie both inside and outside of the cone of a loop, by `least` [m] to count.
int piecesAcross(const SurfaceMesh& mesh, const Loop& loop, const Vec3& middle, double least) {
    const PieceMap map = findPieces(mesh);
    const double distance = (middle - loop.eye).norm();
    const Vec3 up = loop.axis.cross(loop.across);
    std::vector<std::array<bool, 2>> sides(map.pieces.size(), {false, false});
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 from = mesh.position(v) - loop.eye;
        const Vec3 seen = from * (distance / from.dot(loop.axis));
        const double angle = std::atan2(seen.dot(up), seen.dot(loop.across));
        const double beyond = (seen - loop.axis * distance).norm() - radiusAt(loop, angle);
        if (map.ofVertex[v] >= 0 && std::fabs(beyond) > least) {
            sides[map.ofVertex[v]][beyond > 0 ? 1 : 0] = true;
        }
    }
    return static_cast<int>(
        std::ranges::count_if(sides, [](const auto& s) { return s[0] && s[1]; }));
}

std::string describe(const Loop& loop) {
    return std::string(modelOf(loop.model).name) + ", radius " + std::to_string(loop.radius) +
           ", step " + std::to_string(loop.step) + ", over " + std::to_string(loop.over) +
           ", aside " + std::to_string(loop.aside) + ", turn " + std::to_string(loop.turn);
}

struct Outcome {
    CutCheck check;
    int pieces = 0;
    int across = 0;
};

Outcome cutOut(const Loop& loop) {
    Model model = modelOf(loop.model);
    const double h = edgeLengthOf(model.mesh, model.middle, loop.radius);
    Cutter cutter(model.mesh, CutSettings{});
    Outcome outcome;
    outcome.check = runStroke(cutter, model.mesh, strokeOf(loop, model, h));
    outcome.pieces = static_cast<int>(findPieces(model.mesh).pieces.size());
    outcome.across = piecesAcross(model.mesh, loop, model.middle, 0.4 * h);
    return outcome;
}

TEST(ClosedLoop, GivesThePieceThatItEncloses) {
    const std::uint32_t first = fuzzSeed(2511);
    const auto runs = static_cast<std::uint32_t>(test::runs("KERF_FUZZ_RUNS", 24, 240));
    std::uint32_t whole = 0;
    for (std::uint32_t seed = first; seed < first + runs; ++seed) {
        const Loop loop = randomLoop(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + describe(loop));
        const Outcome outcome = cutOut(loop);
        EXPECT_EQ(outcome.check.problem, "");
        EXPECT_EQ(outcome.check.unmirrored, "");
        EXPECT_EQ(outcome.check.refused, 0) << outcome.check.reason;
        EXPECT_EQ(outcome.across, 0) << "a piece lies on both sides";
        EXPECT_GE(outcome.pieces, 2);
        whole += outcome.across > 0;
    }
    std::cout << runs << " loops from seed " << first << ", " << whole << " left whole\n";
}

// As one draws them: round in even steps, and on over the first of them to the bit.
TEST(ClosedLoop, PartsExactlyOverItsOwnStart) {
    for (const int over : {0, 1, 4, 12}) {
        SCOPED_TRACE(over);
        SurfaceMesh mesh = cubeSphere(8);
        Loop loop;
        loop.axis = Vec3(-0.54, -0.36, -0.76).normalized();
        loop.eye = -3.4 * loop.axis;
        loop.across = loop.axis.unitOrthogonal();
        loop.radius = 0.25;
        loop.length = 3;
        constexpr int kRound = 88;
        Stroke stroke;
        for (int i = 0; i <= kRound + over; ++i) {
            const double turned = 2 * M_PI * (i % kRound) / kRound;
            stroke.push_back(bladeAt(loop, Vec3::Zero(), turned, 0));
        }
        Cutter cutter(mesh, CutSettings{});
        const CutCheck check = runStroke(cutter, mesh, stroke);
        EXPECT_EQ(check.problem, "");
        EXPECT_EQ(check.refused, 0) << check.reason;
        EXPECT_EQ(findPieces(mesh).pieces.size(), 2);
    }
}

// It parts nothing, so past its start the blade finds nothing to cut.
TEST(ClosedLoop, AShallowOneLeavesNoSlitBesideIt) {
    constexpr double kRound = 0.014;
    constexpr double kSide = 0.005;
    for (const int over : {5, 10, 20, 30, 57}) {
        SCOPED_TRACE(std::to_string(over) + " degrees");
        SurfaceMesh mesh = test::box(Vec3::Constant(24 * kSide), 24);
        Stroke stroke;
        for (int degrees = 0; degrees <= 360 + over; ++degrees) {
            const double turn = degrees * M_PI / 180;
            const Vec3 at(kRound * std::cos(turn), 12 * kSide, kRound * std::sin(turn));
            stroke.push_back({at - Vec3(0, kSide, 0), at + Vec3(0, 6 * kSide, 0)});
        }
        Cutter cutter(mesh, CutSettings{});
        EXPECT_EQ(runStroke(cutter, mesh, stroke).problem, "");
        int walls = 0;
        double farthest = 0;
        for (const int t : livingTriangles(mesh)) {
            for (const int v : mesh.triangle(t)) {
                if (mesh.kind(t) == SurfaceKind::wall) {
                    const Vec3& x = mesh.restPosition(v);
                    farthest = std::max(farthest, std::abs(std::hypot(x.x(), x.z()) - kRound));
                    ++walls;
                }
            }
        }
        EXPECT_GT(walls, 100);
        EXPECT_LT(farthest, 0.2 * kSide);
    }
}

}  // namespace
}  // namespace kerf
