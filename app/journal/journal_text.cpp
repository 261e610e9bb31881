#include "app/journal/journal_text.h"

#include <nlohmann/json.hpp>

#include "app/files/io/encodings.h"
#include "app/files/io/file_io.h"
#include "app/session/session_json.h"

namespace kerf::app {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;

/// What is unreadable now may be readable again, and the loading will say so if not.
std::string hashOf(const std::filesystem::path& file) {
    try {
        return sha256OfFile(file);
    } catch (const InputError&) {
        return "";
    }
}

void addHash(ModelReference& model, ModelHashes& known) {
    if (model.builtin.empty() && model.sha256.empty()) {
        const auto [row, isNew] = known.try_emplace(model.path);
        if (isNew) {
            row->second = hashOf(model.path);
        }
        model.sha256 = row->second;
    }
}

std::string onOneLine(const Session& session) {
    return Json::parse(formatSession(session)).dump();
}

std::string quoted(const std::string& text) {
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// An event as text, which takes far less memory than a parsed one, and what is asked of it.
struct KeptEvent {
    std::string text;  ///< "null" where it has only a place
    int step = 0;
    bool cuts = false;   ///< it leads the blade
    bool lifts = false;  ///< it takes the blade away
};

/// The work as it stands after each line.
class Replay {
  public:
    /// False where the line makes no sense, and none behind it does.
    bool take(const Json& line);
    bool begun() const { return !session_.empty(); }
    KeptWork end() const;

  private:
    bool begin(const Json& line);
    bool change(const Json& line);
    int cuts() const;

    std::string name_;
    std::string session_;  ///< as text, like the events
    std::vector<KeptEvent> events_;
    int steps_ = 0;
    bool unsaved_ = false;
};

/// A whole number of a line that is not below 0; none where it is something else.
std::optional<std::size_t> countIn(const Json& line, const char* key) {
    const auto found = line.find(key);
    const bool right = found != line.end() && found->is_number_unsigned();
    return right ? std::optional(found->get<std::size_t>()) : std::nullopt;
}

bool isOfType(const Json& event, std::string_view type) {
    return event.is_object() && event.contains("type") && event["type"] == type;
}

KeptEvent keptEvent(const Json& event) {
    const auto step = event.is_object() ? countIn(event, "step") : std::nullopt;
    return {event.dump(), static_cast<int>(std::min<std::size_t>(step.value_or(0), kMaxSteps)),
            isOfType(event, "blade"), isOfType(event, "lift")};
}

bool Replay::take(const Json& line) {
    if (!line.is_object()) {
        return false;
    }
    return line.contains("session") ? begin(line) : begun() && change(line);
}

bool Replay::begin(const Json& line) {
    if (!begun() && (countIn(line, "kerf_journal") != kVersion || !line.contains("name") ||
                     !line["name"].is_string())) {
        return false;
    }
    name_ = begun() ? name_ : plainName(line["name"].get<std::string>());
    const Json& session = line["session"];
    session_ = session.is_object() ? session.dump() : "";
    return begun();
}

bool Replay::change(const Json& line) {
    const auto at = countIn(line, "at");
    const auto dropped = countIn(line, "dropped");
    const auto steps = countIn(line, "steps");
    const auto added = line.find("events");
    if (!at || !dropped || !steps || *steps > kMaxSteps || *at > events_.size() ||
        *dropped > events_.size() - *at || added == line.end() || !added->is_array()) {
        return false;
    }
    const auto from = events_.begin() + static_cast<std::ptrdiff_t>(*at);
    const auto next = events_.erase(from, from + static_cast<std::ptrdiff_t>(*dropped));
    std::vector<KeptEvent> kept;
    std::ranges::transform(*added, std::back_inserter(kept), keptEvent);
    events_.insert(next, std::make_move_iterator(kept.begin()),
                   std::make_move_iterator(kept.end()));
    steps_ = static_cast<int>(*steps);
    unsaved_ = line.value("unsaved", Json(true)) != false;
    return true;
}

int Replay::cuts() const {
    int cuts = 0;
    bool down = false;
    for (const KeptEvent& event : events_) {
        cuts += event.cuts && !down ? 1 : 0;
        down = event.cuts || (down && !event.lifts);
    }
    return cuts;
}

KeptWork Replay::end() const {
    std::string events;
    int last = 1;
    for (const KeptEvent& event : events_) {
        if (event.text != "null") {
            last = std::max(last, event.step);
            events += (events.empty() ? "" : ",") + event.text;
        }
    }
    if (events.empty()) {  // Something must happen, or the editor would not play it.
        events = R"({"step":0,"type":"run"})";
    }
    Json session = Json::parse(session_);
    session.erase("events");
    session["steps"] = std::max(last, steps_);
    std::string text = session.dump();
    text.back() = ',';  // in place of the brace
    return {name_, text + R"("events":[)" + events + "]}", cuts(), unsaved_};
}

/// The lines that have an end.
std::vector<std::string_view> wholeLines(std::string_view text) {
    std::vector<std::string_view> lines;
    for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    return lines;
}

bool takes(Replay& replay, std::string_view line) {
    try {
        return replay.take(parseJson(line));
    } catch (const InputError&) {  // what a power cut left of it
        return false;
    }
}

}  // namespace

void addHashes(Session& session, ModelHashes& known) {
    addHash(session.model, known);
    for (FurtherModel& further : session.moreModels) {
        addHash(further.model, known);
    }
}

std::string journalStart(const std::string& name, const Session& session) {
    return R"({"kerf_journal":)" + std::to_string(kVersion) + R"(,"name":)" + quoted(name) +
           R"(,"session":)" + onOneLine(session) + "}\n";
}

std::string journalView(const Session& session) {
    return R"({"session":)" + onOneLine(session) + "}\n";
}

std::string journalLine(const SessionChange& change, bool unsaved) {
    std::string line = R"({"steps":)" + std::to_string(change.steps) + R"(,"unsaved":)" +
                       (unsaved ? "true" : "false") + R"(,"at":)" + std::to_string(change.at) +
                       R"(,"dropped":)" + std::to_string(change.dropped) + R"(,"events":[)";
    for (std::size_t i = 0; i < change.added.size(); ++i) {
        line += i > 0 ? "," : "";
        line += change.added[i] ? formatEvent(*change.added[i]) : "null";
    }
    return line + "]}\n";
}

KeptWork readJournal(const std::filesystem::path& file) {
    const std::string text = readInputFile(file, kMaxJournalBytes);
    Replay replay;
    for (const std::string_view line : wholeLines(text)) {
        if (!takes(replay, line)) {
            break;
        }
    }
    if (!replay.begun()) {
        throw InputError(file.string() + ": this is no journal that could be gone on from.");
    }
    return replay.end();
}

}  // namespace kerf::app
