#pragma once

namespace kerf::app {

/// Files by key in a folder of their own, which may be deleted at any time. Beyond a budget those
/// that were used longest ago are removed. Damaged ones are not found.
class FileCache {
  public:
    /// `budget` [bytes]. An empty path keeps nothing.
    explicit FileCache(std::filesystem::path folder, std::uintmax_t budget = kBudget)
        : folder_(std::move(folder)), budget_(budget) {}

    /// Keeps bytes under a key, a file name.
    void keep(const std::string& key, const std::vector<std::byte>& bytes) const;
    std::optional<std::vector<std::byte>> find(const std::string& key) const;

  private:
    static constexpr std::uintmax_t kBudget = 2'000'000'000;  // [bytes]
    void keepToBudget() const;

    std::filesystem::path folder_;
    std::uintmax_t budget_;
};

/// The state at the end of a saved session, from which it reopens without being played.
struct StoredEnd {
    std::vector<std::byte> checkpoint;  ///< see bytesOf()
    int startStep = 0;                  ///< what the panels count from, see CountStart
    double startTime = 0;               ///< the same [s]

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(checkpoint, startStep, startTime);
    }
};

/// The ends of the sessions that this program saved with this driver, by their content: a session
/// that was edited, moved to another machine or saved by another build has none, and is played.
class StoredEnds {
  public:
    /// An empty folder keeps none. `driver`: its full name.
    StoredEnds(std::filesystem::path folder, std::string driver)
        : cache_(std::move(folder)), driver_(std::move(driver)) {}

    /// Keeps the end of the session that a file holds. On any thread.
    void keep(const std::filesystem::path& session, const StoredEnd& end) const;
    /// The end of that session; none if unknown. On any thread.
    std::optional<StoredEnd> of(const std::filesystem::path& session) const;

  private:
    std::string keyOf(const std::filesystem::path& session) const;

    FileCache cache_;
    std::string driver_;
};

/// $XDG_CACHE_HOME/kerf/ends, by default in ~/.cache; empty where there is no home.
std::filesystem::path defaultStoredEnds();

}  // namespace kerf::app
