// What the panels cost in a frame at 1280x720: laying them out and drawing them, with long
// histories behind two plots and behind all of them, beside a frame of the whole editor with the
// light tier.

#include <glad/gl.h>

#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "app/editor/editor.h"
#include "bench/timing.h"
#include "gpu/context.h"
#include "gpu/data_path.h"
#include "sim/base/stopwatch.h"
#include "ui/interface.h"
#include "ui/panels/panels.h"

namespace kerf {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr int kFrames = 60;
constexpr int kValues = 100'000;  // of each curve

ui::Series longSeries() {
    ui::Series series;
    for (int i = 0; i < kValues; ++i) {
        series.add(0.005 * i, 100 + std::sin(0.01 * i) + 0.3 * std::sin(7.0 * i));
    }
    return series;
}

ui::History longHistory() {
    ui::History history;
    const ui::Series series = longSeries();
    history.readings.fill(series);
    history[ui::Reading::strainEnergy] = history[ui::Reading::lostPieces] = {};
    history.piecePercent.assign(ui::kPlottedPieces, series);
    history.marks = {{100, "cut"}, {200, "impact"}};
    return history;
}

/// Median of an update of the panels with drawing [ms].
double panelsMs(const ui::History& history, const std::vector<std::string>& plots) {
    ui::PanelModel model;
    model.name = "ball";
    model.plots.history = &history;
    model.transport.time = 0.005 * kValues;
    model.pieces.rows.resize(2);
    model.settings.plots = plots;
    ui::Interface interface(ui::Theme::dark, 1);
    const gpu::Framebuffer picture(GL_RGBA8, GL_DEPTH_COMPONENT24, kWidth, kHeight);
    std::vector<double> times;
    for (int i = 0; i < kFrames; ++i) {
        glFinish();
        const Stopwatch watch;
        interface.update({}, model, kWidth, kHeight, 1.0 / 60);
        interface.draw(picture);
        glFinish();
        times.push_back(watch.milliseconds());
    }
    return median(times);
}

/// Median of a frame of Sphere 768 at play, steps and scene included [ms].
double frameMs() {
    app::EditorOptions options;
    options.quality = render::Quality::light;
    options.byTheClock = false;
    app::Editor editor(options,
                       app::openDocument(gpu::dataPath("assets/sessions/sphere768.kerf.json")));
    editor.post(ui::KeyChange{ui::Key::space, true, {}});
    std::vector<double> times;
    for (int i = 0; i < kFrames; ++i) {
        const Stopwatch watch;
        editor.frame(1.0 / 60);
        glFinish();
        times.push_back(watch.milliseconds());
    }
    return median(times);
}

void print(const char* name, double ms) {
    const nlohmann::ordered_json json{{"name", name}, {"ours", ms}, {"unit", "ms"}};
    std::printf("%s\n", json.dump().c_str());
}

void run() {
    const gpu::EglContext context;
    const ui::History history = longHistory();
    std::vector<std::string> all;
    for (const ui::PlotKind& kind : ui::kPlots) {
        all.emplace_back(kind.id);
    }
    print("panels_two_plots_1280x720", panelsMs(history, ui::Settings{}.plots));
    print("panels_all_plots_1280x720", panelsMs(history, all));
    print("editor_frame_sphere768_1280x720", frameMs());
}

}  // namespace
}  // namespace kerf

int main() {
    try {
        kerf::run();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "kerf_panels_bench: %s\n", error.what());
        return 1;
    }
}
