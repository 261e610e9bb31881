// Memory and time by the size of the model, in the editor, headless: a sphere is opened from a
// file, cut right through at rest, runs a step, and the cut is taken back. Each size has a process
// of its own, since a peak never falls.
//
//   kerf_memory_bench                 10^4, 10^5 and 10^6 triangles
//   kerf_memory_bench TRIANGLES...    these
//   kerf_memory_bench --within GB...  the largest sphere whose peak stays below so many GB

#include <spdlog/spdlog.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/editor/editor.h"
#include "app/files/io/memory_means.h"
#include "app/scene/editor_scene.h"
#include "bench/model_file.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "sim/base/freed_memory.h"
#include "sim/base/stopwatch.h"
#include "sim/run/simulation.h"
#include "tests/support/buffer_bytes.h"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr double kFrameSeconds = 1.0 / 60;
constexpr double kGiga = 1e9;
constexpr char kInside[] = "--inside";  // of a process of its own

/// The most memory that this process has had at a time [bytes].
double peakOfProcess() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word == "VmHWM:") {
            double kilobytes = 0;
            status >> kilobytes;
            return 1024 * kilobytes;
        }
    }
    return 0;
}

/// One size, in this process.
class MemoryBench {
  public:
    explicit MemoryBench(int triangles)
        : file_("kerf_memory_bench" + std::to_string(::getpid()), triangles),
          editor_(options(), std::nullopt) {}

    Json run() {
        Json line = {{"name", "memory"}};
        const double opened = seconds([this] { open(); });
        if (editor_.scene() == nullptr) {
            line["refused"] = editor_.panels().toast.text;
            return line;
        }
        app::EditorScene& scene = *editor_.scene();
        const auto need = memoryNeedOf(scene.document());
        line["triangles"] = scene.simulation().report().triangles;
        line["needed_gb"] = static_cast<double>(need.memory + need.program + need.graphics) / kGiga;
        line["open_s"] = opened;
        line["opened_gb"] = peakOfProcess() / kGiga;
        line["first_cut_s"] = seconds([this] { cut(); });
        if (editor_.scene() == nullptr) {
            line["given_up"] = editor_.panels().toast.text;
            return line;
        }
        line["pieces"] = scene.simulation().report().pieces;
        line["triangles_cut"] = scene.simulation().report().triangles;
        line["step_s"] = seconds([&] { step(); });
        line["undo_s"] = seconds([this] { undo(); });
        line["pieces_after_undo"] = scene.simulation().report().pieces;
        line["peak_gb"] = peakOfProcess() / kGiga;
        line["buffers_gb"] = static_cast<double>(buffers_.most()) / kGiga;
        line["largest_buffer_gb"] = static_cast<double>(buffers_.largest()) / kGiga;
        line["ratio"] = line["needed_gb"].get<double>() / line["peak_gb"].get<double>();
        line["told"] = editor_.panels().toast.text;
        return line;
    }

  private:
    static app::EditorOptions options() {
        app::EditorOptions options;
        options.width = kWidth;
        options.height = kHeight;
        options.quality = render::Quality::light;
        options.byTheClock = false;
        return options;
    }
    template <class Work>
    static double seconds(Work&& work) {
        const Stopwatch watch;
        work();
        return watch.seconds();
    }
    // As a window does that shows each picture. Else llvmpipe keeps many that it has not drawn yet.
    void frame() {
        editor_.frame(kFrameSeconds);
        gpu::finish();
    }
    void press(ui::Key key, ui::Modifiers with = {}) {
        editor_.post(ui::KeyChange{key, true, with});
        editor_.post(ui::KeyChange{key, false, with});
        frame();
    }
    void settle() {
        do {
            frame();
        } while (editor_.scene() != nullptr && editor_.scene()->running());
    }

    void open() {
        editor_.open(file_.path);
        while (editor_.working()) {
            frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        frame();
    }
    /// From above the sphere to below it, as a quick hand does.
    void cut() {
        constexpr int kPoints = 10;
        const double x = 0.5 * kWidth;
        for (int i = 0; i <= kPoints; ++i) {
            editor_.post(ui::PointerMove{x, kHeight * (0.06 + 0.88 * i / kPoints), {}});
            if (i == 0) {
                editor_.post(ui::ButtonChange{ui::Button::left, true, {}});
            }
        }
        editor_.post(ui::ButtonChange{ui::Button::left, false, {}});
        settle();
    }
    void step() { press(ui::Key::period); }
    void undo() {
        press(ui::Key::z, {.control = true});
        settle();
    }

    const test::BufferBytes buffers_;
    const bench::ModelFile file_;
    app::Editor editor_;
};

void runInside(int triangles) {
    spdlog::set_level(spdlog::level::off);  // what is printed is one object
    keepFreedMemory();
    const gpu::EglContext context;
    std::puts(MemoryBench(triangles).run().dump().c_str());
}

/// One size in a process of its own; none where that did not come to its end.
std::optional<Json> measure(int triangles) {
    const std::string self = std::filesystem::read_symlink("/proc/self/exe");
    const std::string command = self + " " + kInside + " " + std::to_string(triangles);
    std::FILE* const pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) {
        return std::nullopt;
    }
    std::string text;
    std::array<char, 4096> block{};
    for (std::size_t count = 0; (count = std::fread(block.data(), 1, block.size(), pipe)) > 0;) {
        text.append(block.data(), count);
    }
    const int status = ::pclose(pipe);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        return std::nullopt;
    }
    return Json::parse(text);
}

void print(const Json& line) {
    std::puts(line.dump().c_str());
    std::fflush(stdout);
}

/// Peaks grow by about so much for each triangle: the next try follows from the last one.
void findLargest(double gigabytes) {
    constexpr int kTries = 5;
    constexpr double kNearEnough = 0.96;
    constexpr double kProgram = 0.3;  // [GB]
    double fits = 0;
    double tooMany = INFINITY;
    double next = 100'000 * gigabytes;
    for (int i = 0; i < kTries; ++i) {
        const std::optional<Json> result = measure(static_cast<int>(next));
        const bool ran = result && result->contains("peak_gb");
        const double peak = ran ? (*result)["peak_gb"].get<double>() : INFINITY;
        if (result) {
            Json line = *result;
            line["within_gb"] = gigabytes;
            line["fits"] = peak <= gigabytes;
            print(line);
        }
        if (peak <= gigabytes) {
            fits = std::max(fits, next);
            if (peak > kNearEnough * gigabytes) {
                return;
            }
        } else {
            tooMany = std::min(tooMany, next);
        }
        const double guess =
            ran ? next * (0.98 * gigabytes - kProgram) / (peak - kProgram) : INFINITY;
        next = guess < tooMany && guess > fits ? guess : 0.5 * (fits + tooMany);
    }
}

int run(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 2 && words[0] == kInside) {
        runInside(std::stoi(words[1]));
        return 0;
    }
    if (!words.empty() && words[0] == "--within") {
        std::for_each(words.begin() + 1, words.end(),
                      [](const std::string& word) { findLargest(std::stod(word)); });
        return 0;
    }
    std::vector<int> sizes{10'000, 100'000, 1'000'000};
    if (!words.empty()) {
        sizes.resize(words.size());
        std::ranges::transform(words, sizes.begin(), [](const auto& w) { return std::stoi(w); });
    }
    for (const int triangles : sizes) {
        const std::optional<Json> result = measure(triangles);
        print(result ? *result
                     : Json{{"name", "memory"}, {"triangles", triangles}, {"ended", false}});
    }
    return 0;
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
    try {
        return kerf::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
