#include "gpu/prompt_waits.h"

#include <dlfcn.h>
#include <pthread.h>
#include <sched.h>

#include <atomic>
#include <utility>
#include <vector>

#include "gpu/driver_threads.h"

// The functions of the C library by which threads wait for each other, in front of the library's
// own: what the program defines comes first for each library in it, drivers included. POSIX lets a
// wait end without a reason, so who waits looks again at what it waits for.

namespace kerf::gpu {

namespace {

/// How often a thread lets others run before it sleeps.
constexpr int kTurns = 300;

std::atomic<int> promptWaits = 0;
/// Of all conditions: one may wake others' waits too early, which is harmless.
std::atomic<unsigned> signals = 0;
/// What the thread waited for in vain, awake. It sleeps in its next wait for that: only then has it
/// looked again, under the mutex, at what it waits for.
thread_local pthread_cond_t* waitedFor = nullptr;
/// Whether this thread has a PromptWaits. What it wakes all threads by then are kernels to run.
thread_local bool launches = false;
std::atomic<pthread_cond_t*> kernelsCame = nullptr;
std::atomic<unsigned> placed = 0;

template <class F>
F* libraryOwn(const char* name) {
    return reinterpret_cast<F*>(dlsym(RTLD_NEXT, name));
}

/// Puts the threads that run kernels on a processor each. Awake, they are never moved to one that
/// only a waiting thread uses.
void placeOnce() {
    thread_local bool isPlaced = false;
    if (std::exchange(isPlaced, true)) {
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

/// Whether a signal came.
bool waitAwake(unsigned before) {
    for (int turn = 0; turn < kTurns && promptWaits.load() > 0; ++turn) {
        if (signalled(before)) {
            return true;
        }
        sched_yield();
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
    if (promptWaits.load() == 0 || waitedFor == condition) {
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
