// The real-time factor of the scenes of the start page: simulated time over time of the clock, of
// the steps alone, without drawing. Each is cut across its middle while time is paused, and falls.
//
//   kerf_realtime_bench [SCENE]... [--set NAME=VALUE]... [--runs N] [--seconds S] [--most SECONDS]
//
// A scene is its name or the path of a session; without any, all seven. --set changes a parameter
// of all of them, as in `kerf replay`. A run simulates S (0.1) seconds, and ends earlier after so
// many (8) of the clock. The load is that of the machine over the last minute, this program
// included.

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/files/import/model_source.h"
#include "app/session/cut_report.h"
#include "app/session/headless_session.h"
#include "app/session/real_time_factor.h"
#include "bench/timing.h"
#include "gpu/context.h"
#include "gpu/data_path.h"
#include "sim/base/stopwatch.h"

namespace kerf {
namespace {

constexpr int kStrokeSteps = 20;

struct Options {
    std::vector<std::string> scenes;
    std::vector<std::pair<std::string, std::string>> params;
    int runs = 3;
    double seconds = 0.1;  ///< simulated in a run
    double most = 8;       ///< of the clock in a run
};

Options readOptions(int count, char** words) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (!word.starts_with("--")) {
            options.scenes.push_back(word);
            continue;
        }
        const std::string value = i + 1 < count ? words[++i] : "";
        if (word == "--set" && value.find('=') != std::string::npos) {
            const std::size_t equals = value.find('=');
            options.params.emplace_back(value.substr(0, equals), value.substr(equals + 1));
        } else if (word == "--runs" && std::atoi(value.c_str()) > 0) {
            options.runs = std::atoi(value.c_str());
        } else if (word == "--seconds" && std::atof(value.c_str()) > 0) {
            options.seconds = std::atof(value.c_str());
        } else if (word == "--most" && std::atof(value.c_str()) > 0) {
            options.most = std::atof(value.c_str());
        } else {
            throw std::invalid_argument(word + ": there is no such option, or not with this value");
        }
    }
    if (options.scenes.empty()) {
        options.scenes = {"citrus", "banana", "octopus", "liver", "jelly", "egg", "cloth"};
    }
    return options;
}

/// What a run shows.
struct Run {
    double factor = 0;
    double worstFactor = 0;  ///< of its steps
    double stepMs = 0;       ///< mean
    double iterations = 0;   ///< median
    int triangles = 0;       ///< after the cut
    int pieces = 0;
    bool closed = true;      ///< after every step
    double volumeRatio = 1;  ///< the one that is farthest from 1
    int refusedCuts = 0;     ///< steps of the stroke
    double simulatedSeconds = 0;
};

/// The blade in step i of a stroke down through the body, across its longer side. A little beside
/// the middle, so that it meets no row of vertices.
Blade bladeAt(const Bounds& bounds, int i) {
    constexpr double kBeside = 0.013;  // of that side
    const Vec3 size = bounds.high - bounds.low;
    const int along = size.x() >= size.z() ? 0 : 2;
    const int across = 2 - along;
    Vec3 from = bounds.center();
    from[along] += kBeside * size[along];
    from.y() = bounds.high.y() + 0.1 * size.y() - 1.2 * size.y() * i / (kStrokeSteps - 1);
    Vec3 to = from;
    from[across] = bounds.low[across] - 0.1 * size[across];
    to[across] = bounds.high[across] + 0.1 * size[across];
    return {from, to};
}

/// The stroke with time paused; then time runs.
void cutInTwo(app::HeadlessSession& play, Run& run) {
    Simulation& simulation = play.simulation();
    const Bounds bounds = simulation.bounds();
    play.execute(SetTime{false});
    for (int i = 0; i < kStrokeSteps; ++i) {
        play.execute(MoveBlade{bladeAt(bounds, i)});
        run.closed = play.step().closed && run.closed;
    }
    play.execute(LiftBlade{});
    run.closed = play.step().closed && run.closed;
    for (const StrokeRecord& stroke : simulation.strokes()) {
        run.refusedCuts += stroke.refusedSteps;
    }
    play.execute(SetTime{true});
}

void fall(app::HeadlessSession& play, const Options& options, Run& run) {
    std::vector<double> iterations;
    double ms = 0;
    constexpr double kRounding = 1e-9;  // of the sum of time steps [s]
    while (run.simulatedSeconds < options.seconds - kRounding && ms < 1000 * options.most) {
        const Stopwatch watch;
        const StepReport& report = play.step();
        const double stepMs = watch.milliseconds();
        const double simulated = app::secondsOfStep(play.simulation());
        const double factor = app::realTimeFactor(simulated, stepMs).value_or(0);
        run.worstFactor = iterations.empty() ? factor : std::min(run.worstFactor, factor);
        ms += stepMs;
        run.simulatedSeconds += simulated;
        iterations.push_back(report.iterations);
        run.closed = run.closed && report.closed;
        if (std::abs(report.volumeRatio - 1) > std::abs(run.volumeRatio - 1)) {
            run.volumeRatio = report.volumeRatio;
        }
    }
    run.factor = app::realTimeFactor(run.simulatedSeconds, ms).value_or(0);
    run.stepMs = ms / static_cast<double>(iterations.size());
    run.iterations = median(iterations);
    run.triangles = play.simulation().report().triangles;
    run.pieces = play.simulation().report().pieces;
}

Run playOnce(const app::Session& session, const app::ModelMesh& model, const Options& options) {
    app::HeadlessSession play(session, model, 0, render::Quality::light);
    Run run;
    cutInTwo(play, run);
    fall(play, options, run);
    return run;
}

double loadOfMachine() {
    double load = 0;
    return ::getloadavg(&load, 1) == 1 ? load : 0;
}

void bench(const std::string& scene, const Options& options) {
    constexpr const char* kEnding = ".kerf.json";
    app::Session session = app::readSession(scene.ends_with(kEnding)
                                                ? std::filesystem::path(scene)
                                                : gpu::dataPath("assets/start/" + scene + kEnding));
    for (const auto& [name, value] : options.params) {
        app::setParamFromText(session.params, name, value);
    }
    const app::ModelMesh model = app::loadSessionModel(session);
    std::vector<Run> runs;
    runs.reserve(options.runs);
    for (int i = 0; i < options.runs; ++i) {
        runs.push_back(playOnce(session, model, options));
    }
    std::ranges::sort(runs, {}, &Run::factor);
    const Run& middle = runs[runs.size() / 2];
    const nlohmann::ordered_json line = {{"name", "realtime/" + scene},
                                         {"real_time_factor", middle.factor},
                                         {"least", runs.front().factor},
                                         {"most", runs.back().factor},
                                         {"worst_step", middle.worstFactor},
                                         {"step_ms", middle.stepMs},
                                         {"time_step", session.params.timeStep},
                                         {"iterations", middle.iterations},
                                         {"simulated_seconds", middle.simulatedSeconds},
                                         {"triangles", middle.triangles},
                                         {"pieces", middle.pieces},
                                         {"closed", middle.closed},
                                         {"volume_ratio_worst", middle.volumeRatio},
                                         {"refused_cuts", middle.refusedCuts},
                                         {"runs", options.runs},
                                         {"load", loadOfMachine()}};
    std::puts(line.dump().c_str());
    std::fflush(stdout);
}

/// The steps alone. What else shares the time of the machine in the window is measured beside it.
void benchSteps(const Options& options) {
    for (const std::string& scene : options.scenes) {
        bench(scene, options);
    }
}

}  // namespace
}  // namespace kerf

int main(int count, char** words) {
    try {
        const kerf::Options options = kerf::readOptions(count, words);
        const kerf::gpu::EglContext context;
        kerf::benchSteps(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
