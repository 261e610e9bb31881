// The editor for a long time: random strokes, undo, resets, files and sizes of the window. Memory
// and objects of OpenGL stay, the mesh stays sound, and no frame takes long.
//
//   KERF_SOAK_MINUTES=45 build/kerf_app_tests --gtest_filter='EditorSoak*'
//
// Without that variable, a few rounds of acts. KERF_FUZZ_SEED sets the acts.
#include <malloc.h>

#include <ctime>

#include "sim/base/freed_memory.h"
#include "sim/base/stopwatch.h"
#include "tests/app/editor/editor_storm.h"

namespace kerf::app {
namespace {

/// How many objects of OpenGL the current context has, whoever made them.
struct GlObjects {
    int buffers = 0;
    int textures = 0;
    int framebuffers = 0;
    int vertexArrays = 0;
    int programs = 0;
    int queries = 0;

    /// Without queries: timers keep as many as a picture once had substeps.
    int lasting() const { return buffers + textures + framebuffers + vertexArrays + programs; }
};

/// Names from 1 on, until none has been taken for long. Mesa gives each new object a name beyond
/// all others, so they are looked for at least up to a fresh one.
template <class IsTaken, class Generate, class Delete>
int countNames(IsTaken isTaken, Generate generate, Delete remove) {
    constexpr GLuint kLongestGap = 4096;
    GLuint fresh = 0;
    generate(1, &fresh);
    remove(1, &fresh);
    int count = 0;
    for (GLuint name = 1, last = fresh; name < last || name - last <= kLongestGap; ++name) {
        if (isTaken(name) == GL_TRUE) {
            ++count;
            last = std::max(last, name);
        }
    }
    return count;
}

/// Counts them by their names, which drivers give out in ascending order and anew.
GlObjects countGlObjects() {
    const auto generateProgram = [](GLsizei, GLuint* name) { *name = glCreateProgram(); };
    const auto deleteProgram = [](GLsizei, const GLuint* name) { glDeleteProgram(*name); };
    return {countNames(glIsBuffer, glGenBuffers, glDeleteBuffers),
            countNames(glIsTexture, glGenTextures, glDeleteTextures),
            countNames(glIsFramebuffer, glGenFramebuffers, glDeleteFramebuffers),
            countNames(glIsVertexArray, glGenVertexArrays, glDeleteVertexArrays),
            countNames(glIsProgram, generateProgram, deleteProgram),
            countNames(glIsQuery, glGenQueries, glDeleteQueries)};
}

constexpr double kWarmUpMinutes = 10;  // until all kernels are there and the heap has its size
constexpr double kMostGrowth = 1.05;
constexpr double kMostGrowthCold = 1.25;  // in a run that is shorter than that
constexpr double kLongestFrame = 2;       // [s]
constexpr int kActsOfRound = 30;
constexpr std::size_t kLeastRounds = 3;

double minutesWanted() {
    const char* text = std::getenv("KERF_SOAK_MINUTES");
    return text == nullptr ? 0 : std::atof(text);
}

/// Of all threads of this process [s].
double processorSeconds() {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Resident memory of this process [MB].
double residentMegabytes() {
    std::ifstream file("/proc/self/statm");
    double total = 0;
    double resident = 0;
    file >> total >> resident;
    return 1e-6 * resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// Memory that this process has asked for and not given back [MB]; the rest of what is resident
/// the allocator keeps, or the driver's own.
double usedMegabytes() {
    const struct mallinfo2 info = ::mallinfo2();
    return 1e-6 * static_cast<double>(info.uordblks + info.hblkhd);
}

int entriesOf(const fs::path& folder) {
    const fs::directory_iterator entries(folder);
    return static_cast<int>(std::distance(begin(entries), end(entries)));
}

/// How long the window did not answer.
struct Pause {
    double seconds = 0;
    double processor = 0;  ///< time of all threads [s]
    const char* during = "";

    /// What it takes where no other process has the cores, at most.
    double ownSeconds() const { return std::min(seconds, processor); }
};

/// The process at the end of a round, with the same model open each time.
struct Sample {
    double minutes = 0;
    double megabytes = 0;
    double used = 0;  ///< of these, by what asked for them [MB]
    GlObjects objects;
    int files = 0;
    int threads = 0;
    int journals = 0;
};

/// What a run counts between two rows of its table.
struct Row {
    int acts = 0;
    int frames = 0;
    Pause longest;
};

class EditorSoak : public EditorStorm {
  protected:
    EditorOptions options() override {
        EditorOptions options = EditorStorm::options();
        options.byTheClock = true;
        options.settingsFile = folder / "settings.json";
        options.recentFiles = folder / "recent";
        options.journals = folder / "journals";
        return options;
    }

    /// As the window's loop does: what the scene does goes on until a picture is due.
    void frame() override {
        while (timed([this] { return editor->workOn(); })) {
        }
        timed([this] {
            editor->frame(sinceFrame_.restart());
            gpu::finish();  // as where a window shows it
            return true;
        });
        ++row_.frames;
    }
    template <class Work>
    bool timed(Work work) {
        const Stopwatch watch;
        const double before = processorSeconds();
        const bool more = work();
        const Pause pause{watch.seconds(), processorSeconds() - before, during_};
        if (pause.ownSeconds() > row_.longest.ownSeconds()) {
            row_.longest = pause;
        }
        return more;
    }

    void act() {
        const Act act = actFor(panels());
        SCOPED_TRACE(act.name);
        during_ = act.name;
        (this->*act.act)();
        frames(2);
        expectSound();
        ++row_.acts;
        ++acts_;
    }
    /// Opens the same model again in the same size, plain, and looks at the process once it rests.
    Sample endOfRound() {
        during_ = "end of a round";
        editor->post(ui::FocusLost{});
        editor->resize(640, 360);
        width_ = 640;
        height_ = 360;
        editor->setScale(1);
        for (int i = 0; i < 6; ++i) {
            tap(Key::escape);
        }
        waitForWork();
        open(folder / "ball.obj");
        if (panels().display.quality == render::Quality::full) {
            tap(Key::q);  // its pictures take 25 MB more
        }
        for (int i = 0; i < 600 && editor->idleSeconds() < 1; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            frame();
        }
        EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece") << panels().toast.text;
        expectSound();
        return {sinceStart_.seconds() / 60,
                residentMegabytes(),
                usedMegabytes(),
                countGlObjects(),
                entriesOf("/proc/self/fd"),
                entriesOf("/proc/self/task"),
                entriesOf(folder / "journals")};
    }

    static void printHead() {
        std::puts(
            "minute  acts  frames  memory [MB]  used [MB]  buffers textures framebuffers arrays "
            "programs "
            "queries  files threads journals  longest frame [s]  processor [s]  during");
    }
    void printRow(const Sample& s) {
        const GlObjects& o = s.objects;
        std::printf(
            "%6.1f %5d %7d %12.1f %10.1f %8d %8d %12d %6d %8d %7d %6d %7d %8d %18.2f %14.2f  %s\n",
            s.minutes, row_.acts, row_.frames, s.megabytes, s.used, o.buffers, o.textures,
            o.framebuffers, o.vertexArrays, o.programs, o.queries, s.files, s.threads, s.journals,
            row_.longest.seconds, row_.longest.processor, row_.longest.during);
        std::fflush(stdout);
    }

    void soak(double minutes) {
        const double rowMinutes = std::min(1.0, minutes / 10);
        double nextRow = 0;
        printHead();
        sinceStart_.restart();
        while (samples_.size() < kLeastRounds || sinceStart_.seconds() < 60 * minutes) {
            for (int i = 0; i < kActsOfRound && !HasFatalFailure(); ++i) {
                act();
            }
            samples_.push_back(endOfRound());
            if (HasFatalFailure()) {
                return;
            }
            if (row_.longest.ownSeconds() > longest_.ownSeconds()) {
                longest_ = row_.longest;
            }
            if (samples_.back().minutes >= nextRow) {
                printRow(samples_.back());
                nextRow = samples_.back().minutes + rowMinutes;
                row_ = {};
            }
        }
    }

    /// Compares the first quarter of the samples with the last one. Those of the warm-up count only
    /// where a run is no longer than that.
    void expectNoGrowth() {
        const bool warm = minutesWanted() > kWarmUpMinutes;
        const auto first = std::ranges::find_if(
            samples_, [warm](const Sample& s) { return !warm || s.minutes > kWarmUpMinutes; });
        const std::span<const Sample> judged(first, samples_.end());
        const std::size_t quarter = (judged.size() + 3) / 4;
        const auto grown = [&](auto value) {
            const auto meanOf = [&](std::span<const Sample> some) {
                double sum = 0;
                for (const Sample& each : some) {
                    sum += value(each);
                }
                return sum / static_cast<double>(some.size());
            };
            return meanOf(judged.last(quarter)) / meanOf(judged.first(quarter));
        };
        const double memory = grown([](const Sample& s) { return s.megabytes; });
        const double used = grown([](const Sample& s) { return s.used; });
        const double objects = grown([](const Sample& s) { return s.objects.lasting(); });
        const double files = grown([](const Sample& s) { return s.files; });
        const double threads = grown([](const Sample& s) { return s.threads; });
        std::printf(
            "%zu samples; last quarter over first: memory %.3f, used %.3f, OpenGL objects %.3f, "
            "files %.3f, threads %.3f\n",
            judged.size(), memory, used, objects, files, threads);
        const double most = warm ? kMostGrowth : kMostGrowthCold;
        EXPECT_LT(memory, most);
        EXPECT_LT(objects, most);
        EXPECT_LT(files, most);
        EXPECT_LT(threads, most);
    }

    Stopwatch sinceStart_;
    Stopwatch sinceFrame_;
    std::vector<Sample> samples_;
    Row row_;
    Pause longest_;
    const char* during_ = "start";
    int acts_ = 0;
};

// There it would take a bookmark of the dialog, and what is saved then lies in somebody's folder.
TEST_F(EditorSoak, ClicksOnNothingThatLiesUnderAFileDialog) {
    tap(Key::s, {.control = true}, 2);
    const ui::Rect bookmark = editor->itemRects().at("file.place.Current folder");
    for (int i = 0; i < 500; ++i) {
        const std::optional<Vec2> at = someItem();
        ASSERT_TRUE(at);
        EXPECT_FALSE(at->x() >= bookmark.x && at->x() < bookmark.x + bookmark.width &&
                     at->y() >= bookmark.y && at->y() < bookmark.y + 8 * bookmark.height);
    }
}

TEST_F(EditorSoak, MemoryAndObjectsStayTheMeshIsSoundAndNoFrameTakesLong) {
    keepFreedMemory();
    random_.seed(fuzzSeed(20261124));
    writeFiles();
    dropped_.push_back(builtinModelFile("banana"));
    soak(minutesWanted());
    std::printf("longest frame: %.2f s, of the processor %.2f s, during %s\n", longest_.seconds,
                longest_.processor, longest_.during);
    EXPECT_LT(longest_.ownSeconds(), kLongestFrame) << longest_.during;
    expectNoGrowth();
}

}  // namespace
}  // namespace kerf::app
