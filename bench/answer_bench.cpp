// How long a person waits for an answer, by the size of the model, headless: the pointer moves ten
// times a second, whatever the editor is doing, and each move counts from when it was made until
// the picture that heeds it. An argument is a number of triangles; without any, several are tried.

#include <glad/gl.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/editor/editor.h"
#include "app/editor/view/editor_panels.h"
#include "app/scene/editor_scene.h"
#include "bench/model_file.h"
#include "gpu/context.h"
#include "sim/base/stopwatch.h"
#include "sim/run/simulation.h"

namespace kerf {
namespace {

constexpr int kWidth = 1600;
constexpr int kHeight = 900;
constexpr double kMoveEvery = 0.1;  // [s]
constexpr double kLongest = 300;    // of what is waited for [s]
constexpr double kWatched = 5;      // of what never ends [s]

/// A person at the editor's window, whose hand never waits for it.
class Person {
  public:
    explicit Person(app::Editor& editor) : editor_(editor) {}

    void press(ui::Key key, ui::Modifiers with = {}) {
        editor_.post(ui::KeyChange{key, true, with});
        editor_.post(ui::KeyChange{key, false, with});
    }
    void button(ui::Button button, bool down) { editor_.post(ui::ButtonChange{button, down, {}}); }
    void pointAt(const Vec2& at) {
        at_ = at;
        editor_.post(ui::PointerMove{at.x(), at.y(), {}});
    }

    /// Goes on moving until `done`, each time by `move`. Returns how long that took [s].
    double moveUntil(const std::function<bool()>& done, const std::function<Vec2()>& move) {
        answers_.clear();
        longestPicture_ = 0;
        const Stopwatch watch;
        double nextMove = 0;
        while (!done() && watch.seconds() < kLongest) {
            std::vector<double> made;
            for (; nextMove <= watch.seconds(); nextMove += kMoveEvery) {
                made.push_back(nextMove);
                pointAt(move());
            }
            picture();
            for (const double moment : made) {
                answers_.push_back(watch.seconds() - moment);
            }
        }
        return watch.seconds();
    }

    /// How long answers took since moveUntil() began: median and longest [ms].
    double median() { return ranked(0.5); }
    double longest() { return ranked(1); }
    /// How long the window did not look at its input meanwhile, at most [ms].
    double blocked() const { return 1000 * longestPicture_; }

    /// One picture, as the window makes it.
    void picture() {
        const Stopwatch watch;
        editor_.frame(sinceLast_.restart());
        glFinish();
        longestPicture_ = std::max(longestPicture_, watch.seconds());
        if (editor_.idleSeconds() > 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    }

  private:
    double ranked(double share) {
        std::ranges::sort(answers_);
        const auto last = static_cast<double>(answers_.size()) - 1;
        return answers_.empty() ? 0 : 1000 * answers_[static_cast<std::size_t>(share * last)];
    }

    app::Editor& editor_;
    Vec2 at_{kWidth / 2.0, kHeight / 2.0};
    std::vector<double> answers_;  // [s]
    double longestPicture_ = 0;    // since moveUntil() began [s]
    Stopwatch sinceLast_;
};

class AnswerBench {
  public:
    explicit AnswerBench(int triangles)
        : triangles_(triangles),
          file_("kerf_answer_bench", triangles),
          editor_(options(), app::openDocument(app::startSession("citrus"))) {}

    void run() {
        open();
        hover();
        turn();
        place();
        strokeAtRest();
        undo();
        redo();
        undo();
        fall();
        goBack();
    }

  private:
    static app::EditorOptions options() {
        app::EditorOptions options;
        options.width = kWidth;
        options.height = kHeight;
        options.quality = render::Quality::light;
        return options;
    }

    void print(const char* what, double seconds) {
        const nlohmann::ordered_json line = {{"name", std::string("answer/") + what},
                                             {"triangles", triangles_},
                                             {"seconds", seconds},
                                             {"median", person_.median()},
                                             {"longest", person_.longest()},
                                             {"blocked", person_.blocked()},
                                             {"unit", "ms"}};
        std::puts(line.dump().c_str());
        std::fflush(stdout);
    }

    /// A pointer that wanders about the middle.
    Vec2 wander() {
        angle_ += 0.3;
        return {kWidth * (0.5 + 0.05 * std::cos(angle_)),
                kHeight * (0.5 + 0.05 * std::sin(angle_))};
    }
    double watchFor(double seconds) {
        const Stopwatch watch;
        return person_.moveUntil([&] { return watch.seconds() > seconds; },
                                 [&] { return wander(); });
    }

    void open() {
        editor_.open(file_.path);
        print("open",
              person_.moveUntil([&] { return !editor_.working(); }, [&] { return wander(); }));
        person_.picture();
    }
    void hover() { print("hover", watchFor(kWatched)); }
    void turn() {
        person_.button(ui::Button::right, true);
        print("turn", watchFor(kWatched));
        person_.button(ui::Button::right, false);
        person_.picture();
    }
    /// From the top of the view to its bottom within a second, then on until it is cut.
    void strokeAtRest() {
        const Vec2 top(0.5 * kWidth, 0.06 * kHeight);
        person_.pointAt(top);
        person_.picture();
        person_.button(ui::Button::left, true);
        double drawn = 0;
        bool lifted = false;
        const double seconds = person_.moveUntil(
            [&] { return lifted && !editor_.scene()->running(); },
            [&] {
                drawn = std::min(drawn + kMoveEvery, 1.0);
                if (drawn >= 1 && !lifted) {
                    lifted = true;
                    person_.pointAt(top + Vec2(0, 0.88 * kHeight));
                    person_.button(ui::Button::left, false);
                }
                return lifted ? wander() : Vec2(top + Vec2(0, drawn * 0.88 * kHeight));
            });
        print("stroke", seconds);
        std::fprintf(stderr, "%s\n", editor_.title().c_str());
    }
    void undo() {
        person_.press(ui::Key::z, {.control = true});
        print("undo", untilPieces(1));
    }
    void redo() {
        person_.press(ui::Key::z, {.shift = true, .control = true});
        print("redo", untilPieces(2));
    }
    double untilPieces(int pieces) {
        return person_.moveUntil(
            [&] { return editor_.panels().pieces.rows.size() == std::size_t(pieces) && idle(); },
            [&] { return wander(); });
    }
    /// Without waiting for what the scene does, as asking it would.
    bool idle() { return !editor_.working() && editor_.idleSeconds() > 0; }
    /// Another unit, and back.
    void place() {
        for (const char* unit : {"model.unit.cm", "model.unit.m"}) {
            if (!click(unit)) {
                std::fprintf(stderr, "%s is not in view\n", unit);
                return;
            }
            print("place", person_.moveUntil([&] { return idle(); }, [&] { return wander(); }));
        }
    }
    bool click(const std::string& item) {
        if (!editor_.itemRects().contains(item)) {
            return false;
        }
        const ui::Rect rect = editor_.itemRects().at(item);
        person_.pointAt({rect.x + rect.width / 2, rect.y + rect.height / 2});
        person_.picture();
        person_.button(ui::Button::left, true);
        person_.picture();
        person_.button(ui::Button::left, false);
        person_.picture();
        return true;
    }
    /// To the start of the session, on the time line.
    void goBack() {
        if (!editor_.itemRects().contains("scrubber")) {
            std::fprintf(stderr, "the time line is not in view\n");
            return;
        }
        const ui::Rect line = editor_.itemRects().at("scrubber");
        person_.pointAt({line.x + 1, line.y + line.height / 2});
        person_.picture();
        person_.button(ui::Button::left, true);
        person_.picture();
        person_.button(ui::Button::left, false);
        print("go back", person_.moveUntil([&] { return idle(); }, [&] { return wander(); }));
        std::fprintf(stderr, "step %d\n", editor_.scene()->simulation().stepCount());
    }
    /// With gravity, and the space key at the end.
    void fall() {
        person_.press(ui::Key::space, {.shift = true});
        print("fall", watchFor(kWatched));
        person_.press(ui::Key::space);
        print("pause", person_.moveUntil([&] { return !editor_.scene()->running(); },
                                         [&] { return wander(); }));
    }

    const int triangles_;
    const bench::ModelFile file_;
    app::Editor editor_;
    Person person_{editor_};
    double angle_ = 0;
};

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
    try {
        const kerf::gpu::EglContext context;
        std::vector<int> sizes{1'000, 10'000, 100'000, 356'000, 1'300'000};
        if (argc > 1) {
            sizes = {std::atoi(argv[1])};
        }
        for (const int triangles : sizes) {
            kerf::AnswerBench(triangles).run();
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
