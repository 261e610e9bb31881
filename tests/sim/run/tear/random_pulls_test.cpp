// Random pulls until something tears, and what is left once it has come to rest.

#include <spdlog/fmt/fmt.h>

#include "sim/base/math.h"
#include "tests/support/folds.h"

namespace kerf {
namespace {

constexpr std::array kModels{"sphere768", "jelly", "liver", "banana"};
constexpr int kStepsOfPull = 200;
constexpr int kStepsTorn = 40;  // until the hand lets go
constexpr int kStepsOfRest = 200;
constexpr double kOpening = 0.02;  // edges

/// What a pull does.
struct RandomPull {
    std::string model;
    Params params;
    bool incised = false;
    Blade from, to;      ///< of the incision
    Bounds pinned;       ///< what is held
    Vec3 at, direction;  ///< where the hand pulls, and whither
    double radius = 0;
    double way = 0;  ///< [m]
    int steps = 0;   ///< that it takes
};

struct PullFigures {
    int advances = 0;
    int refused = 0;
    int chips = 0;  ///< pieces removed as debris
    // At the end:
    int intersecting = 0;  ///< pairs of triangles
    int deep = 0;          ///< with all slits opened a little: what is no rounding of closed walls
    int atRest = 0;        ///< deep ones of the shape at rest
    int folds = 0;
    int pieces = 0;
    double volume = 0;
    std::string defect;
};

std::ostream& operator<<(std::ostream& out, const PullFigures& f) {
    return out << "advances " << f.advances << ", refused " << f.refused << ", pieces " << f.pieces
               << ", chips " << f.chips << ", intersecting " << f.intersecting << ", deep "
               << f.deep << ", at rest " << f.atRest << ", folds " << f.folds << ", volume "
               << f.volume << " " << f.defect;
}

double meanEdge(const SurfaceMesh& mesh) {
    TriangleFigures figures;
    for (const int t : livingTriangles(mesh)) {
        figures.add(restCornersOf(mesh, t));
    }
    return figures.meanEdge();
}

int deepIntersections(const SurfaceMesh& mesh) {
    return static_cast<int>(selfIntersections(opened(mesh, kOpening * meanEdge(mesh))).size());
}

SurfaceMesh restShape(const SurfaceMesh& mesh) {
    SurfaceMesh rest = mesh;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        rest.setPosition(v, mesh.restPosition(v));
    }
    return rest;
}

class RandomPulls : public SimulationFixture {
  protected:
    RandomPull draw(std::uint32_t seed);
    PullFigures pull(const RandomPull& drawn);

  private:
    double number(double low, double high) {
        return std::uniform_real_distribution(low, high)(random_);
    }
    Vec3 direction() {
        std::normal_distribution<double> normal;
        return Vec3(normal(random_), normal(random_), normal(random_)).normalized();
    }
    void step(PullFigures& figures);
    void trace(const StepReport& report);

    std::mt19937 random_;
};

RandomPull RandomPulls::draw(std::uint32_t seed) {
    random_.seed(seed);
    RandomPull drawn;
    drawn.model = kModels[seed % kModels.size()];
    const SurfaceMesh mesh = builtin(drawn.model);
    const Bounds bounds = boxOf(mesh.restPositions());
    const double size = bounds.diagonal();
    const Vec3 middle = bounds.center();

    Params& params = drawn.params = weightless();
    params.iterations = 20;
    params.tearing = 1;
    params.youngsModulus = number(1e4, 1e5);
    params.toughness = params.youngsModulus * size * std::exp(number(-8, -4));
    params.tensileStrength = params.youngsModulus * number(0.15, 0.6);

    const Vec3 way = direction();
    drawn.incised = number(0, 1) < 0.6;
    const Vec3 in = direction();
    const Vec3 half = size * in.unitOrthogonal();
    const Vec3 front = middle + number(-0.1, 0.2) * size * in + 0.1 * size * direction();
    drawn.from = {front - size * in - half, front - size * in + half};
    drawn.to = {front - half, front + half};

    double most = -1e300;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (const double along = way.dot(mesh.restPosition(v)); along > most) {
            most = along;
            drawn.at = mesh.restPosition(v);
        }
    }
    const Vec3 held = middle - 0.5 * size * way;
    const Vec3 reach = Vec3::Constant(0.3 * size);
    drawn.pinned = {held - reach, held + reach};
    drawn.direction = (way + 0.7 * direction()).normalized();
    drawn.radius = number(0.1, 0.25) * size;
    drawn.way = number(0.3, 1) * size;
    drawn.steps = static_cast<int>(number(40, 160));
    return drawn;
}

void RandomPulls::step(PullFigures& figures) {
    const int before = simulation->report().pieces;
    const StepReport& report = simulation->step();
    if (!report.closed) {
        figures.defect = "not closed";
    }
    if (report.pieces + report.debris.pieces < before) {
        figures.defect = fmt::format("pieces joined in step {}", report.step);
    }
    figures.chips += report.debris.pieces;
    trace(report);
    if (report.tear && report.tear->advanced) {
        ++figures.advances;
    } else if (report.tear && !report.tear->failure.empty()) {
        ++figures.refused;
    }
}

/// KERF_FUZZ_TRACE: a line for each step that tears or fails to.
void RandomPulls::trace(const StepReport& report) {
    if (std::getenv("KERF_FUZZ_TRACE") != nullptr && report.tear &&
        (report.tear->advanced || !report.tear->failure.empty())) {
        const SurfaceMesh& mesh = simulation->mesh();
        std::cout << "step " << report.step << ": opening " << report.tear->opening << ", stress "
                  << report.tear->stress << ", intersecting " << selfIntersections(mesh).size()
                  << ", at rest " << deepIntersections(restShape(mesh)) << ", folds "
                  << foldedEdges(mesh) << " " << report.tear->failure << "\n";
    }
}

PullFigures RandomPulls::pull(const RandomPull& drawn) {
    simulation.emplace(builtin(drawn.model), drawn.params);
    PullFigures figures;
    if (drawn.incised) {
        for (int i = 0; i <= 10; ++i) {
            const double share = i / 10.0;
            simulation->execute(MoveBlade{{drawn.from.a + share * (drawn.to.a - drawn.from.a),
                                           drawn.from.b + share * (drawn.to.b - drawn.from.b)}});
            step(figures);
        }
        simulation->execute(LiftBlade{});
        step(figures);
    }
    simulation->execute(Pin{.region = drawn.pinned});
    simulation->execute(Grab{.at = drawn.at, .radius = drawn.radius});
    int left = kStepsOfPull;
    for (int i = 0; left > 0; ++i, --left) {
        const double share = std::min(1.0, static_cast<double>(i) / drawn.steps);
        const Vec3 to = drawn.at + share * drawn.way * drawn.direction;
        simulation->execute(Drag{0, to});
        step(figures);
        left = figures.advances > 0 ? std::min(left, kStepsTorn) : left;
    }
    simulation->execute(Release{});
    for (int i = 0; i < kStepsOfRest; ++i) {
        step(figures);
    }
    const SurfaceMesh& mesh = simulation->mesh();
    figures.defect += checkClosedManifold(mesh);
    figures.intersecting = static_cast<int>(selfIntersections(mesh).size());
    figures.deep = deepIntersections(mesh);
    figures.atRest = deepIntersections(restShape(mesh));
    figures.folds = foldedEdges(mesh);
    figures.pieces = simulation->report().pieces;
    figures.volume = simulation->report().volumeRatio;
    return figures;
}

TEST_F(RandomPulls, LeaveBodiesClosedAndWhole) {
    const std::uint32_t first = fuzzSeed(301);
    const int count = runs("KERF_FUZZ_RUNS", 2, 500);
    int torn = 0;
    int folded = 0;
    for (int i = 0; i < count; ++i) {
        const std::uint32_t seed = first + static_cast<std::uint32_t>(i);
        const RandomPull drawn = draw(seed);
        const PullFigures figures = pull(drawn);
        std::cout << seed << " " << drawn.model << (drawn.incised ? " incised: " : ": ") << figures
                  << std::endl;
        torn += figures.advances > 0 ? 1 : 0;
        folded += figures.folds > 0 ? 1 : 0;
        EXPECT_EQ(figures.defect, "") << seed;
        EXPECT_NEAR(figures.volume, 1, 1e-3) << seed;
    }
    EXPECT_GT(torn, count / 2);
    EXPECT_LE(folded, 1 + count / 5);
}

}  // namespace
}  // namespace kerf
