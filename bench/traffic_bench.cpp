// What a step asks of the driver: dispatches, barriers, waits, bytes. These cost a GPU time however
// fast it computes, and are the same on any driver. With GALLIUM_NOOP=1, for which Mesa's drivers
// do no work, "cpu_ms" is what a step costs the processor beside a GPU; results are nonsense then.
//
//   kerf_traffic_bench [MODEL | TRIANGLES]...    all builtin models, or these, or spheres of about
//                                                so many triangles

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>

#include "app/files/import/builtin_models.h"
#include "app/files/import/model_source.h"
#include "gpu/context.h"
#include "gpu/traffic.h"
#include "sim/base/stopwatch.h"
#include "sim/mesh/invariants.h"
#include "sim/run/simulation.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

constexpr int kSteps = 20;

/// What was asked of the driver in each of some steps.
struct Count {
    std::vector<gpu::Traffic> steps;
    std::vector<double> milliseconds;
};

double mean(const Count& count, std::uint64_t gpu::Traffic::*member) {
    double sum = 0;
    for (const gpu::Traffic& step : count.steps) {
        sum += static_cast<double>(step.*member);
    }
    return sum / static_cast<double>(count.steps.size());
}

/// Waits and reads in one step, at most.
std::uint64_t mostWaits(const Count& count) {
    std::uint64_t most = 0;
    for (const gpu::Traffic& step : count.steps) {
        most = std::max(most, step.waits + step.reads);
    }
    return most;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// `before` is called before each step with its number.
Count countSteps(Simulation& simulation, int steps, const std::function<void(int)>& before) {
    Count count;
    for (int i = 0; i < steps; ++i) {
        const gpu::Traffic start = gpu::traffic();
        const Stopwatch watch;
        before(i);
        simulation.step();
        count.milliseconds.push_back(watch.milliseconds());
        count.steps.push_back(gpu::traffic() - start);
    }
    return count;
}

Count countSteps(Simulation& simulation, int steps = kSteps) {
    constexpr int kWarmUp = 3;
    for (int i = 0; i < kWarmUp; ++i) {
        simulation.step();
    }
    return countSteps(simulation, steps, [](int) {});
}

void print(const std::string& scene, const Count& count) {
    using gpu::Traffic;
    const nlohmann::ordered_json line = {
        {"name", "traffic/" + scene},
        {"dispatches", mean(count, &Traffic::dispatches)},
        {"indirect", mean(count, &Traffic::indirect)},
        {"barriers", mean(count, &Traffic::barriers)},
        {"waits", mean(count, &Traffic::waits)},
        {"reads", mean(count, &Traffic::reads)},
        {"most_waits_and_reads", mostWaits(count)},
        {"bytes_up", std::round(mean(count, &Traffic::bytesUp))},
        {"bytes_down", std::round(mean(count, &Traffic::bytesDown))},
        {"cpu_ms", median(count.milliseconds)}};
    std::puts(line.dump().c_str());
    std::fflush(stdout);
}

Params weightless() {
    Params params;
    params.gravity = Vec3::Zero();
    params.floor.reset();
    return params;
}

Params falling() {
    Params params;
    params.floor.reset();
    return params;
}

/// The blade in step i of a stroke right through the body, along y, at this share of its width.
Blade bladeAt(const Bounds& bounds, int i, int steps, double share) {
    const Vec3 size = bounds.high - bounds.low;
    const double y = bounds.high.y() + 0.1 * size.y() - 1.2 * size.y() * i / (steps - 1);
    const double x = bounds.low.x() + share * size.x();
    return {Vec3(x, y, bounds.low.z() - 0.1 * size.z()),
            Vec3(x, y, bounds.high.z() + 0.1 * size.z())};
}

Count countStroke(Simulation& simulation, const Bounds& bounds, double share) {
    const Count count = countSteps(simulation, kSteps, [&](int i) {
        simulation.execute(MoveBlade{bladeAt(bounds, i, kSteps, share)});
    });
    simulation.execute(LiftBlade{});
    simulation.step();
    return count;
}

/// Steps until one asks for nothing; so many where it does not come to that.
int stepsUntilAsleep(Simulation& simulation) {
    constexpr int kMost = 8000;
    int steps = 0;
    while (steps < kMost && countSteps(simulation, 1, [](int) {}).steps[0].dispatches > 0) {
        ++steps;
    }
    return steps;
}

/// Falls from a tenth of its size, and is left alone until it sleeps.
void countAsleep(const std::string& name, const std::function<SurfaceMesh()>& model) {
    const Bounds bounds = meshBounds(model());
    Params params;
    params.sleeps = 1;
    params.floor = bounds.low.y() - 0.1 * bounds.diagonal();
    Simulation simulation(model(), params);
    const int steps = stepsUntilAsleep(simulation);
    print(name + "/lies on the floor for " + std::to_string(steps) + " steps",
          countSteps(simulation));
}

void countModel(const std::string& name, const std::function<SurfaceMesh()>& model) {
    const Bounds bounds = meshBounds(model());
    {
        Simulation simulation(model(), weightless());
        print(name + "/rests", countSteps(simulation));
        print(name + "/cut at rest", countStroke(simulation, bounds, 0.5));
    }
    {
        Simulation simulation(model(), falling());
        print(name + "/falls", countSteps(simulation));
    }
    {
        Params params;
        params.floor = bounds.low.y();
        Simulation simulation(model(), params);
        print(name + "/lies on the floor", countSteps(simulation));
        print(name + "/cut on the floor", countStroke(simulation, bounds, 0.5));
        print(name + "/two halves on the floor", countSteps(simulation));
    }
    countAsleep(name, model);
}

/// Slices that fall, to see whether their number changes what is asked for.
void countPieces(const std::string& name, const std::function<SurfaceMesh()>& model) {
    const Bounds bounds = meshBounds(model());
    Params params = weightless();
    params.contact = 0;
    for (const int wanted : {1, 2, 4, 8}) {
        Simulation simulation(model(), params);
        for (int i = 1; i < wanted; ++i) {
            countStroke(simulation, bounds, static_cast<double>(i) / wanted);
        }
        simulation.execute(SetParam{"gravity", falling().gravity});
        print(name + "/" + std::to_string(simulation.report().pieces) + " slices fall",
              countSteps(simulation));
    }
}

void countAll(int count, char** words) {
    if (count == 1) {
        for (const std::string& name : app::builtinModels()) {
            countModel(name, [&] { return app::loadModel(app::builtinModelFile(name)); });
        }
        countPieces("sphere768", [] { return app::loadModel(app::builtinModelFile("sphere768")); });
    }
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (std::ranges::count(app::builtinModels(), word) > 0) {
            countModel(word, [&] { return app::loadModel(app::builtinModelFile(word)); });
            continue;
        }
        const auto side = static_cast<int>(std::lround(std::sqrt(std::atof(words[i]) / 12)));
        const auto sphere = [&] { return test::cubeSphere(std::max(1, side)); };
        countModel("sphere of " + std::to_string(12 * side * side), sphere);
    }
}

}  // namespace
}  // namespace kerf

int main(int count, char** words) {
    try {
        const kerf::gpu::EglContext context;
        kerf::countAll(count, words);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
