#include "sim/base/pausing.h"

#include <cassert>
#include <utility>

namespace kerf {

namespace {
thread_local const std::function<void()>* pauseNow = nullptr;
thread_local double pausedSoFar = 0;  // [s]
}  // namespace

void pausePoint() {
    if (pauseNow != nullptr) {
        const Stopwatch watch;
        (*pauseNow)();
        pausedSoFar += watch.seconds();
    }
}

Pauses::Pauses(std::function<void()> pause) : pause_(std::move(pause)) {
    assert(pauseNow == nullptr && "pauses of this thread have an owner");
    pauseNow = &pause_;
}

Pauses::~Pauses() {
    pauseNow = nullptr;
}

WorkWatch::WorkWatch() : pausedBefore_(pausedSoFar) {}

double WorkWatch::seconds() const {
    return watch_.seconds() - (pausedSoFar - pausedBefore_);
}

}  // namespace kerf
