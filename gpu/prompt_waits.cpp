#include "gpu/prompt_waits.h"

#include <dlfcn.h>
#include <pthread.h>
#include <sched.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <system_error>

// The functions of the C library by which threads wait for each other, in front of the library's
// own: what the program defines comes first for each library in it, drivers included. POSIX lets a
// wait end without a reason, so who waits looks again at what it waits for.

namespace kerf::gpu {

namespace {

using Clock = std::chrono::steady_clock;

/// How long a thread lets others run before it sleeps.
constexpr std::chrono::microseconds kAwake{300};
/// Who lets others run and has to wait so long is in a crowd: other programs want the processors.
/// There a thread that is woken comes first, one that is awake last.
constexpr std::chrono::microseconds kCrowded{1000};
/// How long all then wait asleep.
constexpr std::chrono::milliseconds kCrowdStays{100};

std::atomic<Clock::rep> crowdedUntil = 0;  ///< of Clock
std::atomic<int> promptWaits = 0;          ///< how many there are
/// Of all conditions: one may wake others' waits too early, which is harmless.
std::atomic<unsigned> signals = 0;
/// What the thread waited for in vain, awake. It sleeps in its next wait for that: only then has it
/// looked again, under the mutex, at what it waits for.
thread_local pthread_cond_t* waitedFor = nullptr;
/// Whether this thread has a PromptWaits. What it wakes all threads by then are kernels to run.
thread_local bool launches = false;
/// Whether it runs kernels. Only then does nothing of this program keep it from running for long.
thread_local bool computes = false;
/// What threads wait for that run kernels.
std::atomic<pthread_cond_t*> kernelsCame = nullptr;
std::atomic<unsigned> placed = 0;  ///< how many of them have a processor

template <class F>
F* libraryOwn(const char* name) {
    return reinterpret_cast<F*>(dlsym(RTLD_NEXT, name));
}

/// Puts the threads that run kernels on a processor each. Awake, they are never moved to one that
/// only a waiting thread uses.
void placeOnce() {
    if (std::exchange(computes, true)) {
        return;
    }
    const std::vector<int> places = processors();
    if (!places.empty()) {
        moveThread(0, places[placed++ % places.size()]);
    }
}

bool signalled(unsigned before) {
    return signals.load() != before;
}

bool isCrowded() {
    return Clock::now().time_since_epoch().count() < crowdedUntil.load();
}

/// Whether a signal came.
bool waitAwake(unsigned before) {
    const Clock::time_point start = Clock::now();
    Clock::time_point now = start;
    while (!signalled(before) && now - start < kAwake && promptWaits.load() > 0) {
        const Clock::time_point turn = now;
        sched_yield();
        now = Clock::now();
        if (computes && now - turn > kCrowded) {
            crowdedUntil = (now + kCrowdStays).time_since_epoch().count();
        }
    }
    return signalled(before);
}

}  // namespace

PromptWaits::PromptWaits(bool needed) : needed_(needed) {
    promptWaits += needed_ ? 1 : 0;
    launches = needed_;
}

PromptWaits::~PromptWaits() {
    promptWaits -= needed_ ? 1 : 0;
    launches = false;
}

}  // namespace kerf::gpu

extern "C" {

int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex) {
    using namespace kerf::gpu;
    static auto* const sleep = libraryOwn<decltype(pthread_cond_wait)>("pthread_cond_wait");
    if (promptWaits.load() == 0 || waitedFor == condition || isCrowded()) {
        waitedFor = nullptr;
        return sleep(condition, mutex);
    }
    if (condition == kernelsCame.load()) {
        placeOnce();
    }
    const unsigned before = signals.load();
    pthread_mutex_unlock(mutex);
    waitedFor = waitAwake(before) ? nullptr : condition;
    return pthread_mutex_lock(mutex);
}

int pthread_cond_signal(pthread_cond_t* condition) {
    static auto* const signal =
        kerf::gpu::libraryOwn<decltype(pthread_cond_signal)>("pthread_cond_signal");
    ++kerf::gpu::signals;
    return signal(condition);
}

int pthread_cond_broadcast(pthread_cond_t* condition) {
    static auto* const broadcast =
        kerf::gpu::libraryOwn<decltype(pthread_cond_broadcast)>("pthread_cond_broadcast");
    if (kerf::gpu::launches) {
        kerf::gpu::kernelsCame = condition;
    }
    ++kerf::gpu::signals;
    return broadcast(condition);
}
}

namespace kerf::gpu {

std::vector<int> processors() {
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    std::vector<int> numbers;
    if (sched_getaffinity(0, sizeof(allowed), &allowed) == 0) {
        for (int number = 0; number < CPU_SETSIZE; ++number) {
            if (CPU_ISSET(number, &allowed)) {
                numbers.push_back(number);
            }
        }
    }
    return numbers;
}

void moveThread(pid_t thread, int processor) {
    cpu_set_t own;
    CPU_ZERO(&own);
    CPU_SET(processor, &own);
    sched_setaffinity(thread, sizeof(own), &own);
}

namespace {

/// The threads of llvmpipe in this process, by their names, "llvmpipe-0" and so on.
std::map<std::string, pid_t> driverThreads() {
    constexpr std::string_view kName = "llvmpipe-";
    std::map<std::string, pid_t> threads;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", error)) {
        std::ifstream file(entry.path() / "comm");
        std::string name;
        if (std::getline(file, name) && name.starts_with(kName)) {
            threads[name] = static_cast<pid_t>(std::stol(entry.path().filename().string()));
        }
    }
    return threads;
}

}  // namespace

void spreadDriverThreads() {
    const std::vector<int> places = processors();
    const std::map<std::string, pid_t> threads = driverThreads();
    if (threads.size() < 2 || threads.size() != places.size()) {
        return;
    }
    auto place = places.begin();
    for (const auto& [name, thread] : threads) {
        moveThread(thread, *place++);
    }
}

}  // namespace kerf::gpu
