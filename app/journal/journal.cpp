#include "app/journal/journal.h"

#include <spdlog/fmt/chrono.h>
#include <sqlite3.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <nlohmann/json.hpp>

#include "app/files/io/file_io.h"
#include "app/journal/text_journal.h"
#include "app/session/session_json.h"
#include "gpu/data_path.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int kVersion = 2;             // 1 was text
constexpr int kMostPictureSide = 1024;  // [px]
constexpr std::time_t kHour = 3600;     // [s]
constexpr int kPageBytes = 4096;
constexpr int kWait = 200;  // for somebody who looks whose the file is [ms]

// Exclusive from the first access on, and so without shared memory. In WAL mode a commit waits for
// no disk: a killed program loses nothing, a power cut at most the last seconds.
constexpr const char* kOpening = R"(
    PRAGMA locking_mode = EXCLUSIVE;
    PRAGMA synchronous = OFF;
    PRAGMA journal_mode = WAL;
    PRAGMA synchronous = NORMAL;
    CREATE TABLE IF NOT EXISTS scene (id INTEGER PRIMARY KEY, name TEXT, session TEXT,
                                      steps INTEGER, unsaved INTEGER, at INTEGER);
    CREATE TABLE IF NOT EXISTS event (place INTEGER PRIMARY KEY, text TEXT);
    CREATE TABLE IF NOT EXISTS picture (id INTEGER PRIMARY KEY, width INTEGER, height INTEGER,
                                        pixels BLOB);
)";

/// Why SQLite did not do what it should.
class Failure : public std::runtime_error {
  public:
    explicit Failure(sqlite3* database) : std::runtime_error(reasonOf(database)) {}

  private:
    static std::string reasonOf(sqlite3* database) {
        const int system = sqlite3_system_errno(database);
        const int code = sqlite3_errcode(database);
        if (code == SQLITE_FULL || system == ENOSPC || system == EDQUOT || system == EFBIG) {
            return "disk full";
        }
        return code == SQLITE_CANTOPEN && system != 0 ? std::strerror(system)
                                                      : sqlite3_errmsg(database);
    }
};

/// A statement of SQL with values for its ?.
class Statement {
  public:
    Statement(sqlite3* database, const char* sql) : database_(database) {
        require(sqlite3_prepare_v2(database, sql, -1, &statement_, nullptr));
    }
    ~Statement() { sqlite3_finalize(statement_); }
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    Statement& with(std::int64_t number) {
        require(sqlite3_bind_int64(statement_, ++bound_, number));
        return *this;
    }
    Statement& with(const std::string& text) {
        require(sqlite3_bind_text64(statement_, ++bound_, text.data(), text.size(), SQLITE_STATIC,
                                    SQLITE_UTF8));
        return *this;
    }
    Statement& with(const std::vector<std::uint8_t>& bytes) {
        require(
            sqlite3_bind_blob64(statement_, ++bound_, bytes.data(), bytes.size(), SQLITE_STATIC));
        return *this;
    }
    /// Whether there is a (further) row.
    bool step() {
        const int result = sqlite3_step(statement_);
        if (result != SQLITE_ROW && result != SQLITE_DONE) {
            throw Failure(database_);
        }
        return result == SQLITE_ROW;
    }
    std::int64_t number(int column) { return sqlite3_column_int64(statement_, column); }
    std::string text(int column) {
        const void* const bytes = sqlite3_column_blob(statement_, column);
        const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, column));
        return bytes == nullptr ? "" : std::string(static_cast<const char*>(bytes), size);
    }

  private:
    void require(int result) {
        if (result != SQLITE_OK) {
            throw Failure(database_);
        }
    }
    sqlite3* database_;
    sqlite3_stmt* statement_ = nullptr;
    int bound_ = 0;
};

void run(sqlite3* database, const char* sql) {
    if (sqlite3_exec(database, sql, nullptr, nullptr, nullptr) != SQLITE_OK) {
        throw Failure(database);
    }
}

/// By time, process and number: no two windows take the same.
std::string newName() {
    static std::atomic<int> count = 0;
    return fmt::format("{:%Y%m%d-%H%M%S}-{}-{}.journal", fmt::localtime(std::time(nullptr)),
                       ::getpid(), ++count);
}

bool isOfType(const Json& event, std::string_view type) {
    return event.is_object() && event.contains("type") && event["type"] == type;
}

}  // namespace

std::string KeptWork::text() const {
    std::string list = joined(events, ",");
    if (list.empty()) {  // Something must happen, or the editor would not play it.
        list = R"({"step":0,"type":"run"})";
    }
    Json whole = parseJson(session);
    whole.erase("events");
    whole["steps"] = std::max(1, steps);
    std::string text = whole.dump();
    text.back() = ',';  // in place of the brace
    return text + R"("events":[)" + list + "]}";
}

int KeptWork::cuts() const {
    int cuts = 0;
    bool down = false;
    for (const std::string& text : events) {
        const Json event = parseJson(text);
        const bool leads = isOfType(event, "blade");
        cuts += leads && !down ? 1 : 0;
        down = leads || (down && !isOfType(event, "lift"));
    }
    return cuts;
}

// --- Writing -----------------------------------------------------------------------------------

Journal::Journal(const fs::path& folder) : file_(folder / newName()) {
    try {
        fs::create_directories(folder);
        fs::permissions(folder, fs::perms::owner_all);
        open(SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    } catch (const fs::filesystem_error& error) {
        problem_ = "Autosave is off (" + folder.string() + ": " + error.code().message() +
                   "). Save often.";
    } catch (const Failure& failure) {
        problem_ = "Autosave is off (" + folder.string() + ": " + failure.what() + "). Save often.";
    }
}

std::shared_ptr<Journal> Journal::leftBehind(const fs::path& file) {
    std::shared_ptr<Journal> journal(new Journal);
    journal->file_ = file;
    try {
        journal->open(SQLITE_OPEN_READWRITE);
        return journal;
    } catch (const Failure&) {
        return nullptr;
    }
}

Journal::~Journal() {
    close();
}

void Journal::open(int flags) {
    sqlite3* opened = nullptr;
    try {
        if (sqlite3_open_v2(file_.c_str(), &opened, flags, nullptr) != SQLITE_OK) {
            throw Failure(opened);
        }
        sqlite3_busy_timeout(opened, kWait);
        const auto pages = static_cast<std::int64_t>(kMaxJournalBytes) / kPageBytes;
        run(opened, ("PRAGMA max_page_count = " + std::to_string(pages)).c_str());
        run(opened, kOpening);
        run(opened, ("PRAGMA user_version = " + std::to_string(kVersion)).c_str());
        database_ = opened;
    } catch (const Failure&) {
        sqlite3_close(opened);
        throw;
    }
}

void Journal::close() {
    sqlite3_close(std::exchange(database_, nullptr));
}

void Journal::remove() {
    close();
    std::error_code error;
    fs::remove(file_, error);
    fs::remove(fs::path(file_) += "-wal", error);
}

/// What has failed once is not tried again, and the list stays as it was.
void Journal::transact(const std::function<void()>& changes) {
    if (database_ == nullptr) {
        return;
    }
    try {
        run(database_, "BEGIN");
        changes();
        run(database_, "COMMIT");
    } catch (const std::exception& failure) {  // of SQLite, or of what a session can't hold
        problem_ = "Autosave has stopped (" + std::string(failure.what()) + "). Save often.";
        close();
    }
}

void Journal::put(std::size_t place, const std::string& event) const {
    Statement(database_, "INSERT INTO event VALUES (?, ?)")
        .with(static_cast<std::int64_t>(place))
        .with(event)
        .step();
}

void Journal::setRest(int steps, bool unsaved, std::time_t when) const {
    Statement(database_, "UPDATE scene SET steps = ?, unsaved = ?, at = ?")
        .with(steps)
        .with(unsaved ? 1 : 0)
        .with(when)
        .step();
}

void Journal::begin(const KeptWork& work) {
    transact([&] { replaceScene(work); });
}

void Journal::begin(const std::string& name, const Session& session, const SessionChange& all,
                    bool unsaved) {
    transact([&] {
        replaceScene({name, formatSession(session), {}, all.steps, unsaved, std::time(nullptr)});
        replaceEvents(all);
    });
}

void Journal::replaceScene(const KeptWork& work) const {
    run(database_, "DELETE FROM scene; DELETE FROM event; DELETE FROM picture");
    Statement(database_, "INSERT INTO scene (name, session) VALUES (?, ?)")
        .with(work.name)
        .with(work.session)
        .step();
    setRest(work.steps, work.unsaved, work.when);
    for (std::size_t i = 0; i < work.events.size(); ++i) {
        put(i, work.events[i]);
    }
}

void Journal::write(const SessionChange& change, bool unsaved) {
    transact([&] {
        replaceEvents(change);
        setRest(change.steps, unsaved, std::time(nullptr));
    });
}

void Journal::replaceEvents(const SessionChange& change) const {
    const auto from = static_cast<std::int64_t>(change.from);
    Statement(database_, "DELETE FROM event WHERE place >= ?").with(from).step();
    for (std::size_t i = 0; i < change.events.size(); ++i) {
        if (change.events[i]) {
            put(change.from + i, formatEvent(*change.events[i]));
        }
    }
}

void Journal::show(const Session& session, const render::Image& picture) {
    transact([&] {
        const std::string text = formatSession(session);
        Statement(database_, "UPDATE scene SET session = ?").with(text).step();
        Statement(database_, "REPLACE INTO picture VALUES (1, ?, ?, ?)")
            .with(picture.width)
            .with(picture.height)
            .with(picture.pixels)
            .step();
    });
}

// --- Reading -----------------------------------------------------------------------------------

std::optional<KeptWork> Journal::work() const {
    try {
        Statement scene(database_, "SELECT name, session, steps, unsaved, at FROM scene");
        if (!scene.step() || !Json::accept(scene.text(1))) {
            return std::nullopt;
        }
        const auto steps = std::clamp<std::int64_t>(scene.number(2), 0, kMaxSteps);
        KeptWork work{plainName(scene.text(0)), scene.text(1),        {},
                      static_cast<int>(steps),  scene.number(3) != 0, scene.number(4)};
        Statement events(database_, "SELECT text FROM event ORDER BY place");
        while (events.step()) {
            work.events.push_back(events.text(0));
        }
        return work;
    } catch (const Failure&) {
        return std::nullopt;
    }
}

std::shared_ptr<const render::Image> Journal::picture() const {
    try {
        Statement row(database_, "SELECT width, height, pixels FROM picture");
        if (!row.step()) {
            return nullptr;
        }
        const std::string pixels = row.text(2);
        const std::int64_t width = row.number(0);
        const std::int64_t height = row.number(1);
        const bool fits = std::min(width, height) > 0 &&
                          std::max(width, height) <= kMostPictureSide &&
                          pixels.size() == static_cast<std::size_t>(4 * width * height);
        return fits ? std::make_shared<const render::Image>(
                          render::Image{static_cast<int>(width),
                                        static_cast<int>(height),
                                        {pixels.begin(), pixels.end()}})
                    : nullptr;
    } catch (const Failure&) {
        return nullptr;
    }
}

KeptWork readJournal(const fs::path& file) {
    const std::shared_ptr<Journal> journal = Journal::leftBehind(file);
    const std::optional<KeptWork> work =
        journal ? journal->work() : workInText(readInputFile(file, kMaxJournalBytes));
    if (!work) {
        throw InputError(file.string() +
                         ": this is no journal that could be gone on from, or a window has it.");
    }
    return *work;
}

// --- What was left behind ----------------------------------------------------------------------

namespace {

/// Their names begin with the time: the last first.
std::vector<fs::path> journalsIn(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (isJournal(entry.path()) && entry.is_regular_file(error)) {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files, std::greater<>());
    return files;
}

/// Whether it was written so long ago that no window has just begun it.
bool isOld(const fs::path& file) {
    std::error_code error;
    const auto written = fs::last_write_time(file, error);
    return !error && fs::file_time_type::clock::now() - written > std::chrono::seconds(kHour);
}

}  // namespace

std::vector<LeftWork> lookForLeftWork(const fs::path& folder) {
    std::vector<LeftWork> works;
    const std::time_t oldest = std::time(nullptr) - 24 * kHour * kDaysOfJournals;
    for (const fs::path& file : journalsIn(folder)) {
        std::shared_ptr<Journal> journal = Journal::leftBehind(file);
        journal = journal ? journal : journalOfText(file);
        const std::optional<KeptWork> work = journal ? journal->work() : std::nullopt;
        if (work && work->unsaved && work->when >= oldest && works.size() < kMostLeftJournals) {
            works.push_back({journal, *work, journal->picture()});
        } else if (work || (journal && isOld(file))) {
            journal->remove();
        }
    }
    return works;
}

fs::path defaultJournalFolder() {
    return gpu::statePath("journal");
}

}  // namespace kerf::app
