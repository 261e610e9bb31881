#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "app/files/io/system_file.h"

namespace kerf::app {

/// Writes a journal: what is added is written at once and flushed, on a separate thread. Its file
/// is locked meanwhile, so an unlocked journal was left behind. The file stays, unless it is
/// removed.
class JournalWriter {
  public:
    /// Makes the text to write, on the thread; may throw.
    using Text = std::function<std::string()>;

    /// A new file in `folder`, which is made if missing.
    explicit JournalWriter(std::filesystem::path folder);
    /// Waits until all that was added is on the disk.
    ~JournalWriter();
    JournalWriter(const JournalWriter&) = delete;
    JournalWriter& operator=(const JournalWriter&) = delete;

    /// Appends to the journal, soon. Nothing more is written once something has failed.
    void add(Text text);
    /// Runs slow work on the thread, such as writing the picture beside the journal. Ignores what
    /// it throws.
    void run(std::function<void(const std::filesystem::path& journal)> work);
    /// Removes the journal and its picture, and writes nothing more.
    void remove();

    /// The sentence about what has failed, once.
    std::optional<std::string> takeProblem();
    /// Whether all that was added is on the disk.
    bool flushed() const;
    /// Whether nothing is being written, and no problem waits to be taken.
    bool settled() const;
    /// Whether it was removed.
    bool removed() const;
    /// Where the journal is, or will be.
    const std::filesystem::path& file() const { return file_; }

  private:
    void work();
    std::string textOf(std::deque<Text> texts);
    void append(const std::string& text);
    void begin();
    void fail(const std::string& reason);

    std::filesystem::path file_;
    std::filesystem::path hidden_;  ///< its name until the first lines are on the disk

    // On the thread alone.
    std::unique_ptr<SystemFile> out_;
    std::uintmax_t bytes_ = 0;

    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Text> texts_;
    std::deque<std::function<void(const std::filesystem::path&)>> works_;
    std::optional<std::string> problem_;
    bool busy_ = false;
    bool failed_ = false;
    bool removed_ = false;
    bool ends_ = false;
    bool gone_ = false;
    std::thread thread_;  ///< last: it uses all the others
};

/// Removes a journal and its picture.
void removeJournal(const std::filesystem::path& journal);
/// The picture beside a journal.
std::filesystem::path pictureOf(const std::filesystem::path& journal);

}  // namespace kerf::app
