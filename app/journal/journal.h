#pragma once

#include <ctime>

#include "app/session/session.h"
#include "render/scene/image.h"

struct sqlite3;

namespace kerf::app {

/// Journals beyond this size are not written and not read [bytes].
inline constexpr std::uintmax_t kMaxJournalBytes = kMaxSessionBytes;

/// The work on a scene, as a journal has it: a session in parts.
struct KeptWork {
    std::string name;                 ///< of the scene
    std::string session;              ///< JSON of a session without events, with whole paths
    std::vector<std::string> events;  ///< JSON of each
    int steps = 0;
    bool unsaved = false;  ///< there is unsaved work
    std::time_t when = 0;  ///< it was done last

    /// The text of a session file.
    std::string text() const;
    /// The number of strokes, undone ones included.
    int cuts() const;
};

/// The list of what was done to a scene, on the disk: an SQLite database in WAL mode. After each
/// call it holds a whole session, whenever the program is killed. While an object lives, its file
/// is locked: one that is not was left behind. No function throws; once something has failed,
/// nothing more is written.
class Journal {
  public:
    /// A new file in `folder`, which is made if missing.
    explicit Journal(const std::filesystem::path& folder);
    /// One that was left behind; null where it belongs to a window or is none.
    static std::shared_ptr<Journal> leftBehind(const std::filesystem::path& file);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// Begins with work, in place of what was kept before.
    void begin(const KeptWork& work);
    /// Begins with a scene of that name: a session without events, and `all` of them.
    void begin(const std::string& name, const Session& session, const SessionChange& all,
               bool unsaved);
    /// Replaces the events from a position on.
    void write(const SessionChange& change, bool unsaved);
    /// Another view or other colours, and a small picture of the scene.
    void show(const Session& session, const render::Image& picture);
    /// Removes the file, and writes nothing more.
    void remove();

    /// Whether it still writes.
    bool works() const { return database_ != nullptr; }
    /// None where it holds no scene.
    std::optional<KeptWork> work() const;
    /// Null for none.
    std::shared_ptr<const render::Image> picture() const;
    const std::filesystem::path& file() const { return file_; }
    /// The sentence about what has failed, once.
    std::optional<std::string> takeProblem() { return std::exchange(problem_, std::nullopt); }

  private:
    Journal() = default;
    void open(int flags);
    void close();
    void transact(const std::function<void()>& changes);
    void replaceScene(const KeptWork& work) const;
    void put(std::size_t place, const std::string& event) const;
    void replaceEvents(const SessionChange& change) const;
    void setRest(int steps, bool unsaved, std::time_t when) const;

    std::filesystem::path file_;
    sqlite3* database_ = nullptr;  ///< null once closed, removed or failed
    std::optional<std::string> problem_;
};

/// Whether a file has the name of a journal; it need not exist.
inline bool isJournal(const std::filesystem::path& file) {
    return file.extension() == ".journal";
}
/// Reads a journal that no window has. Throws InputError if there is nothing to recover.
KeptWork readJournal(const std::filesystem::path& file);

/// Work that can be recovered. Its journal is locked meanwhile.
struct LeftWork {
    std::shared_ptr<Journal> journal;
    KeptWork kept;
    std::shared_ptr<const render::Image> picture;  ///< null for none
};

/// The most journals to keep, and for how long.
inline constexpr std::size_t kMostLeftJournals = 20;
inline constexpr int kDaysOfJournals = 30;

/// Finds the work left behind in a folder, the newest first. Removes journals without unsaved work,
/// and those beyond the number and age to keep.
std::vector<LeftWork> lookForLeftWork(const std::filesystem::path& folder);

/// $XDG_STATE_HOME/kerf/journal, by default below ~/.local/state; empty without a home.
std::filesystem::path defaultJournalFolder();

}  // namespace kerf::app
