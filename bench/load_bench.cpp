// How the editor answers while a large model is opened behind what is open, headless: frames of the
// view being turned, before and meanwhile, and one that goes back to the start. An argument is the
// number of triangles, else a million.

#include <glad/gl.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/editor/editor.h"
#include "app/editor/view/editor_panels.h"
#include "bench/model_file.h"
#include "gpu/context.h"
#include "sim/base/stopwatch.h"

namespace kerf {
namespace {

constexpr int kOrdinaryFrames = 30;
constexpr int kWidth = 1280;
constexpr int kHeight = 720;

/// Turns the view by a drag of the right button that never ends.
class Turning {
  public:
    explicit Turning(app::Editor& editor) : editor_(editor) {
        editor.post(ui::PointerMove{kWidth / 2.0, kHeight / 2.0, {}});
        editor.post(ui::ButtonChange{ui::Button::right, true, {}});
    }
    /// Milliseconds of the next frame, until the GPU is done with it.
    double frame() {
        step_ = (step_ + 1) % 40;
        editor_.post(ui::PointerMove{kWidth / 2.0 + 5 * step_, kHeight / 2.0, {}});
        const Stopwatch watch;
        editor_.frame(1.0 / 60);
        glFinish();
        return watch.milliseconds();
    }

  private:
    app::Editor& editor_;
    int step_ = 0;
};

std::vector<double> sortedFrames(Turning& turning, int count) {
    std::vector<double> times(count);
    std::ranges::generate(times, [&] { return turning.frame(); });
    std::ranges::sort(times);
    return times;
}

void print(const char* name, double ours, double theirs, const char* peer) {
    const nlohmann::ordered_json line = {{"name", name},           {"ours", ours},
                                         {"theirs", theirs},       {"peer", peer},
                                         {"ratio", theirs / ours}, {"unit", "ms"}};
    std::puts(line.dump().c_str());
}

void benchLoading(int triangles) {
    const bench::ModelFile file("kerf_load_bench", triangles);
    app::EditorOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.quality = render::Quality::light;
    app::Editor editor(options, app::openDocument(app::startSession("citrus")));
    Turning turning(editor);
    sortedFrames(turning, 5);  // to warm up
    const double ordinary = sortedFrames(turning, kOrdinaryFrames)[kOrdinaryFrames / 2];

    const Stopwatch watch;
    editor.open(file.path);
    std::vector<double> frames;
    while (editor.working()) {
        frames.push_back(turning.frame());
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    const double total = watch.milliseconds();
    const double first = frames.back();  // the new model's first picture
    frames.pop_back();
    std::ranges::sort(frames);
    Turning turningAgain(editor);  // the new model took the view from the first
    const double after = sortedFrames(turningAgain, 5)[2];
    const char* const peer = "a frame before, median";
    print("load/median frame meanwhile", frames[frames.size() / 2], ordinary, peer);
    print("load/longest frame meanwhile", frames.back(), ordinary, peer);
    print("load/first frame of the new model", first, after, "a later frame of it, median");
    print("load/all", total, ordinary, peer);

    editor.post(ui::KeyChange{ui::Key::r, true, {}});
    editor.post(ui::KeyChange{ui::Key::r, false, {}});
    print("load/frame that goes back to the start", turningAgain.frame(), first,
          "the first frame of the new model");
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
    try {
        const kerf::gpu::EglContext context;
        kerf::benchLoading(argc > 1 ? std::atoi(argv[1]) : 1'000'000);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
