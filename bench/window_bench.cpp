// What the time of the clock goes to in the window, while a scene of the start page falls that was
// cut across its middle with the pointer. Needs a display.
//
//   kerf_window_bench [SCENE]...
//
// Without names citrus alone.

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>

#include "app/editor/editor.h"
#include "app/scene/editor_scene.h"
#include "app/scene/editor_stroke.h"
#include "app/window/editor_run.h"
#include "app/window/window.h"
#include "gpu/context.h"
#include "gpu/data_path.h"
#include "sim/base/stopwatch.h"

namespace kerf {
namespace {

using ui::Reading;

constexpr double kSettles = 3;   // before it is measured [s]
constexpr double kMeasured = 8;  // [s]
constexpr double kMost = 120;    // for opening and cutting [s]

/// Sums of a run so far.
struct Sums {
    double steps = 0;      ///< stages of steps [ms]
    double frames = 0;     ///< all of the clock [ms]
    double simulated = 0;  ///< [s]
    double pictures = 0;
};

Sums sumsOf(const ui::PanelModel& model) {
    const ui::History& history = *model.plots.history;
    const auto sum = [&](Reading reading) { return history[reading].sum(); };
    const double mean = history[Reading::frameMs].mean();
    return {sum(Reading::deformMs) + sum(Reading::collideMs) + sum(Reading::cutMs) +
                sum(Reading::otherMs),
            sum(Reading::frameMs), model.transport.time,
            mean > 0 ? sum(Reading::frameMs) / mean : 0};
}

/// The window with a scene in it.
class Play {
  public:
    explicit Play(const std::string& scene) : editor_(optionsFor(window_), std::nullopt) {
        window_.onInput([this](ui::InputEvent event) { editor_.post(std::move(event)); });
        editor_.open(gpu::dataPath("assets/start/" + scene + ".kerf.json"));
        until([this] { return editor_.scene() != nullptr && !editor_.working(); });
    }

    void cut() {
        constexpr int kMoves = 30;
        const double x = 0.5013 * window_.width();
        editor_.post(ui::PointerMove{x, 0.12 * window_.height(), {}});
        editor_.post(ui::ButtonChange{ui::Button::left, true, {}});
        for (int i = 0; i <= kMoves; ++i) {
            editor_.post(ui::PointerMove{x, (0.12 + 0.78 * i / kMoves) * window_.height(), {}});
        }
        editor_.post(ui::ButtonChange{ui::Button::left, false, {}});
        lastFor(0.5);
        until([this] { return editor_.scene()->stroke().pending() == 0; });
    }
    void tap(ui::Key key) {
        editor_.post(ui::KeyChange{key, true, {.shift = true}});
        editor_.post(ui::KeyChange{key, false, {}});
    }
    void lastFor(double seconds) {
        const Stopwatch watch;
        app::runLoop(window_, editor_, [&] { return watch.seconds() > seconds; });
    }
    const ui::PanelModel& panels() const { return editor_.panels(); }

  private:
    static app::EditorOptions optionsFor(const app::Window& window) {
        app::EditorOptions options;
        options.width = window.width();
        options.height = window.height();
        const bool software = gpu::queryDevice().software;
        options.quality = software ? render::Quality::light : render::Quality::full;
        return options;
    }
    template <class Done>
    void until(const Done& done) {
        const Stopwatch watch;
        app::runLoop(window_, editor_, [&] { return done() || watch.seconds() > kMost; });
    }

    app::Window window_{"Kerf", ui::WindowPlace{0, 0, 1440, 785, false}};
    app::Editor editor_;
};

void bench(const std::string& scene) {
    Play play(scene);
    play.cut();
    play.tap(ui::Key::space);
    play.lastFor(kSettles);
    const Sums before = sumsOf(play.panels());
    play.lastFor(kMeasured);
    const Sums after = sumsOf(play.panels());
    double load = 0;
    ::getloadavg(&load, 1);
    const double seconds = 0.001 * (after.frames - before.frames);
    const nlohmann::ordered_json line = {
        {"name", "window/" + scene},
        {"share_of_steps", 0.001 * (after.steps - before.steps) / seconds},
        {"real_time_factor", (after.simulated - before.simulated) / seconds},
        {"pictures_per_second", (after.pictures - before.pictures) / seconds},
        {"seconds", seconds},
        {"load", load}};
    std::puts(line.dump().c_str());
    std::fflush(stdout);
}

}  // namespace
}  // namespace kerf

int main(int count, char** words) {
    std::vector<std::string> scenes(words + 1, words + count);
    if (scenes.empty()) {
        scenes = {"citrus"};
    }
    try {
        for (const std::string& scene : scenes) {
            kerf::bench(scene);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
