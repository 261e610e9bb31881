#include "app/scene/session_playback.h"

#include <algorithm>
#include <iterator>

#include "sim/base/text.h"

namespace kerf::app {
namespace {

constexpr int kKeyframes = 48;                        // over a session
constexpr std::size_t kKeyframeBudget = 256'000'000;  // [bytes]

}  // namespace

SessionPlayback::SessionPlayback(const Session& session)
    : steps_(session.steps), player_(session), spacing_(std::max(1, session.steps / kKeyframes)) {}

bool SessionPlayback::wantsKeyframe(int step) const {
    return step % spacing_ == 0 && step < steps() && !keyframes_.contains(step);
}

void SessionPlayback::keep(int step, Keyframe keyframe, std::size_t bytes) {
    keyframes_.emplace(step, std::move(keyframe));
    if (bytes * keyframes_.size() > kKeyframeBudget && keyframes_.size() > 2) {
        thinOut();
    }
}

/// The first one stays: a session can always be taken up from its start.
void SessionPlayback::thinOut() {
    spacing_ *= 2;
    std::erase_if(keyframes_, [this](const auto& entry) { return entry.first % spacing_ != 0; });
}

int SessionPlayback::keyframeStepBefore(int step) const {
    const auto after = keyframes_.upper_bound(step);
    return after == keyframes_.begin() ? -1 : std::prev(after)->first;
}

const Keyframe* SessionPlayback::keyframeBefore(int step) const {
    const int found = keyframeStepBefore(step);
    return found < 0 ? nullptr : &keyframes_.at(found);
}

void SessionPlayback::changedAt(int step, std::size_t commandsDone) {
    std::erase_if(keyframes_, [&](const auto& entry) {
        return entry.first > step || entry.second.commandsDone > commandsDone;
    });
}

std::string SessionPlayback::compare(const CheckEvent& check, const CheckDifference& difference,
                                     int step) {
    const bool asExpected = !difference.hash && !difference.pieces;
    if ((divergedAt_ && *divergedAt_ <= step) || asExpected) {
        return "";
    }
    divergedAt_ = step;
    const std::string what = difference.pieces ? counted(*difference.pieces, "piece", "pieces") +
                                                     " instead of " + std::to_string(*check.pieces)
                                               : "the state hash is not the recorded one";
    return "At step " + std::to_string(step) + " the session came out differently: " + what + ".";
}

}  // namespace kerf::app
