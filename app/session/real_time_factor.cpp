#include "app/session/real_time_factor.h"

#include <spdlog/fmt/fmt.h>

#include <nlohmann/json.hpp>

#include "sim/base/stopwatch.h"
#include "sim/base/text.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/triangle_soup.h"
#include "sim/run/simulation.h"
#include "sim/run/start/memory_need.h"

namespace kerf::app {

namespace {

constexpr int kMostTriangles = 12'000;  // of a body that is run itself
constexpr int kBallSide = 30;           // of the ball: more than 5,000 vertices, from which on
                                        // implicit steps have more iterations
constexpr double kPressed = 0.005;      // into the floor, of the diagonal
constexpr int kWarmUp = 2;              // steps in which drivers compile
constexpr int kSteps = 20;              // that are timed, at most
constexpr double kSeconds = 0.1;        // after which no other one is begun

/// A ball that fills a box, with 12 n^2 even triangles.
SurfaceMesh ballIn(const Bounds& box, int n) {
    TriangleSoup soup;
    for (int k = 0; k < 24 * n * n; ++k) {  // corners of the squares on the sides of a cube
        const int side = k / (4 * n * n);
        const int i = k / (4 * n) % n + (k % 4 == 1 || k % 4 == 2 ? 1 : 0);
        const int j = k / 4 % n + (k % 4 >= 2 ? 1 : 0);
        Vec3 p = Vec3::Constant(n);
        p[(side + 1) % 3] = 2 * (side < 3 ? i : j) - n;
        p[(side + 2) % 3] = 2 * (side < 3 ? j : i) - n;
        p = (side < 3 ? 1 : -1) * (p * (std::numbers::pi / (4 * n))).array().tan();
        soup.positions.push_back(box.center() +
                                 0.5 * p.normalized().cwiseProduct(box.high - box.low));
        if (k % 4 == 3) {
            soup.triangles.push_back({k - 3, k - 2, k - 1});
            soup.triangles.push_back({k - 3, k - 1, k});
        }
    }
    const TriangleSoup ball = weldExactly(soup);
    return SurfaceMesh::fromTriangles(ball.positions, ball.triangles);
}

/// What a body takes that touches the floor.
RealTimeForecast measure(SurfaceMesh mesh, Params params) {
    const Bounds bounds = meshBounds(mesh);
    params.floor = bounds.low.y() + kPressed * bounds.diagonal();
    Simulation simulation(std::move(mesh), params);
    for (int i = 0; i < kWarmUp; ++i) {
        simulation.step();
    }
    RealTimeFactors factors;
    const Stopwatch all;
    for (int i = 0; i == 0 || (i < kSteps && all.seconds() < kSeconds); ++i) {
        const Stopwatch watch;
        simulation.step();
        factors.add(secondsOfStep(simulation), watch.milliseconds(), 0);
    }
    const StepReport& report = simulation.report();
    return {factors.median().value_or(0), params.timeStep, report.iterations, report.implicitSteps};
}

/// How many times as long a body takes to solve as the ball, with as many iterations. Those of
/// implicit steps read all that there is, with inverses that grow by the square of the body.
double timesAsLong(const SurfaceMesh& mesh, const Params& params) {
    const double ofBall = 12.0 * kBallSide * kBallSide;
    if (params.solver != SolverMode::implicit) {
        return mesh.triangleSlots() / ofBall;
    }
    const MemorySettings settings = memorySettings(params, false);
    return static_cast<double>(bytesOnGpu(BodySize::ofMesh(mesh), settings)) /
           static_cast<double>(bytesOnGpu(BodySize::ofTriangles(ofBall), settings));
}

}  // namespace

std::optional<double> realTimeFactor(double simulatedSeconds, double milliseconds) {
    const bool passed = simulatedSeconds > 0 && milliseconds > 0;
    return passed ? std::optional(1000 * simulatedSeconds / milliseconds) : std::nullopt;
}

double secondsOfStep(const Simulation& simulation) {
    return simulation.timeRuns() ? simulation.params().timeStep : 0;
}

void RealTimeFactors::add(double simulatedSeconds, double stepMs, double pictureMs) {
    if (const std::optional<double> factor = realTimeFactor(simulatedSeconds, stepMs)) {
        simulated_ += simulatedSeconds;
        stepMs_ += stepMs;
        pictureMs_ += pictureMs;
        ofSteps_.push_back(*factor);
    }
}

std::optional<double> RealTimeFactors::median() const {
    std::vector<double> factors = ofSteps_;
    const auto middle = factors.begin() + static_cast<std::ptrdiff_t>(factors.size() / 2);
    std::nth_element(factors.begin(), middle, factors.end());
    return factors.empty() ? std::nullopt : std::optional(*middle);
}

std::optional<double> RealTimeFactors::worst() const {
    return ofSteps_.empty() ? std::nullopt : std::optional(*std::ranges::min_element(ofSteps_));
}

std::optional<double> RealTimeFactors::withDrawing() const {
    return realTimeFactor(simulated_, stepMs_ + pictureMs_);
}

std::string RealTimeFactors::sentence() const {
    const std::optional<double> all = realTimeFactor(simulated_, stepMs_);
    if (!all) {
        return "none was simulated";
    }
    const std::string pictures =
        pictureMs_ > 0 ? ", " + factorText(*withDrawing()) + " with pictures" : "";
    return fmt::format("{:.3g} s simulated in {:.3g} s, {} real time (slowest step {}){}",
                       simulated_, stepMs_ / 1000, factorText(*all), factorText(*worst()),
                       pictures);
}

nlohmann::ordered_json toJson(const RealTimeFactors& factors) {
    using Json = nlohmann::ordered_json;
    const auto orNull = [](const std::optional<double>& x) { return x ? Json(*x) : Json(); };
    return {{"median", orNull(factors.median())},
            {"worst", orNull(factors.worst())},
            {"with_drawing", orNull(factors.withDrawing())}};
}

RealTimeForecast realTimeForecast(const SurfaceMesh& mesh, const Params& params) {
    if (mesh.triangleSlots() <= kMostTriangles) {
        return measure(mesh, params);
    }
    RealTimeForecast forecast = measure(ballIn(meshBounds(mesh), kBallSide), params);
    forecast.scale = timesAsLong(mesh, params);
    forecast.factor /= forecast.scale;
    return forecast;
}

}  // namespace kerf::app
