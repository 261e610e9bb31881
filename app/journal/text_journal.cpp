#include "app/journal/text_journal.h"

#include <fcntl.h>
#include <spdlog/spdlog.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "app/files/io/file_io.h"
#include "app/files/io/system_file.h"
#include "app/session/session_json.h"

namespace kerf::app {
namespace {

using Json = nlohmann::json;

/// A whole number of a line that is not below 0; none where it is something else.
std::optional<std::size_t> countIn(const Json& line, const char* key) {
    const auto found = line.find(key);
    const bool right = found != line.end() && found->is_number_unsigned();
    return right ? std::optional(found->get<std::size_t>()) : std::nullopt;
}

/// The first line, or one that gives another view.
bool begin(KeptWork& work, const Json& line) {
    const Json& session = line["session"];
    if (work.session.empty()) {
        const Json name = line.value("name", Json());
        if (countIn(line, "kerf_journal") != 1 || !name.is_string()) {
            return false;
        }
        work.name = plainName(name.get<std::string>());
    }
    work.session = session.is_object() ? session.dump() : "";
    return session.is_object();
}

/// A line of events in place of others.
bool change(KeptWork& work, const Json& line) {
    const auto at = countIn(line, "at");
    const auto dropped = countIn(line, "dropped");
    const auto steps = countIn(line, "steps");
    const Json added = line.value("events", Json());
    if (work.session.empty() || !at || !dropped || !steps || *steps > kMaxSteps ||
        *at > work.events.size() || *dropped > work.events.size() - *at || !added.is_array()) {
        return false;
    }
    const auto from = work.events.begin() + static_cast<std::ptrdiff_t>(*at);
    const auto next = work.events.erase(from, from + static_cast<std::ptrdiff_t>(*dropped));
    std::vector<std::string> texts;
    std::ranges::transform(added, std::back_inserter(texts),
                           [](const Json& event) { return event.dump(); });
    work.events.insert(next, texts.begin(), texts.end());
    work.steps = static_cast<int>(*steps);
    work.unsaved = line.value("unsaved", Json(true)) != false;
    return true;
}

/// False where the line makes no sense, and none behind it does.
bool take(KeptWork& work, std::string_view text) {
    try {
        const Json line = parseJson(text);
        return line.is_object() &&
               (line.contains("session") ? begin(work, line) : change(work, line));
    } catch (const InputError&) {  // what a power cut left of it
        return false;
    }
}

}  // namespace

std::optional<KeptWork> workInText(std::string_view text) {
    KeptWork work;
    for (std::size_t end = 0; (end = text.find('\n')) != std::string_view::npos;
         text.remove_prefix(end + 1)) {
        if (!take(work, text.substr(0, end))) {
            break;
        }
    }
    std::erase(work.events, "null");  // had a place only
    return work.session.empty() ? std::nullopt : std::optional(std::move(work));
}

std::shared_ptr<Journal> journalOfText(const std::filesystem::path& file) {
    const Descriptor held(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat status {};
    if (held.get() < 0 || ::flock(held.get(), LOCK_EX | LOCK_NB) != 0 ||
        ::fstat(held.get(), &status) != 0) {
        return nullptr;
    }
    try {
        std::optional<KeptWork> work = workInText(readInputFile(file, kMaxJournalBytes));
        if (!work) {
            return nullptr;
        }
        work->when = status.st_mtime;
        auto journal = std::make_shared<Journal>(file.parent_path());
        journal->begin(*work);
        if (const auto problem = journal->takeProblem()) {
            spdlog::warn("{}: {}", file.string(), *problem);
            return nullptr;
        }
        std::error_code error;
        std::filesystem::remove(file, error);
        std::filesystem::remove(std::filesystem::path(file).replace_extension(".png"), error);
        return journal;
    } catch (const InputError& error) {
        spdlog::warn("{}", error.what());
        return nullptr;
    }
}

}  // namespace kerf::app
