#include "gpu/context.h"

#include <dlfcn.h>
#include <pthread.h>
#include <sched.h>
#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <latch>
#include <mutex>

#include "gpu/buffer.h"
#include "gpu/framebuffer.h"
#include "gpu/program.h"
#include "gpu/prompt_waits.h"
#include "gpu/timer.h"
#include "gpu/traffic.h"

namespace kerf::gpu {
namespace {

class Context : public GlTest {};

TEST_F(Context, IsOpenGl45Core) {
    GLint major = 0;
    GLint minor = 0;
    GLint profile = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_GE(major * 10 + minor, 45);
    EXPECT_EQ(profile & GL_CONTEXT_CORE_PROFILE_BIT, GL_CONTEXT_CORE_PROFILE_BIT);
}

TEST_F(Context, DescribesItsDevice) {
    const DeviceInfo info = queryDevice();
    EXPECT_FALSE(info.vendor.empty());
    EXPECT_FALSE(info.version.empty());
    EXPECT_GE(info.maxSamples, 4);
    EXPECT_EQ(info.software, info.renderer.find("llvmpipe") != std::string::npos);
}

TEST_F(Context, AsksForRobustAccess) {
    if (!queryDevice().software) {
        GTEST_SKIP() << "this driver may not offer it";
    }
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    EXPECT_EQ(flags & GL_CONTEXT_FLAG_ROBUST_ACCESS_BIT, GL_CONTEXT_FLAG_ROBUST_ACCESS_BIT);
}

TEST_F(Context, CountsTheErrorsOfTheDriver) {
    glEnable(GL_TEXTURE_2D);  // not a capability of the core profile
    EXPECT_EQ(takeDebugErrors(), 1);
    EXPECT_EQ(takeDebugErrors(), 0);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
}

TEST_F(Context, WhatAnotherMadeVisibleIsNotVisibleHere) {
    const auto barriers = [] {
        const std::uint64_t before = traffic().barriers;
        updateBarrier();
        return traffic().barriers - before;
    };
    barriers();
    EXPECT_EQ(barriers(), 0U) << "no kernel ran";
    EglContext second;
    EXPECT_EQ(barriers(), 1U);
    GlTest::SetUp();
    EXPECT_EQ(barriers(), 1U);
}

TEST_F(Context, SecondOneLeavesTheFirstUsable) {
    GLuint buffer = 0;
    glCreateBuffers(1, &buffer);
    {
        const EglContext second;
        EXPECT_EQ(glIsBuffer(buffer), GL_FALSE) << "contexts share nothing";
    }
    GlTest::SetUp();
    EXPECT_EQ(glIsBuffer(buffer), GL_TRUE);
    glDeleteBuffers(1, &buffer);
}

TEST(ContextFailure, SaysThatItIsSwitchedOff) {
    setenv("KERF_FORCE_NO_GL", "1", 1);
    try {
        const EglContext context;
        FAIL() << "made a context";
    } catch (const ContextError& error) {
        EXPECT_STREQ(error.what(),
                     "No OpenGL 4.5 context: it is switched off by KERF_FORCE_NO_GL; unset that "
                     "variable.");
    }
    unsetenv("KERF_FORCE_NO_GL");
}

TEST(ContextFailure, LoadingWithoutAContextIsRefused) {
    EXPECT_THROW(loadFunctions([](const char*) -> void (*)() { return nullptr; }), ContextError);
    const EglContext loadsThemAgain;
}

/// Where threads with these names may run once the driver's threads are spread.
std::vector<cpu_set_t> spread(const std::vector<std::string>& names) {
    std::vector<cpu_set_t> places(names.size());
    std::latch named(static_cast<std::ptrdiff_t>(names.size()) + 1);
    std::latch isSpread(1);
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < names.size(); ++i) {
        threads.emplace_back([&, i] {
            pthread_setname_np(pthread_self(), names[i].c_str());
            named.arrive_and_wait();
            isSpread.wait();
            sched_getaffinity(0, sizeof(places[i]), &places[i]);
        });
    }
    named.arrive_and_wait();
    spreadDriverThreads();
    isSpread.count_down();
    threads.clear();
    return places;
}

std::vector<std::string> namesOf(int count) {
    std::vector<std::string> names;
    names.reserve(count);
    for (int i = 0; i < count; ++i) {
        names.push_back("llvmpipe-" + std::to_string(i));
    }
    return names;
}

int processorCount() {
    cpu_set_t all;
    sched_getaffinity(0, sizeof(all), &all);
    return CPU_COUNT(&all);
}

TEST(DriverThreads, HaveAProcessorEach) {
    const int count = processorCount();
    if (count < 2) {
        GTEST_SKIP() << "one processor";
    }
    const std::vector<cpu_set_t> places = spread(namesOf(count));
    cpu_set_t all;
    CPU_ZERO(&all);
    for (const cpu_set_t& place : places) {
        EXPECT_EQ(CPU_COUNT(&place), 1);
        CPU_OR(&all, &all, &place);
    }
    EXPECT_EQ(CPU_COUNT(&all), count);
}

TEST(DriverThreads, StayWhereTheyAreWhereThereAreFewerOrOthers) {
    const int count = processorCount();
    for (const std::vector<std::string>& names :
         {namesOf(1), std::vector<std::string>(count, "worker")}) {
        for (const cpu_set_t& place : spread(names)) {
            EXPECT_EQ(CPU_COUNT(&place), count);
        }
    }
}

class TimerTest : public GlTest {
  protected:
    /// GPU work that takes longer than the clock's step.
    static void work() {
        const Program program = Program::compute(
            std::string(KERF_SOURCE_DIR) + "/tests/gpu/shaders/scale.comp", {{"OFFSET", "1u"}});
        Buffer values;
        values.resize(kCount * sizeof(std::uint32_t));
        values.bindStorage(0);
        program.set("count", kCount);
        program.dispatch(kCount);
    }

    static constexpr std::uint32_t kCount = 1 << 18;
};

TEST_F(TimerTest, MeasuresComputeWork) {
    Timer timer;
    timer.begin();
    work();
    timer.end();
    EXPECT_GT(timer.takeMilliseconds(), 0.0);
}

/// llvmpipe takes timestamps with the picture: they would be alike here.
TEST_F(TimerTest, MeasuresComputeWorkWhileAPictureIsDrawn) {
    const Framebuffer picture(GL_RGBA8, GL_DEPTH_COMPONENT24, 256, 256);
    picture.bind();
    ComputeTimer timer;
    work();  // compiles
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    timer.begin();
    work();
    timer.end();
    glFinish();
    const std::chrono::duration<double, std::milli> all = std::chrono::steady_clock::now() - start;
    const double measured = timer.takeMilliseconds();
    EXPECT_GT(measured, 0.2 * all.count());
    EXPECT_EQ(timer.takeMilliseconds(), 0.0);
}

TEST_F(TimerTest, TakeStartsAnew) {
    Timer timer;
    EXPECT_EQ(timer.takeMilliseconds(), 0.0);
    timer.begin();
    work();
    timer.end();
    timer.begin();
    timer.end();
    timer.takeMilliseconds();
    EXPECT_EQ(timer.takeMilliseconds(), 0.0);
}

/// Threads that pass a token round, each waiting for its turn. It never ends if a signal is lost.
class Ring {
  public:
    explicit Ring(int threads) : threads_(threads) {}

    /// How often the token went on until it had gone round so often.
    int turn(int rounds) {
        std::vector<std::jthread> threads;
        threads.reserve(threads_);
        for (int own = 0; own < threads_; ++own) {
            threads.emplace_back([this, own, rounds] {
                for (int i = 0; i < rounds; ++i) {
                    passOn(own);
                }
            });
        }
        threads.clear();
        return passed_;
    }

  private:
    void passOn(int own) {
        std::unique_lock lock(mutex_);
        turn_.wait(lock, [&] { return passed_ % threads_ == own; });
        ++passed_;
        // Some signal without the mutex, as POSIX allows.
        if (own % 2 == 0) {
            lock.unlock();
        }
        turn_.notify_all();
    }

    int threads_;
    int passed_ = 0;
    std::mutex mutex_;
    std::condition_variable turn_;
};

/// The state of a thread of this process, as in /proc: R runs, S sleeps.
char stateOf(pid_t thread) {
    std::ifstream file("/proc/self/task/" + std::to_string(thread) + "/stat");
    std::string text;
    std::getline(file, text);
    const std::size_t behindName = text.rfind(") ");
    return behindName == std::string::npos ? '?' : text[behindName + 2];
}

// Else drivers would wait by the library's own, asleep, and only a clock would tell.
TEST(PromptWaits, ComeBeforeTheLibrarysOwn) {
    for (const char* name :
         {"pthread_cond_wait", "pthread_cond_signal", "pthread_cond_broadcast"}) {
        Dl_info found{};
        ASSERT_NE(dladdr(dlsym(RTLD_DEFAULT, name), &found), 0) << name;
        Dl_info own{};
        ASSERT_NE(dladdr(reinterpret_cast<void*>(&stateOf), &own), 0);
        EXPECT_EQ(found.dli_fbase, own.dli_fbase) << name;
    }
}

TEST(PromptWaits, LoseNoSignal) {
    const PromptWaits prompt(true);
    EXPECT_EQ(Ring(2).turn(20000), 40000);
    EXPECT_EQ(Ring(5).turn(2000), 10000);
}

TEST(PromptWaits, LoseNoSignalWhereTheyComeAndGo) {
    std::atomic<bool> done = false;
    const std::jthread other([&] {
        while (!done) {
            const PromptWaits prompt(true);
            std::this_thread::yield();
        }
    });
    EXPECT_EQ(Ring(3).turn(5000), 15000);
    done = true;
}

TEST(PromptWaits, SleepWhereNobodySignals) {
    const PromptWaits prompt(true);
    std::mutex mutex;
    std::condition_variable over;
    bool isOver = false;
    std::atomic<pid_t> thread = 0;
    const std::jthread waiting([&] {
        std::unique_lock lock(mutex);
        thread = gettid();
        over.wait(lock, [&] { return isOver; });
    });
    while (thread == 0 || stateOf(thread) != 'S') {
        std::this_thread::yield();
    }
    {
        const std::scoped_lock lock(mutex);
        isOver = true;
    }
    over.notify_one();
}

}  // namespace
}  // namespace kerf::gpu
