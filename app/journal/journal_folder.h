#pragma once

#include <ctime>

#include "app/files/io/system_file.h"
#include "app/journal/journal_text.h"
#include "render/scene/image.h"

namespace kerf::app {

/// The most journals to keep, and for how long.
inline constexpr std::size_t kMostLeftJournals = 20;
inline constexpr int kDaysOfJournals = 30;

/// A journal left behind by a window that ended without being closed. Locked during its lifetime.
class LeftJournal {
  public:
    /// Locks a journal. isOurs() is false if a window has it, or if it is gone.
    explicit LeftJournal(std::filesystem::path file);

    bool isOurs() const { return ours_; }
    const std::filesystem::path& file() const { return file_; }
    /// Removes it with its picture.
    void remove();

  private:
    std::filesystem::path file_;
    Descriptor descriptor_;
    bool ours_;
};

/// Work that can be recovered.
struct LeftWork {
    std::shared_ptr<LeftJournal> journal;
    KeptWork kept;
    std::time_t when = 0;                          ///< it was done last
    std::shared_ptr<const render::Image> picture;  ///< null for none
};

/// Finds the work left behind in a folder, the newest first. Removes journals without unsaved work,
/// and those beyond the number and age to keep.
std::vector<LeftWork> lookForLeftWork(const std::filesystem::path& folder);

/// $XDG_STATE_HOME/kerf/journal, by default below ~/.local/state; empty without a home.
std::filesystem::path defaultJournalFolder();

}  // namespace kerf::app
