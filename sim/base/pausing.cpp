#include "sim/base/pausing.h"

#include <cassert>
#include <exception>

namespace kerf {

namespace {
thread_local const Pauses* pausesNow = nullptr;
thread_local double pausedSoFar = 0;  // [s]
}  // namespace

void pausePoint() {
    if (pausesNow != nullptr) {
        assert(problemOfPause().empty() && "this is no place to pause");
        const Stopwatch watch;
        pausesNow->pause_();
        pausedSoFar += watch.seconds();
    }
}

std::string problemOfPause() {
    if (pausesNow == nullptr) {
        return "";
    }
    if (std::uncaught_exceptions() > 0 || std::current_exception() != nullptr) {
        return "an exception is under way";
    }
    return pausesNow->check_ ? pausesNow->check_() : "";
}

Pauses::Pauses(std::function<void()> pause, std::function<std::string()> check)
    : pause_(std::move(pause)), check_(std::move(check)) {
    assert(pausesNow == nullptr && "pauses of this thread have an owner");
    pausesNow = this;
}

Pauses::~Pauses() {
    pausesNow = nullptr;
}

WorkWatch::WorkWatch() : pausedBefore_(pausedSoFar) {}

double WorkWatch::seconds() const {
    return watch_.seconds() - (pausedSoFar - pausedBefore_);
}

}  // namespace kerf
