#include "app/scene/timeline/session_playback.h"

#include "sim/base/text.h"

namespace kerf::app {

SessionPlayback::SessionPlayback(Session session, Of what)
    : session_(std::move(session)), what_(what), steps_(session_.steps) {}

std::string SessionPlayback::compare(const CheckEvent& check, const CheckDifference& difference,
                                     int step) {
    const bool asExpected = !difference.hash && !difference.pieces;
    if ((divergedAt_ && *divergedAt_ <= step) || asExpected) {
        return "";
    }
    divergedAt_ = step;
    const std::string what = difference.pieces ? counted(*difference.pieces, "piece", "pieces") +
                                                     " instead of " + std::to_string(*check.pieces)
                                               : "the state hash differs";
    return "At step " + std::to_string(step) + " the replay differs from the recording: " + what +
           ".";
}

}  // namespace kerf::app
