#include "gpu/prompt_waits.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <fstream>
#include <mutex>
#include <thread>

namespace kerf::gpu {
namespace {

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
