#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/files/io/system_file.h"

namespace kerf::app {

/// A journal on its way to the disk: what is added is written at once and flushed, on a thread of
/// its own. Its file is locked as long as it is written, so a journal whose lock is free was left
/// behind. The file stays, unless it is removed.
class JournalWriter {
  public:
    /// What is to be written, made on the thread; may throw.
    using Text = std::function<std::string()>;

    /// A new file in `folder`, which is made where it is missing.
    explicit JournalWriter(std::filesystem::path folder);
    /// Waits until all that was added is on the disk.
    ~JournalWriter();
    JournalWriter(const JournalWriter&) = delete;
    JournalWriter& operator=(const JournalWriter&) = delete;

    /// Appends to the journal, soon. Nothing more is written once something has failed.
    void add(Text text);
    /// Does something on the thread that may take its time, such as to write the picture beside the
    /// journal. What it throws is passed over.
    void run(std::function<void(const std::filesystem::path& journal)> work);
    /// Takes the journal away and what lies beside it, and writes nothing more.
    void remove();

    /// The sentence about what has failed, once.
    std::optional<std::string> takeProblem();
    /// Whether all that was added is on the disk.
    bool flushed() const;
    /// Whether nothing is on its way there, and no problem waits to be taken.
    bool settled() const;
    /// Whether it has been taken away.
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

/// Takes away a journal and the picture of it.
void removeJournal(const std::filesystem::path& journal);
/// The picture that lies beside a journal.
std::filesystem::path pictureOf(const std::filesystem::path& journal);

}  // namespace kerf::app
