// Milliseconds of a picture of the editor at 1280x720: at play, by its parts, and of a window at
// rest. Models and light tier as an argument tells: frame_bench [full].

#include <glad/gl.h>
#include <sys/resource.h>

#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "app/editor/editor.h"
#include "app/files/import/builtin_models.h"
#include "app/session/scene_view.h"
#include "gpu/context.h"
#include "sim/base/stopwatch.h"
#include "sim/mesh/invariants.h"

namespace kerf {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr int kWarmUp = 10;
constexpr int kPictures = 60;

/// Of all threads of the process [s].
double processorSeconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return double(t.tv_sec) + 1e-6 * double(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

struct Times {
    double median = 0;     ///< [ms]
    double late = 0;       ///< nine of ten are faster [ms]
    double processor = 0;  ///< all cores together, mean [ms]
};

Times measure(const std::function<void()>& call) {
    for (int i = 0; i < kWarmUp; ++i) {
        call();
    }
    const double before = processorSeconds();
    std::vector<double> times;
    for (int i = 0; i < kPictures; ++i) {
        const Stopwatch watch;
        call();
        times.push_back(watch.milliseconds());
    }
    std::ranges::sort(times);
    return {times[times.size() / 2], times[9 * times.size() / 10],
            1000 * (processorSeconds() - before) / kPictures};
}

void print(const std::string& name, const Times& times, double goal) {
    nlohmann::ordered_json line = {{"name", "frame/" + name},
                                   {"ours", times.median},
                                   {"unit", "ms"},
                                   {"late", times.late},
                                   {"processor", times.processor}};
    if (goal > 0) {
        line["theirs"] = goal;
        line["peer"] = "the goal";
        line["ratio"] = goal / times.median;
    }
    std::puts(line.dump().c_str());
}

std::filesystem::path sessionOf(const std::string& name) {
    return app::builtinModelFile(name).parent_path().parent_path() / "sessions" /
           (name + ".kerf.json");
}

/// The body falls and lies there; a session's own strokes are left out.
app::Document fallingBody(const std::string& name) {
    app::Document document = app::openDocument(sessionOf(name));
    document.session.events.clear();
    document.session.params.gravity = Vec3(0, -9.81, 0);
    return document;
}

void benchPlay(const std::string& name, render::Quality quality, double goal) {
    app::EditorOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.quality = quality;
    app::Editor editor(options, fallingBody(name));
    editor.post(ui::KeyChange{ui::Key::space, true, {}});
    Stopwatch sinceLast;
    const Times play = measure([&] {
        editor.frame(sinceLast.restart());
        glFinish();
    });
    print(name + "/play", play, goal);

    editor.post(ui::KeyChange{ui::Key::space, true, {}});
    double x = 0;
    print(name + "/panels and overlay", measure([&] {
              // Over a panel, the scene stands still.
              editor.post(ui::PointerMove{40 + (x += 1), 400, {}});
              editor.frame(0.02);
              glFinish();
          }),
          0);
}

void benchParts(const std::string& name, render::Quality quality) {
    const app::Document document = fallingBody(name);
    Simulation simulation(document.mesh, document.session.params);
    print(name + "/step", measure([&] { simulation.step(); }), 0);
    render::Renderer renderer(quality);
    renderer.setRestShape(document.mesh);
    const render::BodyLook look = app::lookOf(document.session);
    print(name + "/scene", measure([&] {
              renderer.draw(app::sceneOf(simulation, look, document.restBounds, {}),
                            document.camera, kWidth, kHeight);
              glFinish();
          }),
          0);
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
    try {
        const kerf::gpu::EglContext context;
        const bool full = argc > 1 && std::string(argv[1]) == "full";
        const auto quality = full ? kerf::render::Quality::full : kerf::render::Quality::light;
        for (const auto& [name, goal] :
             {std::pair{"sphere768", 50.0}, std::pair{"banana", 100.0}}) {
            kerf::benchPlay(name, quality, goal);
            kerf::benchParts(name, quality);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
