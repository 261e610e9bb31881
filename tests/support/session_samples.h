#pragma once

namespace kerf::test {

/// A session of 100 steps with these keys behind the ones that every session needs.
std::string sessionWith(const std::string& more);
/// A session of 100 steps with one event.
std::string sessionWithEvent(const std::string& event);

/// A session with each key that stands beside the events.
std::string sessionWithEveryKey();
/// A session with an event of each type, and numbers that need all their digits.
std::string sessionWithEveryEvent();

/// A session that is refused.
struct BrokenSession {
    std::string name;
    std::string text;
    std::string error;  ///< how the sentence starts
};
/// One for each kind of mistake.
const std::vector<BrokenSession>& brokenSessions();

}  // namespace kerf::test
