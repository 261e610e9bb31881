#include "app/scene/timeline/saved_session.h"

#include "sim/base/text.h"

namespace kerf::app {
namespace {

/// The numbers of events that are not saved as they were.
struct Losses {
    int renewed = 0;      ///< checks that say what was found
    int withoutHash = 0;  ///< checks
    int dropped = 0;      ///< checks
    int impossible = 0;   ///< commands
    std::size_t leftOut = 0;
};

bool operator==(const CheckEvent& a, const CheckEvent& b) {
    return a.hash == b.hash && a.pieces == b.pieces;
}

/// A check as it can hold; none where nothing is left of it.
std::optional<CheckEvent> asItHolds(const LogEntry& entry, const CheckEvent& check,
                                    Losses& losses) {
    if (entry.found) {
        losses.renewed += *entry.found == check ? 0 : 1;
        return entry.found;
    }
    if (!entry.doubtful || !check.hash) {
        return check;
    }
    ++(check.pieces ? losses.withoutHash : losses.dropped);
    return check.pieces ? std::optional(CheckEvent{std::nullopt, check.pieces}) : std::nullopt;
}

/// An event as it is saved; none where it is not.
std::optional<SessionEvent> asSaved(const LogEntry& entry, bool changed, Losses& losses) {
    if (entry.failed && changed) {
        ++losses.impossible;
        return std::nullopt;
    }
    SessionEvent event = entry.event;
    if (const auto* check = std::get_if<CheckEvent>(&entry.event.action)) {
        const std::optional<CheckEvent> now = asItHolds(entry, *check, losses);
        if (!now) {
            return std::nullopt;
        }
        event.action = *now;
    }
    return event;
}

bool isOwnCheck(const LogEntry& entry) {
    return entry.origin == LogEntry::Origin::editor &&
           std::holds_alternative<CheckEvent>(entry.event.action);
}

/// "2 checks were renewed", and so on.
std::vector<std::string> partsOf(const Losses& losses) {
    std::vector<std::string> parts;
    const auto add = [&](auto count, const char* one, const char* many) {
        if (count > 0) {
            parts.push_back(counted(count, one, many));
        }
    };
    add(losses.leftOut, "later event was dropped", "later events were dropped");
    add(losses.renewed, "check was updated", "checks were updated");
    add(losses.withoutHash, "check lost its state hash", "checks lost their state hash");
    add(losses.dropped, "check was dropped", "checks were dropped");
    add(losses.impossible, "event that was no longer possible was dropped",
        "events that were no longer possible were dropped");
    return parts;
}

std::string remarkOn(const Losses& losses, const EventLog& log) {
    const std::vector<std::string> parts = partsOf(losses);
    if (parts.empty() || !log.firstChange()) {
        return "";
    }
    return "Since you " + std::string(log.leftOut() > 0 ? "took over" : "changed it") +
           " at step " + std::to_string(*log.firstChange()) + ", " + joined(parts, ", ") + ".";
}

}  // namespace

CheckEvent corrected(CheckEvent check, const CheckDifference& difference) {
    if (difference.hash) {
        check.hash = difference.hash;
    }
    if (difference.pieces) {
        check.pieces = difference.pieces;
    }
    return check;
}

std::optional<SessionEvent> eventAsSaved(const LogEntry& entry, bool changed) {
    Losses untold;
    return asSaved(entry, changed, untold);
}

SavedSession sessionAsSaved(const Session& opened, const EventLog& log, SavedAs purpose) {
    SavedSession saved{opened, ""};
    saved.session.warnings.clear();
    saved.session.events.clear();
    Losses losses;
    losses.leftOut = log.leftOut();
    for (const LogEntry& entry : log.entries()) {
        if (purpose == SavedAs::test && isOwnCheck(entry)) {
            continue;
        }
        if (auto event = asSaved(entry, log.firstChange().has_value(), losses)) {
            saved.session.events.push_back(std::move(*event));
        }
    }
    saved.remark = remarkOn(losses, log);
    return saved;
}

}  // namespace kerf::app
